// SPDX-License-Identifier: Apache-2.0
//
// Which piece of a bending needle carries the others: that of the step before as long as something is at it, whatever the order in
// which the points are asked about. So the answer for a point does not depend on which other one was asked about first.
#include <gtest/gtest.h>

#include <optional>

#include "plugins/needle/bending.hpp"
#include "stage.hpp"

namespace swage::needle {
namespace {

constexpr double kBending = 1;
constexpr uint32_t kNear = 3, kFar = 10;  // bodies of two pieces

/// The answer to some points: v_free and W, in the order of the points.
struct Answer {
  std::vector<double> v, W;
  double at(size_t a, size_t b, size_t i, size_t k) const { return W[(3 * a + i) * v.size() + 3 * b + k]; }
};

/// A needle that falls and turns a little, and is pushed.
class Carrier : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(stage_.configure({{"level", kBending}}), SWAGE_OK);
    ASSERT_EQ(stage_.activate(), SWAGE_OK);
    stage_.on_rt();
    arrays_.emplace(stage_);
    step_ = arrays_->step();
    own_ = &stage_.table<swage_solver>(SWAGE_EXT_SOLVER);
    stage_.table<swage_object>(SWAGE_EXT_OBJECT).reset(stage_.raw(), &step_);
    // out of the plane, so that no number of an answer is zero by symmetry
    state().L[0] = 1e-13, state().L[1] = -2e-13, state().L[2] = 3e-13;
  }
  BendingState& state() { return *static_cast<BendingState*>(static_cast<void*>(arrays_->state.data())); }
  swage_contact_point point(uint32_t body) const {
    swage_contact_point p{};
    p.body = body;
    const Vec3 at = toolkit::vec(arrays_->X_WB[body].p) + Vec3(20e-6, 10e-6, 45e-6);
    p.p_W = toolkit::raw(at);
    return p;
  }
  void advance() { ASSERT_EQ(own_->advance(stage_.raw(), &step_), SWAGE_OK); }
  Answer ask(const std::vector<uint32_t>& bodies) {
    const auto n = static_cast<uint32_t>(bodies.size());
    asked_.clear();
    for (const uint32_t body : bodies) asked_.push_back(point(body));
    Answer out{std::vector<double>(3 * n), std::vector<double>(9 * n * n)};
    EXPECT_EQ(own_->mobility(stage_.raw(), &step_, n, asked_.data(), out.v.data(), out.W.data()), SWAGE_OK);
    return out;
  }
  /// Up to 0.2 mN for a step at each point of which it was asked last.
  void push() {
    std::vector<double> j;
    for (size_t i = 0; i < asked_.size(); ++i) j.insert(j.end(), {0, 1e-7, i % 2 == 0 ? 2e-7 : -1e-7});
    push(j);
  }
  void push(const std::vector<double>& j) {
    ASSERT_EQ(
        own_->apply_impulses(stage_.raw(), &step_, static_cast<uint32_t>(asked_.size()), asked_.data(), j.data()),
        SWAGE_OK);
  }
  /// What carried when it was pushed last, as a body.
  uint32_t base() {
    const auto piece = static_cast<uint32_t>(state().base);
    return piece == 6 ? 0 : piece < 6 ? piece + 1 : piece;
  }

  stage::Stage stage_{"swage.object.needle"};
  std::optional<stage::ObjectArrays> arrays_;
  swage_object_step step_{};
  const swage_solver* own_ = nullptr;
  std::vector<swage_contact_point> asked_;
};

TEST_F(Carrier, IsTheFirstThatIsTouchedAndStaysWhileSomethingIsAtIt) {
  advance();
  ask({kNear, kFar});
  push();
  EXPECT_EQ(base(), kNear);
  // asked about the other one first, and even about that one alone in between
  advance();
  ask({kFar});
  ask({kFar, kNear});
  push();
  EXPECT_EQ(base(), kNear) << "it is still touched";
  advance();
  ask({kFar});
  push();
  EXPECT_EQ(base(), kFar) << "nothing is at the one that carried";
}

TEST_F(Carrier, IsChosenAnewAfterNothingPushed) {
  advance();
  ask({kNear, kFar});
  push();
  advance();
  advance();  // nobody asked in between
  ask({kFar, kNear});
  push();
  EXPECT_EQ(base(), kFar);
}

TEST_F(Carrier, SoNoAnswerDependsOnTheOrderOfTheQuestion) {
  advance();
  ask({kNear, kFar});
  push();
  advance();
  constexpr double kRounding = 3e-9;  // m/s per N s, of some 1e6: 25 units in the last place
  const Answer one = ask({kNear, kFar}), other = ask({kFar, kNear});
  for (size_t a = 0; a < 2; ++a)
    for (size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(one.v[3 * a + i], other.v[3 * (1 - a) + i], 1e-15);
      for (size_t b = 0; b < 2; ++b)
        for (size_t k = 0; k < 3; ++k)
          EXPECT_NEAR(one.at(a, b, i, k), other.at(1 - a, 1 - b, i, k), kRounding);
    }
  // because one piece carries: what is asked of the far one alone is carried by that, and gives as a rigid body does
  const Answer alone = ask({kFar});
  EXPECT_GT(one.at(1, 1, 2, 2) - alone.at(0, 0, 2, 2), 1e9 * kRounding) << "else this test could not fail";
}

// A held needle is squeezed along its chord, and let go in a short step: its arms spring back. The piece that is held is expected to go on as it
// went, also in a longer step after that. Before, all were expected to go on as the middle did: in 141 (novice, seed 10) 0.6 rad beside the jaws.
TEST_F(Carrier, GoesOnAsItWentWhenAnArmSpringsBack) {
  constexpr double kPush = 0.1e-6, kHold = 1e-15;  // N s: 0.1 mN for a step, and as good as nothing
  const auto at = [&](uint32_t body) { return Vec3(toolkit::vec(arrays_->X_WB[body].p)); };
  const double h = step_.dt_s;
  state().L[0] = state().L[1] = state().L[2] = 0;
  const Vec3 push_near = kPush * (at(kFar) - at(kNear)).normalized();
  advance();
  ask({kNear, kFar});
  push({push_near[0], push_near[1], push_near[2], -push_near[0], -push_near[1], -push_near[2]});
  step_.dt_s = h / 16;
  advance();
  ask({kNear});
  push({0, 0, kHold});
  ASSERT_EQ(base(), kNear);
  const auto spin = [&](uint32_t body) { return toolkit::vec(arrays_->V_WB[body].w); };
  const double sprung = (spin(0) - spin(kNear)).norm() * (at(0) - at(kNear)).norm();
  const Vec3 before = at(kNear), v = toolkit::vec(arrays_->V_WB[kNear].v);
  ASSERT_GT(sprung, 10 * v.norm()) << "else this test could not fail";
  step_.dt_s = h;
  advance();
  EXPECT_LT((at(kNear) - before - h * v).norm(), 0.05 * h * sprung);
}

}  // namespace
}  // namespace swage::needle
