// SPDX-License-Identifier: Apache-2.0
//
// What the knot coupling counts as a passage: the thread is laid where a step has led it, before and after its contacts are solved.
#include <swage/abi/strand.h>

#include <algorithm>
#include <cmath>

#include "stage.hpp"

namespace swage::coupling_knot {
namespace {

constexpr double kLeg = 6e-3, kRadius = 2e-3, kArc = 1.5 * M_PI * kRadius;  // m
constexpr double kThread = 2 * kLeg + kArc;                                 // m, its length

/// A thread that crosses itself once at right angles: two legs and three quarters of a circle between them. The second leg lies `above` the first.
struct FakeThread {
  FakeThread() {
    raw.self = this;
    raw.get_extension = [](swage_instance*, const char* id) -> const void* {
      static const swage_strand table{law, place, nullptr};
      return std::strcmp(id, SWAGE_TRAIT_STRAND) == 0 ? &table : nullptr;
    };
  }
  static swage_result law(swage_instance*, const swage_object_step*, swage_strand_law* out) {
    *out = {kThread, 22e-6, 0.5, 0.5};
    return SWAGE_OK;
  }
  static swage_result place(swage_instance* i, const swage_object_step*, double s, swage_strand_place* out) {
    const auto& self = *static_cast<FakeThread*>(i->self);
    const double turn = (s - kLeg) / kRadius, up = self.above * std::clamp((s - kLeg) / kArc, 0.0, 1.0);
    *out = {};
    out->s = s;
    if (s < kLeg) out->p_W = {s - kLeg + kRadius, 0, up};
    else if (s < kLeg + kArc) out->p_W = {kRadius + kRadius * std::sin(turn), kRadius - kRadius * std::cos(turn), up};
    else out->p_W = {0, kRadius - (s - kLeg - kArc), up};
    return SWAGE_OK;
  }
  swage_instance raw{};
  double above = 0;  // m
};

class Passages : public ::testing::Test {
 protected:
  Passages() : stage_("swage.coupling.knot") {
    EXPECT_EQ(stage_.configure({{"places", 49}}), SWAGE_OK);
    table_ = &stage_.table<swage_coupling>(SWAGE_EXT_COUPLING);
    EXPECT_EQ(table_->bind(stage_.raw(), &thread_.raw, &thread_.raw), SWAGE_OK);
    EXPECT_EQ(stage_.activate(), SWAGE_OK);
    stage_.on_rt();
    state_.resize(stage_.n_state);
    signal_.resize(stage_.declared[SWAGE_DECLARE_SIGNAL].size());
  }

  /// A step: the second leg is so far above the first one [m] after each free motion (of each of its parts), and after the solve.
  void step(std::initializer_list<double> free, double solved) {
    for (const double above : free) call(table_->resolve, above);
    call(table_->finish, solved);
  }
  double passages() { return signal_[stage_.index_of(SWAGE_DECLARE_SIGNAL, "knot.passages")]; }
  size_t told() {
    const uint32_t event = stage_.index_of(SWAGE_DECLARE_EVENT, "knot.passage");
    return static_cast<size_t>(std::count_if(said_.begin(), said_.end(), [&](const stage::Said& s) { return s.event == event; }));
  }

  std::vector<stage::Said> said_;

 private:
  void call(swage_result (*function)(swage_instance*, const swage_coupling_step*), double above) {
    static Passages* listening;
    listening = this;
    thread_.above = above;
    swage_coupling_step s{};
    swage_object_step a{}, b{};
    s.struct_size = sizeof(s);
    s.dt_s = 1e-3;
    s.a = &a, s.b = &b;
    s.state = state_.data(), s.n_state = static_cast<uint32_t>(state_.size());
    s.signal = signal_.data(), s.n_signal = static_cast<uint32_t>(signal_.size());
    s.event = [](const swage_coupling_step*, uint32_t event, double value) { listening->said_.push_back({event, value}); };
    ASSERT_EQ(function(stage_.raw(), &s), SWAGE_OK);
  }

  stage::Stage stage_;
  FakeThread thread_;
  const swage_coupling* table_ = nullptr;
  std::vector<double> state_, signal_;
};

// the free motion leads one strand 50 um through the other, the contacts lead it back
TEST_F(Passages, AWayThroughAndBackWithinAStepIsNone) {
  step({100e-6}, 100e-6);
  step({-50e-6}, 50e-6);
  EXPECT_EQ(passages(), 0);
  EXPECT_EQ(told(), 0u);
}

// the same twice, in a step of two parts
TEST_F(Passages, AWayThroughAndBackWithinEachPartIsNone) {
  step({100e-6}, 100e-6);
  step({-50e-6, 50e-6, -50e-6}, 50e-6);
  EXPECT_EQ(passages(), 0);
  EXPECT_EQ(told(), 0u);
}

TEST_F(Passages, WhatIsThroughAtTheEndOfAStepCountsOnce) {
  step({100e-6}, 100e-6);
  step({-50e-6}, -60e-6);
  EXPECT_EQ(passages(), 1);
  ASSERT_EQ(told(), 1u);
  const double s = said_.back().value;  // m; the legs cross 2 mm from the circle on either side
  EXPECT_LT(std::min(std::abs(s - (kLeg - kRadius)), std::abs(s - (kThread - kLeg + kRadius))), 0.5e-3);
  step({-60e-6}, -60e-6);
  EXPECT_EQ(passages(), 1);
}

// there, back and there again: an odd number of ways leaves one
TEST_F(Passages, ThreeWaysAreOne) {
  step({100e-6}, 100e-6);
  step({-50e-6, 50e-6}, -50e-6);
  EXPECT_EQ(passages(), 1);
  EXPECT_EQ(told(), 1u);
}

// two steps are no one step: what went through has gone through, and the way back is another passage
TEST_F(Passages, TheWayBackInTheNextStepIsAnother) {
  step({100e-6}, 100e-6);
  step({}, -50e-6);
  step({}, 50e-6);
  EXPECT_EQ(passages(), 2);
  EXPECT_EQ(told(), 2u);
}

}  // namespace
}  // namespace swage::coupling_knot
