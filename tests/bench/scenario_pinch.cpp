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

/// A wire under a settled pinch, and the load that it may bear there.
class Pinched {
 public:
  Pinched(const Method& method, Setup setup, double grip, Pull direction)
      : grip_(grip), direction_(direction), openings_(method, setup.needle, 0) {
    setup.upper_driven = true;
    engine_ = method.make(setup);
    engine_->set_gravity(Vec3::Zero());
    openings_.apply(*engine_, Pose{}, true);
    engine_->set_needle(grip_pose(setup.needle), Vec3::Zero(), Vec3::Zero());
    for (int i = 0; i < 1000 && good(); ++i) step(0, std::min(1.0, i / 500.0));
    if (!good()) return;
    reference_ = engine_->needle();
    load_ = load_of(setup, grip, direction, half_wedge(*engine_, jaw_pose(Pose{}, -openings_.lower)));
  }
  bool good() const { return finite(engine_->needle()); }
  bool between_jaws() const { return good() && load_.limit > 0; }

  /// One step under `share` of the limit, the grip at `closed` of itself.
  void step(double share, double closed = 1) {
    Engine& e = *engine_;
    openings_.apply(e, Pose{}, false);
    e.set_torque(closed * grip_ * Jaw::kGrip);
    const double load = share * load_.limit;
    if (direction_ == Pull::kAxial)
      e.set_force({0, -load, 0}, e.needle() * e.setup.needle.point(0));
    else
      e.set_couple(load * (direction_ == Pull::kAboutWire ? Vec3::UnitY() : Vec3::UnitZ()));
    e.step();
  }
  /// How far anything of the wire has come since the pinch had settled, m.
  double way() const { return moved(slip_between(*engine_, Pose{}, reference_), direction_, load_.arm); }
  /// How far of that a wire that bends comes under the whole limit without slipping, m. Friction that is mobilised from the loaded edge
  /// inwards leaves the limit as it is (Coulomb's limits are those of a plastic body whose pressures are given: what gives elastically
  /// beside them does not count, Drucker, Prager and Greenberg 1952), but the couple winds up the wire on its way to the grip.
  double give() const {
    if (direction_ == Pull::kAxial) return 0;
    return load_.arm * load_.limit *
           (direction_ == Pull::kAboutWire ? engine_->gives().y() : engine_->gives().z());
  }

 private:
  double grip_;
  Pull direction_;
  Openings openings_;
  std::unique_ptr<Engine> engine_;
  Pose reference_;
  Load load_;
};

}  // namespace

PullResult pull(const Method& method, const Setup& setup, double grip, Pull direction) {
  Pinched wire(method, setup, grip, direction);
  if (!wire.between_jaws()) return {};
  PullResult result{std::numeric_limits<double>::infinity(), 0, {}};
  std::vector<double> ns;
  constexpr int kSteps = 3000;
  // what slips goes on by leaps; what only gives goes less than six times as far as under half the load, even when the wire
  // turns about the jaws' normal and slips from its ends inwards. Creep is slip once it has come 20 um
  constexpr double kLeast = 2e-6, kMost = 20e-6;  // m
  for (int i = 0; i < kSteps; ++i) {
    const double share = 1.5 * i / kSteps;
    const double begin = now_ns();
    wire.step(share);
    ns.push_back(now_ns() - begin);
    if (!wire.good()) return {};
    const double way = wire.way();
    if (share <= 0.5) result.creep = way;
    const double most = kMost + wire.give();
    const double slipped = share <= 0.5 ? most : std::clamp(6 * result.creep, kLeast, most);
    if (way > slipped) {
      result.onset = share;
      break;
    }
  }
  result.step = times(std::move(ns));
  return result;
}

double creep(const Method& method, const Setup& setup, double grip, Pull direction, double share,
             double seconds) {
  Pinched wire(method, setup, grip, direction);
  constexpr double kLost = std::numeric_limits<double>::infinity();
  if (!wire.between_jaws()) return kLost;
  constexpr int kRamp = 500, kSettle = 1000;
  double start = 0;
  const int steps = kSettle + static_cast<int>(std::lround(seconds / setup.dt));
  for (int i = 1; i <= steps; ++i) {
    wire.step(share * std::min(1.0, static_cast<double>(i) / kRamp));
    if (!wire.good() || wire.way() > kLostAt) return kLost;
    if (i == kSettle) start = wire.way();
  }
  return std::abs(wire.way() - start);
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
