// SPDX-License-Identifier: Apache-2.0
//
// About which contacts a flexible body is asked: those that overlap or nearly so; all of them where the answer goes too far.
#include <gtest/gtest.h>

#include "contact/detector.hpp"
#include "dynamics/dynamics.hpp"
#include "three_balls.hpp"

namespace swage::dynamics {
namespace flexible_points_test {

constexpr double kRadius = 50e-6;  // m

/// A free ball that claims to have its own mechanics and counts its points.
class Ball : public FlexibleBody {
 public:
  explicit Ball(bool shows) : shows_(shows) {}
  uint32_t object() const noexcept override { return 0; }
  bool surface_is_shape() const noexcept override { return shows_; }
  bool mobility(std::span<const swage_contact_point> point, double* v_free, double* W) noexcept override {
    asked.push_back(point.size());
    const size_t n = 3 * point.size();
    for (size_t i = 0; i < n; ++i) {
      v_free[i] = 0;
      for (size_t j = 0; j < n; ++j) W[i * n + j] = i % 3 == j % 3 ? 1 / kMass : 0;
    }
    return true;
  }
  void apply_impulses(std::span<const swage_contact_point>, const double*) noexcept override {}
  static constexpr double kMass = 4e-7;  // kg
  std::vector<size_t> asked;

 private:
  bool shows_;
};

/// The ball on another one, under a third.
struct Stack {
  Stack(double gap_below, double gap_above, bool shows = true)
      : ball(shows),
        world(make(gap_below, gap_above)),
        detector(world, {contact::Pair{0, 1, {0, 1e6, 0}}}, {}),
        dynamics(world, {}) {
    detector.reserve(contacts);
    dynamics.free_motion(world);
    detector.detect(world, contacts);
    FlexibleBody* const self[] = {&ball};
    dynamics.solve(world, contacts, self);
  }
  double force(uint32_t other) const {
    for (const contact::Contact& c : contacts.contact)
      if (c.body_b == other) return c.f_a_W.norm();
    return -1;
  }
  static scene::World make(double gap_below, double gap_above) {
    scene::World w = three_balls(kRadius, gap_below, gap_above);
    w.body[0].motion = SWAGE_MOTION_FLEXIBLE;
    scene::reset(w);
    return w;
  }

  Ball ball;
  scene::World world;
  contact::ContactSet contacts;
  contact::Detector detector;
  Dynamics dynamics;
};

// a tenth of a micrometre is near
TEST(FlexiblePoints, WhatIsFarIsNotAskedAbout) {
  const Stack s(0.1e-6, 5e-6);
  ASSERT_EQ(s.contacts.contact.size(), 2u);
  EXPECT_EQ(s.ball.asked, std::vector<size_t>{1});
  EXPECT_EQ(s.dynamics.stats().asked_again, 0u);
}

// pressed in by a micrometre, of which half comes back in a step, and that is more than there is above: it ends between the two
TEST(FlexiblePoints, WhatIsMetAllTheSameIsAskedAboutInTheSameStep) {
  const Stack s(-1e-6, 0.3e-6);
  EXPECT_EQ(s.ball.asked, (std::vector<size_t>{1, 2}));
  EXPECT_EQ(s.dynamics.stats().asked_again, 1u);
  EXPECT_GT(s.force(2), 0.01);
  EXPECT_NEAR(s.force(1), s.force(2), 1e-4) << "its mass is nothing beside them";
}

// one whose surface may be elsewhere than its shapes is asked about all at once, and answers the same
TEST(FlexiblePoints, WhoDoesNotShowItselfIsAskedAboutAll) {
  const Stack s(-1e-6, 0.3e-6, false), shows(-1e-6, 0.3e-6);
  EXPECT_EQ(s.ball.asked, std::vector<size_t>{2});
  EXPECT_NEAR(s.force(2), shows.force(2), 1e-9);
}

}  // namespace flexible_points_test
}  // namespace swage::dynamics
