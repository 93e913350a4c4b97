// SPDX-License-Identifier: Apache-2.0
//
// Scenarios of the stability catalogue that no promise of the bar needs.
#include <limits>

#include "flip_statics.hpp"
#include "reference.hpp"
#include "scenario.hpp"

namespace swage::bench {
namespace {

constexpr double kLost = std::numeric_limits<double>::infinity();

/// A grasp that closes in 0.1 s to 1 um overlap and then moves: what it leaves behind at every step.
struct Trace {
  std::vector<Vec3> place;         // m, of mid-arc
  std::vector<uint64_t> contacts;  // Engine::contact_set()
  std::vector<double> ns;          // processor time of each step
};

Trace grasp_and_move(const Method& m, const Setup& setup, double seconds) {
  const auto engine = m.make(setup);
  Engine& e = *engine;
  const Needle& n = setup.needle;
  const double upper = closing_angle(n, 1, 1e-6, m.exact_arc),
               lower = closing_angle(n, -1, 1e-6, m.exact_arc);
  constexpr double kOpen = 0.02, kClosing = 0.1;  // rad, s
  const auto tool_at = [&](double t) {
    const double u = std::max(0.0, t - kClosing);
    return Pose{Vec3{1e-3 * std::sin(10 * u), 0.5e-3 * (1 - std::cos(10 * u)), 0},
                toolkit::exp_rotation({0.3 * std::sin(10 * u), 0, 0})};
  };
  const auto jaws_at = [&](double t) {
    const double open = kOpen * std::max(0.0, 1 - t / kClosing);
    return std::pair{jaw_pose(tool_at(t), upper + open), jaw_pose(tool_at(t), -lower - open)};
  };
  e.set_gravity(Vec3::Zero());
  e.set_jaws(jaws_at(0).first, jaws_at(0).second, true);
  e.set_needle(grip_pose(n), Vec3::Zero(), Vec3::Zero());
  Trace trace;
  const int steps = static_cast<int>(std::lround(seconds / setup.dt));
  for (int i = 1; i <= steps; ++i) {
    const auto [up, low] = jaws_at(i * setup.dt);
    const double begin = cpu_ns();
    e.set_jaws(up, low, false);
    e.step();
    trace.ns.push_back(cpu_ns() - begin);
    trace.contacts.push_back(e.contact_set());
    trace.place.push_back(e.needle() * n.point(0));
  }
  return trace;
}

double largest_distance(const Trace& a, const Trace& b) {
  double worst = 0;
  for (size_t i = 0; i < a.place.size(); ++i) {
    const double d = (a.place[i] - b.place[i]).norm();
    if (!std::isfinite(d)) return kLost;
    worst = std::max(worst, d);
  }
  return worst;
}

/// Bisects the value in [low, high] at which `holds` turns from false to true.
template <class F>
double threshold(double low, double high, F&& holds) {
  for (int k = 0; k < 12; ++k) {
    const double middle = 0.5 * (low + high);
    (holds(middle) ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

double unit_error(const Method& m, double units_per_metre) {
  Setup own, other;
  other.unit = units_per_metre;
  const Trace a = grasp_and_move(m, own, 0.5), b = grasp_and_move(m, other, 0.5);
  if (a.contacts != b.contacts) return kLost;
  return largest_distance(a, b) / own.needle.length();
}

std::vector<double> loops(const Method& m, int count) { return grasp_and_move(m, {}, count * Setup{}.dt).ns; }

double repeat_error(const Method& m, double seconds) {
  const Trace a = grasp_and_move(m, {}, seconds);
  Setup elsewhere;
  elsewhere.needle.wire_diameter = 0.07e-3;
  grasp_and_move(m, elsewhere, 0.05);
  return largest_distance(a, grasp_and_move(m, {}, seconds));
}

double flip_friction(const Method& m, double off_flat) {
  const Needle n;
  const double expected = flip_statics(n, off_flat);
  const auto holds = [&](double friction) {
    Setup setup;
    setup.friction = friction;
    setup.upper_driven = true;
    const auto engine = m.make(setup);
    Engine& e = *engine;
    // turn the plane about the wire at the grip, which stays where it is
    Pose X = grip_pose(n);
    const Vec3 grip = X * n.point(0);
    const Quat turn = toolkit::exp_rotation({0, std::numbers::pi / 2 - off_flat, 0});
    X = {grip + turn * (X.p - grip), turn * X.q};
    const double lower = closing_angle(n, -1, -0.5e-6, m.exact_arc);
    e.set_gravity(Vec3::Zero());
    e.set_jaws(jaw_pose(Pose{}, closing_angle(n, 1, -0.5e-6, m.exact_arc) + 1e-3), jaw_pose(Pose{}, -lower),
               true);
    e.set_needle(X, Vec3::Zero(), Vec3::Zero());
    for (int i = 0; i < 600; ++i) {
      e.set_jaws(Pose{}, jaw_pose(Pose{}, -lower), false);
      e.set_torque(0.05 * Jaw::kGrip);
      e.step();
    }
    if (!e.needle().p.allFinite()) return false;
    constexpr double kRolled = 0.1;  // rad
    return toolkit::log_rotation(e.needle().q * X.q.conjugate()).norm() < kRolled;
  };
  const double high = 5 * expected;
  if (!holds(high)) return kLost;
  return threshold(0, high, holds) / expected;
}

double wedge_angle(const Method& m, double friction) {
  // Two faces at +-alpha about the wire push it out with 2 N sin(alpha) and hold it with 2 mu N cos(alpha): out when
  // tan(alpha) > mu.
  Setup setup;
  setup.friction = friction;
  setup.needle.straight = true;
  const Needle& n = setup.needle;
  const Vec3 grip{Jaw::kGrip, 0, 0};
  const auto spat_out = [&](double alpha) {
    const auto engine = m.make(setup);
    Engine& e = *engine;
    constexpr double kOverlap = 1e-6;
    // each face is tilted about its line of touch with the wire
    const auto face = [&](double side) {
      const Quat q = toolkit::exp_rotation({0, -side * alpha, 0});
      const Vec3 normal = q * Vec3{0, 0, side};
      return Pose{grip + (n.wire_radius() - kOverlap) * normal - q * grip, q};
    };
    e.set_gravity(Vec3::Zero());
    e.set_jaws(face(1), face(-1), true);
    e.set_needle(grip_pose(n), Vec3::Zero(), Vec3::Zero());
    for (int i = 0; i < 200; ++i) {
      e.set_jaws(face(1), face(-1), false);
      e.step();
    }
    constexpr double kOut = 20e-6;  // m
    const Vec3 moved = e.needle().p - grip_pose(n).p;
    return !moved.allFinite() || moved.norm() > kOut;
  };
  const double expected = std::atan(friction);
  if (spat_out(0.2 * expected)) return kLost;
  return threshold(0.2 * expected, 3 * expected, spat_out) / expected;
}

double drag_ripple(const Method& m, double speed) {
  Setup setup;
  setup.upper_driven = true;
  const Needle& n = setup.needle;
  const auto engine = m.make(setup);
  Engine& e = *engine;
  const double lower = closing_angle(n, -1, 0, m.exact_arc);
  e.set_gravity(Vec3::Zero());
  e.set_jaws(jaw_pose(Pose{}, closing_angle(n, 1, 0, m.exact_arc)), jaw_pose(Pose{}, -lower), true);
  // the wire is led along its own circle, so that only the shape of its surface moves the jaw
  const Vec3 centre = grip_pose(n) * Vec3{0, 0, -n.offset()};
  std::vector<double> opening;
  const int steps = static_cast<int>(1e-3 / speed / setup.dt) + 200;
  for (int i = 0; i < steps; ++i) {
    const double turn = i < 200 ? 0 : -speed / n.radius() * (i - 200) * setup.dt;
    const Quat q = toolkit::exp_rotation({turn, 0, 0});
    const Pose X{centre + q * (grip_pose(n).p - centre), q * grip_pose(n).q};
    e.set_needle(X, Vec3::Zero(), Vec3::Zero());
    e.set_jaws(Pose{}, jaw_pose(Pose{}, -lower), false);
    e.set_torque(0.05 * Jaw::kGrip);
    e.step();
    if (i >= 200) opening.push_back((e.upper() * Vec3{Jaw::kGrip, 0, 0}).z());
  }
  const auto [low, high] = std::minmax_element(opening.begin(), opening.end());
  return opening.empty() || !std::isfinite(*high - *low) ? kLost : *high - *low;
}

double carried_error(const Method& m, double rate) {
  // A straight wire lies along the lower jaw, its centre of mass over the face, and the jaw turns up. A curved needle would
  // not do: its centre of mass lies beside the jaw, so it tips over the edge and swings there for as long as one looks.
  Setup setup;
  setup.needle.straight = true;
  const Needle& n = setup.needle;
  const auto engine = m.make(setup);
  Engine& e = *engine;
  const Pose X{Vec3{Jaw::kGrip, 0, n.wire_radius() + 1e-6},
               toolkit::exp_rotation({0, 0, std::numbers::pi / 2})};
  e.set_gravity({0, 0, -9.81});
  e.set_jaws(jaw_pose(Pose{}, 0.5), Pose{}, true);
  e.set_needle(X, Vec3::Zero(), Vec3::Zero());
  const int steps = 60;
  for (int i = 1; i <= steps; ++i) {
    e.set_jaws(jaw_pose(Pose{}, 0.5), jaw_pose(Pose{}, rate * i * setup.dt), false);
    e.step();
  }
  // a body that rests on the jaw moves with it as one: compare angular velocities about the hinge
  const double carried = -e.angular_velocity().y();
  return std::isfinite(carried) ? std::abs(carried / rate - 1) : kLost;
}

}  // namespace swage::bench
