// SPDX-License-Identifier: Apache-2.0
//
// S13, S14, G7: nothing passes through. First touches are compared with a search in small steps of time.
#include "contact/sweep.hpp"

#include <gtest/gtest.h>

#include "reference.hpp"
#include "solids.hpp"
#include "trajectory.hpp"

namespace swage::contact {
namespace sweep_test {

using bench::Needle;
using toolkit::Quat;

constexpr double kTolerance = 1e-6;

struct Case {
  Motion needle, jaw;
};

/// First time at which the exact gap is below `gap`; 2 when never. Steps of at most a fifth of a wire radius.
double searched(const Needle& n, const bench::Solid& jaw, const Case& c, double gap) {
  const double way = (c.needle.d - c.jaw.d).norm() + 10e-3 * (c.needle.turn - c.jaw.turn).norm();
  const int steps = static_cast<int>(way / 10e-6) + 2;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    if (bench::exact_gap(n, jaw, c.jaw.at(t).inverse() * c.needle.at(t)) < gap) return t;
  }
  return 2;
}

class Sweep : public testing::Test {
 protected:
  /// Checks one motion: a touch that the search sees is never found late; a hit is at a gap within tolerance.
  void check(const Case& c) {
    const FirstTouch touch =
        swapped_ ? first_touch(jaw_solid_, c.jaw, solid_, c.needle, kTolerance, memory_, work_)
                 : first_touch(solid_, c.needle, jaw_solid_, c.jaw, kTolerance, memory_, work_);
    const double late = searched(needle_, jaw_, c, -0.1e-6);
    if (late <= 1) {
      ++crossings_;
      ASSERT_TRUE(touch.hit);
      ASSERT_LE(touch.t, late);
    }
    if (!touch.hit) return;
    const double gap = bench::exact_gap(needle_, jaw_, c.jaw.at(touch.t).inverse() * c.needle.at(touch.t));
    ASSERT_TRUE(touch.t == 0 || gap > -1e-9) << "beyond the first touch";
    early_ += gap > 40 * kTolerance;
  }

  /// Needle and jaw, both moving and turning, somewhere near each other.
  void check_random(int count) {
    base::Xoshiro256 random(7);
    const auto draw = [&](double size) {
      return Vec3(random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size));
    };
    for (int i = 0; i < count; ++i) {
      Case c;
      const Quat q = toolkit::exp_rotation(draw(3));
      c.needle.X0 = {Vec3(7e-3, 0, 0.1e-3) + draw(1e-3) - q * needle_.point(random.uniform(-1, 1)), q};
      c.needle.d = draw(1e-3), c.needle.turn = draw(0.1);
      c.jaw.X0 = Pose(draw(1e-4), toolkit::exp_rotation(draw(0.1)));
      c.jaw.d = draw(1e-4), c.jaw.turn = draw(0.05);
      check(c);
    }
  }

  bool swapped_ = false;
  Needle needle_;
  bench::Solid jaw_{bench::jaw(1)};
  Solid solid_ = bench::contact_solid(needle_), jaw_solid_ = bench::contact_solid(bench::jaw(1));
  Separation memory_;
  Manifold work_;
  int crossings_ = 0, early_ = 0;
};

TEST_F(Sweep, NeedleShotAtAJawNeverPassesThrough) {
  // S13: 16 phases of the step, flat on, edge on and spinning, 0.02 to 50 m/s at 1 kHz
  for (const double speed : {0.02, 0.1, 0.5, 2.0, 10.0})
    for (int phase = 0; phase < 16; ++phase)
      for (int how = 0; how < 3; ++how) {
        const double way = 1e-3 * speed;
        Case c;
        c.jaw.X0 = Pose();
        // at the middle of this step the wire is at the face, its plane along it (flat), across it (edge), or turning
        const double turn = how == 0 ? std::numbers::pi / 2 : 0.2;
        const Quat q = toolkit::exp_rotation({0, turn, 0}) * toolkit::exp_rotation({0.3, 0, 0});
        const Vec3 middle(8e-3, 0, 0);
        c.needle.d = Vec3(0, 0, way);
        c.needle.turn = how == 2 ? Vec3(0.1, 0.02, 0.03) : Vec3(0, 0, 0);
        c.needle.X0 = {middle - (phase + 0.5) / 16 * c.needle.d - q * needle_.point(0) - Vec3(0, 0, 60e-6),
                       q};
        check(c);
      }
  EXPECT_GT(crossings_, 100);
  EXPECT_EQ(early_, 0);
}

TEST_F(Sweep, JawsClosingOnTheNeedleNeverPassThrough) {
  // S14: the jaw turns about its hinge by up to 0.125 rad in one step (1 m/s at the grip)
  const Pose grip = bench::grip_pose(needle_);
  for (const double speed : {0.01, 0.1, 1.0})
    for (int phase = 0; phase < 16; ++phase) {
      const double turned = speed * 1e-3 / bench::Jaw::kGrip;
      Case c;
      c.needle.X0 = grip;
      c.jaw.X0 = bench::jaw_pose(Pose(), 50e-6 / 8e-3 + turned * (phase + 0.5) / 16);
      c.jaw.turn = Vec3(0, turned, 0);
      check(c);
    }
  EXPECT_GT(crossings_, 30);
  EXPECT_EQ(early_, 0);
}

TEST_F(Sweep, RandomMotionsAgreeWithTheSearch) {
  check_random(300);
  EXPECT_GT(crossings_, 60);
  EXPECT_LT(early_, 10);
}

TEST_F(Sweep, SidesMayBeSwapped) {
  swapped_ = true;
  check_random(100);
  EXPECT_GT(crossings_, 20);
  EXPECT_LT(early_, 4);
}

TEST_F(Sweep, AStraightWireDoesNotPassEither) {
  needle_.straight = true;
  solid_ = bench::contact_solid(needle_);
  check_random(100);
  EXPECT_GT(crossings_, 20);
  EXPECT_LT(early_, 4);
}

TEST_F(Sweep, ADiscreteQueryWouldMissThem) {
  // at 2 m/s the wire is clear of the jaw before and after the step
  Case c;
  c.jaw.X0 = Pose();
  c.needle.d = Vec3(0, 0, 2e-3);
  const Quat q = toolkit::exp_rotation({0, std::numbers::pi / 2, 0});
  c.needle.X0 = {Vec3(8e-3, 0, -1e-3) - q * needle_.point(0), q};
  Query query;
  for (const double t : {0.0, 1.0})
    EXPECT_EQ(collide(solid_, Frame(c.needle.at(t)), jaw_solid_, Frame(c.jaw.at(t)), query, memory_, work_),
              0);
  const FirstTouch touch = first_touch(solid_, c.needle, jaw_solid_, c.jaw, kTolerance, memory_, work_);
  ASSERT_TRUE(touch.hit);
  EXPECT_NEAR(touch.t, (1e-3 - needle_.wire_radius()) / 2e-3, 1e-3);
}

}  // namespace sweep_test
}  // namespace swage::contact
