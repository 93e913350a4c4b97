// SPDX-License-Identifier: Apache-2.0
#include "scenario.hpp"

#include <limits>

#include "base/rng.hpp"
#include "grip.hpp"

namespace swage::bench {
namespace {

/// The tool of S06: 60 deg about its own axis and 5 mm along it, once a second; `size` scales both.
Pose moved_tool(double t, double size) {
  const double c = 0.5 * size * (1 - std::cos(2 * std::numbers::pi * t));
  return {Vec3{5e-3 * c, 0, 0}, toolkit::exp_rotation({std::numbers::pi / 3 * c, 0, 0})};
}

Pose tool_pose(Tool tool, double amount, double t, base::Xoshiro256& rng) {
  if (tool == Tool::kMoving) return moved_tool(t, 1);
  if (tool == Tool::kLate) return moved_tool(std::floor(t / amount + 1e-9) * amount, 0.1);
  const auto jitter = [&] { return amount > 0 ? amount * rng.uniform(-1, 1) : 0.0; };
  return {Vec3{jitter(), jitter(), jitter()}, Quat::Identity()};
}

/// What the slip `s` at time `t` changes in the result; whether the needle is still held.
bool still_held(HoldResult& r, double t, const Slip& s) {
  r.worst = std::max(r.worst, s.distance());
  r.end = s;
  if (t <= 1) r.after_1s = s;
  if (t <= 10) r.after_10s = s;
  return s.distance() <= kLostAt && s.turn <= 0.5;
}

}  // namespace

HoldResult hold(const Method& method, const Setup& setup, double overlap, double seconds, Tool tool,
                double amount) {
  const auto engine = method.make(setup);
  Engine& e = *engine;
  const Openings openings(method, setup.needle, overlap);
  e.set_gravity(Vec3::Zero());
  openings.apply(e, Pose{}, true);
  e.set_needle(grip_pose(setup.needle), Vec3::Zero(), Vec3::Zero());

  // let the grasp settle before gravity acts
  for (int i = 0; i < 200; ++i) {
    openings.apply(e, Pose{}, false);
    e.step();
  }
  const Pose reference = e.needle();
  e.set_gravity({0, -setup.gravity, 0});

  HoldResult r;
  base::Xoshiro256 rng(7);
  const int steps = static_cast<int>(std::lround(seconds / setup.dt));
  std::vector<double> ns;
  ns.reserve(static_cast<size_t>(steps));
  for (int i = 0; i < steps; ++i) {
    const double t = (i + 1) * setup.dt;
    const Pose X_WT = tool_pose(tool, amount, t, rng);
    openings.apply(e, X_WT, false);
    const double start = now_ns();
    e.step();
    ns.push_back(now_ns() - start);
    if (!finite(e.needle()) || !still_held(r, t, slip_between(e, X_WT, reference))) {
      r.lost_at = t;
      break;
    }
  }
  r.step = times(std::move(ns));
  return r;
}

namespace {

/// Whether some of the wire's centre line crosses the middle sheet of the lower jaw, which lies at rest in W, on the way
/// from one pose to the next. A wire that swings round the jaw's side and comes to lie below it has not gone through.
bool crosses_plate(const Needle& n, const Pose& from, const Pose& to) {
  constexpr int kParts = 8, kPlaces = 32;
  const Vec3 turn = toolkit::log_rotation(to.q * from.q.conjugate());
  const auto at = [&](double t) {
    return Pose(from.p + t * (to.p - from.p), toolkit::exp_rotation(t * turn) * from.q);
  };
  for (int j = 0; j <= kPlaces; ++j) {
    const Vec3 on_wire = n.point(n.arc * (static_cast<double>(j) / kPlaces - 0.5));
    Vec3 before = at(0) * on_wire;
    for (int i = 1; i <= kParts; ++i) {
      const Vec3 now = at(static_cast<double>(i) / kParts) * on_wire;
      const double over = before.z() + 0.5 * Jaw::kThickness, under = now.z() + 0.5 * Jaw::kThickness;
      if (over * under <= 0 && over != under) {
        const Vec3 p = before + over / (over - under) * (now - before);
        const double half = Jaw::kHalfWidth * (Jaw::kHinge + Jaw::kLength - p.x()) / Jaw::kLength;
        if (p.x() > Jaw::kHinge && std::abs(p.y()) < half) return true;
      }
      before = now;
    }
  }
  return false;
}

}  // namespace

int tunnelled(const Method& method, const Setup& setup, double speed, Shot shot) {
  constexpr int kHeights = 16;
  const Needle& n = setup.needle;
  int through = 0;
  for (int k = 0; k < kHeights; ++k) {
    const auto engine = method.make(setup);
    Engine& e = *engine;
    const Pose open = jaw_pose(Pose{}, 0.3), fixed = jaw_pose(Pose{}, 0);
    e.set_gravity(Vec3::Zero());
    e.set_jaws(open, fixed, true);

    // flat: the curve's plane lies parallel to the jaw; edge: the top of the arc comes first
    const double height = 0.4e-3 + speed * setup.dt * (k + 0.37) / kHeights;
    Pose X;
    X.q = toolkit::exp_rotation(shot == Shot::kEdge ? Vec3{std::numbers::pi, 0, 0}
                                                    : Vec3{0, std::numbers::pi / 2, 0});
    const Vec3 aim{Jaw::kGrip - 1e-3, 0, height};
    X.p = aim - X.q * n.point(0);
    e.set_needle(X, {0, 0, -speed}, shot == Shot::kSpin ? Vec3{100, 0, 0} : Vec3::Zero());

    const int steps = static_cast<int>(3e-3 / speed / setup.dt) + 60;
    bool lost = false;
    for (int i = 0; i < steps && !lost; ++i) {
      e.set_jaws(open, fixed, false);
      e.step();
      // a needle that touches and rebounds within the step goes another way than straight to the end of it
      std::vector<Pose> way = e.way();
      if (way.empty()) way.push_back(e.needle());
      for (const Pose& Y : way) {
        lost = lost || !Y.p.allFinite() || crosses_plate(n, X, Y);
        X = Y;
      }
    }
    through += lost;
  }
  return through;
}

CloseResult close_on(const Method& method, const Setup& setup, double speed) {
  const auto engine = method.make(setup);
  Engine& e = *engine;
  const Openings touch(method, setup.needle, 0), grip(method, setup.needle, 1e-6);
  const double start = 0.5e-3 / Jaw::kGrip;
  e.set_gravity(Vec3::Zero());
  const auto at = [&](double t) {
    const double left = std::max(0.0, start - speed / Jaw::kGrip * t);
    return std::pair{jaw_pose(Pose{}, left > 0 ? touch.upper + left : grip.upper),
                     jaw_pose(Pose{}, -(left > 0 ? touch.lower + left : grip.lower))};
  };
  e.set_jaws(at(0).first, at(0).second, true);
  e.set_needle(grip_pose(setup.needle), Vec3::Zero(), Vec3::Zero());

  CloseResult r;
  const int steps = static_cast<int>(0.5e-3 / speed / setup.dt) + 100;
  const Solid upper(jaw(1)), lower(jaw(-1));
  for (int i = 1; i <= steps; ++i) {
    const auto [X_up, X_low] = at(i * setup.dt);
    e.set_jaws(X_up, X_low, false);
    e.step();
    if (!finite(e.needle())) return {true, std::numeric_limits<double>::infinity()};
    r.fastest = std::max(r.fastest, e.velocity().norm());
    // through: the wire's middle is on the far side of a gripping face while still inside the jaw's outline
    const Vec3 p = e.needle() * setup.needle.point(0);
    if ((X_up.inverse() * p).z() > setup.needle.wire_radius() ||
        (X_low.inverse() * p).z() < -setup.needle.wire_radius())
      r.through = true;
  }
  return r;
}

TopResult top(const Method& method, const Setup& base_setup, const Vec3& inertia, const Vec3& w0,
              double seconds) {
  Setup setup = base_setup;
  setup.jaws = false;
  setup.inertia = inertia;
  const auto engine = method.make(setup);
  Engine& e = *engine;
  e.set_gravity(Vec3::Zero());
  e.set_needle(Pose{}, Vec3::Zero(), w0);

  const auto body_rate = [&] { return Vec3(e.needle().q.normalized().conjugate() * e.angular_velocity()); };
  const auto energy = [&](const Vec3& w) { return 0.5 * w.dot(inertia.cwiseProduct(w)); };
  const double E0 = energy(w0), L0 = inertia.cwiseProduct(w0).norm();
  // the component that changes sign once in a half period: the one of the middle axis
  Eigen::Index axis;
  w0.cwiseAbs().maxCoeff(&axis);

  TopResult r;
  std::vector<double> ns, flips;
  double before = w0[axis];
  const int steps = static_cast<int>(std::lround(seconds / setup.dt));
  for (int i = 1; i <= steps; ++i) {
    const double begin = now_ns();
    e.step();
    ns.push_back(now_ns() - begin);
    const Vec3 w = body_rate();
    const double E = energy(w);
    if (!std::isfinite(E) || E > 1e6 * E0) {
      r.diverged_at = i * setup.dt;
      r.energy = std::numeric_limits<double>::infinity();
      break;
    }
    r.energy = std::max(r.energy, std::abs(E / E0 - 1));
    r.momentum = std::max(r.momentum, std::abs(inertia.cwiseProduct(w).norm() / L0 - 1));
    if (before * w[axis] < 0)
      flips.push_back((i - 1 + std::abs(before) / (std::abs(before) + std::abs(w[axis]))) * setup.dt);
    before = w[axis];
  }
  r.end = e.needle().q;
  if (flips.size() > 2) r.period = 2 * (flips.back() - flips.front()) / static_cast<double>(flips.size() - 1);
  r.step = times(std::move(ns));
  return r;
}

double bounce_error(const Method& method, const Setup& base_setup, double height, double restitution,
                    double radius) {
  Setup setup = base_setup;
  setup.jaws = false;
  setup.restitution = restitution;
  setup.ball_radius = radius;
  constexpr int kHeights = 16;
  double worst = 0;
  for (int k = 0; k < kHeights; ++k) {
    const auto engine = method.make(setup);
    Engine& e = *engine;
    const double h = height * (1 + 0.02 * k / kHeights);
    e.set_gravity({0, 0, -setup.gravity});
    e.set_needle({Vec3{0, 0, radius + h}, Quat::Identity()}, Vec3::Zero(), Vec3::Zero());
    const double fall = std::sqrt(2 * h / setup.gravity);
    const int steps = static_cast<int>(fall * (1 + 2.5 * restitution) / setup.dt) + 5;
    bool rising = false;
    double peak = -radius;
    for (int i = 0; i < steps; ++i) {
      e.step();
      const double z = e.needle().p.z() - radius;
      if (!std::isfinite(z) || z < -radius) return std::numeric_limits<double>::infinity();
      rising = rising || e.velocity().z() > 0;
      if (rising) peak = std::max(peak, z);
    }
    const double expected = restitution > 0 ? restitution * restitution * h : h;
    worst = std::max(worst, std::abs(peak / expected - (restitution > 0 ? 1 : 0)));
  }
  return worst;
}

}  // namespace swage::bench
