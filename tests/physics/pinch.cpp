// SPDX-License-Identifier: Apache-2.0
//
// A straight wire of radius r pinched with N between two parallel faces of the width b, statics and Coulomb's law. Each face
// bears mu N at most, whatever the direction:
//
//   along the wire      both faces, mu N each                                            P = 2 mu N
//   about the wire      both at the arm r, one each way: a couple                        M = 2 mu N r
//   about the normal    mu N / b per length, at the arm |y|: mean over b is b / 4        M = 2 mu N b / 4 = mu N b / 2
//
// N = 1 N, mu = 0.3, r = 50 um, b = 0.5 mm: 0.6 N, 30 uN m, 75 uN m; the last is what 30 mN at the tip, 2.5 mm away, do to a needle
// that is inserted. The wire overlaps each face by N / k = 1 um and friction acts half of that deep, so about the wire the arm
// is 1 % shorter than r.
#include <algorithm>
#include <cmath>

#include "scene.hpp"

namespace swage::physics {
namespace pinch_test {

constexpr double kForce = 1, kFriction = 0.3, kRadius = 50e-6, kWidth = 0.5e-3;  // N, 1, m, m
constexpr double kStiffness = 1e6;                                               // N/m
constexpr double kLength = 5e-3;                                                 // m

/// A wire along y between a plate below and one above, which stand still and overlap it by N / k.
class PinchedWire {
 public:
  explicit PinchedWire(double width)
      : world_(make(width)),
        detector_(world_, {contact::Pair{0, 1, {kFriction, kStiffness, 0}}}, {}),
        dynamics_(world_, {}) {
    detector_.reserve(contacts_);
    for (int i = 0; i < 100; ++i) step({});
  }
  void step(const swage_wrench& load) {
    world_.F_B_W[0] = load;
    dynamics_.free_motion(world_);
    detector_.detect(world_, contacts_);
    dynamics_.solve(world_, contacts_, {}, {}, &detector_);
    dynamics_.finish(world_);
    ++world_.step;
  }
  /// How far the wire's surface came, at the farther of its middle and a place `arm` from it, under a load that grows to what it
  /// is in 0.2 s and stays for 0.2 s [m].
  double moved(const swage_wrench& load, double arm) {
    const Pose before(world_.X_WB[0]);
    double way = 0;
    for (int i = 1; i <= 400; ++i) {
      const double share = std::min(1.0, i / 200.0);
      step({toolkit::raw(Vec3(share * toolkit::vec(load.f))),
            toolkit::raw(Vec3(share * toolkit::vec(load.t)))});
      const Pose now(world_.X_WB[0]);
      const double turned = toolkit::log_rotation(now.q * before.q.conjugate()).norm();
      way = std::max({way, (now.p - before.p).norm(), arm * turned});
      if (!(way < 1e-3)) break;
    }
    return way;
  }
  /// What one face presses with [N].
  double pressed(uint32_t plate) const {
    double sum = 0;
    for (const contact::Contact& c : contacts_.contact)
      if (c.body_b == plate) sum += c.f_a_W.dot(c.n_W);
    return sum;
  }

 private:
  static scene::World make(double width) {
    scene::World w;
    w.length = 1e-3, w.dt = 1e-3;
    w.body.resize(3);
    for (auto& b : w.body) b.start = Pose{}.abi(), b.object = 1, b.motion = SWAGE_MOTION_FIXED;
    w.body[0].motion = SWAGE_MOTION_DYNAMIC;
    w.body[0].object = 0;
    const double m = 7900 * M_PI * kRadius * kRadius * kLength, across = m * kLength * kLength / 12;
    w.body[0].mass = m;
    w.body[0].inertia[0] = w.body[0].inertia[2] = across, w.body[0].inertia[1] = 0.5 * m * kRadius * kRadius;
    const double apart = kRadius - kForce / kStiffness;
    w.body[1].start.p.z = -apart, w.body[2].start.p.z = apart;

    scene::Shape wire;
    wire.kind = SWAGE_SHAPE_CAPSULE;
    wire.body = wire.object = 0;
    wire.X_BS = Pose(Vec3::Zero(), toolkit::exp_rotation({-M_PI / 2, 0, 0})).abi();
    wire.radius = kRadius, wire.half_length = 0.5 * kLength;
    wire.bounding_radius = 0.5 * kLength + kRadius;
    w.shape = {wire, plate(w, 1, width, -0.3e-3), plate(w, 2, width, 0.3e-3)};
    scene::reset(w);
    return w;
  }
  /// A box, 2 mm along x, `width` along y, from z = 0 to `thick`.
  static scene::Shape plate(scene::World& w, uint32_t body, double width, double thick) {
    scene::Shape s;
    s.kind = SWAGE_SHAPE_CONVEX;
    s.body = body, s.object = 1;
    s.X_BS = Pose{}.abi();
    s.convex = static_cast<uint32_t>(w.convex.size());
    s.bounding_radius = 2e-3;
    std::vector<Vec3> vertex;
    for (const double z : {std::min(0.0, thick), std::max(0.0, thick)})
      for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
        vertex.push_back({1e-3 * x, 0.5 * width * y, z});
    const std::vector<uint32_t> start{0, 4, 8, 12, 16, 20, 24};
    const std::vector<uint32_t> index{3, 2, 1, 0, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7};
    w.convex.emplace_back();
    EXPECT_EQ(toolkit::build_convex(vertex, start, index, w.convex.back()), "");
    return s;
  }

  scene::World world_;
  contact::ContactSet contacts_;
  contact::Detector detector_;
  dynamics::Dynamics dynamics_;
};

/// [m] What only gives comes 0.6 um at most; what slips goes on.
constexpr double kHeld = 2e-6, kSlipped = 20e-6;

/// Holds a load that is 3 % below the limit and none that is 3 % above.
void expect_limit(double width, const Vec3& force, const Vec3& couple, double arm) {
  const auto load = [&](double share) {
    return swage_wrench{toolkit::raw(Vec3(share * force)), toolkit::raw(Vec3(share * couple))};
  };
  EXPECT_LT(PinchedWire(width).moved(load(0.97), arm), kHeld);
  EXPECT_GT(PinchedWire(width).moved(load(1.03), arm), kSlipped);
}

TEST(Pinch, PressesWithWhatItOverlaps) {
  const PinchedWire wire(kWidth);
  EXPECT_NEAR(wire.pressed(1), kForce, 1e-3);
  EXPECT_NEAR(wire.pressed(2), kForce, 1e-3);
}

TEST(Pinch, BearsTwoMuNAlongTheWire) {
  const double limit = 2 * kFriction * kForce;
  EXPECT_NEAR(limit, 0.6, 1e-12);
  expect_limit(kWidth, {0, limit, 0}, Vec3::Zero(), 0);
}

TEST(Pinch, BearsTwoMuNRAboutTheWire) {
  const double limit = 2 * kFriction * kForce * (kRadius - 0.5 * kForce / kStiffness);
  EXPECT_NEAR(limit, 30e-6, 0.011 * 30e-6);
  expect_limit(kWidth, Vec3::Zero(), {0, limit, 0}, kRadius);
}

TEST(Pinch, BearsHalfMuNBAboutTheNormal) {
  const double limit = 0.5 * kFriction * kForce * kWidth;
  EXPECT_NEAR(limit, 75e-6, 1e-12);
  EXPECT_NEAR(limit / 2.5e-3, 30e-3, 1e-12);
  expect_limit(kWidth, Vec3::Zero(), {0, 0, limit}, 0.5 * kWidth);
}

// the moment grows with the width: a point contact at each face would have none, and one of fixed width the wrong one
TEST(Pinch, AnotherWidthBearsAnotherMoment) {
  expect_limit(0.5 * kWidth, Vec3::Zero(), {0, 0, 0.25 * kFriction * kForce * kWidth}, 0.25 * kWidth);
}

// Hertz (Johnson, Contact Mechanics, section 4.2), a ball of radius R on a flat: d = (9 F^2 / (16 E*^2 R))^(1/3), k = dF/dd =
// 3 F / 2 d. R = 50 um on steel, E* = 107 GPa, 0.1 N: 0.214 um and 7.0e5 N/m, the scale of the stiffness that a law has by itself.
TEST(Pinch, StiffnessIsOfHertzsScale) {
  constexpr double F = 0.1, E = 107e9;
  const double d = std::cbrt(9 * F * F / (16 * E * E * kRadius)), k = 1.5 * F / d;
  EXPECT_NEAR(d, 0.214e-6, 0.001e-6);
  EXPECT_NEAR(k, 7.0e5, 0.05e5);
  EXPECT_GT(contact::Law{}.stiffness, 0.5 * k);
  EXPECT_LT(contact::Law{}.stiffness, 2 * k);
}

}  // namespace pinch_test
}  // namespace swage::physics
