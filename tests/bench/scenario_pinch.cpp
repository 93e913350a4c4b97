// SPDX-License-Identifier: Apache-2.0
//
// Scenarios with a jaw on a hinge under a torque: S07 to S10.
#include <limits>

#include "coulomb.hpp"
#include "grip.hpp"

namespace swage::bench {
namespace {

/// Half the angle between the gripping faces. [rad]
double half_wedge(const Engine& e, const Pose& lower) {
  const Vec3 up = e.upper().q * Vec3::UnitZ(), low = lower.q * Vec3::UnitZ();
  return 0.5 * std::atan2(up.cross(low).norm(), up.dot(low));
}

/// What a load in one direction may reach, and how far from the axis of its turning the wire is looked at.
struct Load {
  double limit = 0;  // N or N m
  double arm = 1;    // m, or 1 for a force
};
Load load_of(const Setup& s, double grip, Pull direction, double alpha) {
  const CoulombLimits coulomb{s.friction, grip, alpha};
  const double r = s.needle.wire_radius();
  const double width = 2 * Jaw::kHalfWidth * (Jaw::kHinge + Jaw::kLength - Jaw::kGrip) / Jaw::kLength;
  if (direction == Pull::kAxial) return {coulomb.along(), 1};
  if (direction == Pull::kAboutWire) return {coulomb.about_wire(r), r};
  return {coulomb.about_normal(width), 0.5 * s.needle.length()};
}

/// How far anything of the wire has come: one that slips at one jaw alone rolls along the other.
double moved(const Slip& s, Pull direction, double arm) {
  return direction == Pull::kAxial ? std::abs(s.along) : std::max(s.turn * arm, s.distance());
}

}  // namespace

PullResult pull(const Method& method, const Setup& base_setup, double grip, Pull direction) {
  Setup setup = base_setup;
  setup.upper_driven = true;
  const auto engine = method.make(setup);
  Engine& e = *engine;
  const Openings openings(method, setup.needle, 0);
  e.set_gravity(Vec3::Zero());
  openings.apply(e, Pose{}, true);
  e.set_needle(grip_pose(setup.needle), Vec3::Zero(), Vec3::Zero());
  for (int i = 0; i < 1000; ++i) {
    openings.apply(e, Pose{}, false);
    e.set_torque(grip * Jaw::kGrip * std::min(1.0, i / 500.0));
    e.step();
    if (!finite(e.needle())) return {};
  }
  const Pose reference = e.needle();
  const Load load = load_of(setup, grip, direction, half_wedge(e, jaw_pose(Pose{}, -openings.lower)));
  if (!(load.limit > 0)) return {};  // nothing between the jaws

  PullResult result;
  constexpr int kSteps = 3000;
  // what slips goes on by leaps; what only gives goes less than six times as far as under half the load, even when the wire
  // turns about the jaws' normal and slips from its ends inwards. Creep is slip once it has come 20 um
  constexpr double kLeast = 2e-6, kMost = 20e-6;  // m
  for (int i = 0; i < kSteps; ++i) {
    const double share = 1.5 * i / kSteps;
    openings.apply(e, Pose{}, false);
    e.set_torque(grip * Jaw::kGrip);
    if (direction == Pull::kAxial)
      e.set_force({0, -share * load.limit, 0}, e.needle() * setup.needle.point(0));
    else
      e.set_couple(share * load.limit * (direction == Pull::kAboutWire ? Vec3::UnitY() : Vec3::UnitZ()));
    e.step();
    if (!finite(e.needle())) return {};
    const double way = moved(slip_between(e, Pose{}, reference), direction, load.arm);
    if (share <= 0.5) result.creep = way;
    const double slipped = share <= 0.5 ? kMost : std::clamp(6 * result.creep, kLeast, kMost);
    if (way > slipped) {
      result.onset = share;
      return result;
    }
  }
  result.onset = std::numeric_limits<double>::infinity();
  return result;
}

std::vector<PinchStage> pinch(const Method& method, const Setup& base_setup, double approach) {
  Setup setup = base_setup;
  setup.upper_driven = true;
  const auto engine = method.make(setup);
  Engine& e = *engine;
  const Openings openings(method, setup.needle, 0);
  const double start_gap = approach > 0 ? 0.5e-3 / Jaw::kGrip : 0;
  e.set_gravity(Vec3::Zero());
  const Pose lower = jaw_pose(Pose{}, -openings.lower);
  e.set_jaws(jaw_pose(Pose{}, openings.upper + start_gap), lower, true);
  e.set_needle(grip_pose(setup.needle), Vec3::Zero(), Vec3::Zero());
  const auto step = [&](double torque) {
    e.set_jaws(jaw_pose(Pose{}, openings.upper), lower, false);
    e.set_torque(torque);
    e.step();
  };

  // S08: the free jaw is pushed until it moves at the approach speed, then coasts into the needle
  if (approach > 0) {
    const double inertia = setup.jaw_mass * Jaw::kGrip * Jaw::kGrip;
    constexpr int kPush = 10;
    for (int i = 0; i < 200; ++i) step(i < kPush ? inertia * approach / Jaw::kGrip / (kPush * setup.dt) : 0);
  }

  std::vector<PinchStage> stages;
  for (double grip = 1e-3; grip < 20; grip *= 4) {
    PinchStage stage;
    stage.grip = grip;
    for (int i = 0; i < 200; ++i) {
      const double begin = cpu_ns();
      step(grip * Jaw::kGrip);
      stage.ns.push_back(cpu_ns() - begin);
      if (!finite(e.needle())) return stages;
    }
    const int touching = e.contacts(stage.overlap);
    stage.overlap = -stage.overlap;
    stage.drift = slip_between(e, Pose{}, grip_pose(setup.needle)).distance();
    if (touching == 0 || stage.drift > kLostAt || stage.overlap > setup.needle.wire_radius()) return stages;
    stages.push_back(std::move(stage));
  }
  return stages;
}

}  // namespace swage::bench
