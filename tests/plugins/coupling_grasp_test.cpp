// SPDX-License-Identifier: Apache-2.0
//
// What the grasp coupling reads from contact forces: who presses, where, how squarely, and when it says so.
#include "fake_objects.hpp"
#include "stage.hpp"

namespace swage::coupling_grasp {
namespace {

class Grasp : public ::testing::Test {
 protected:
  explicit Grasp(int level = 1) : stage_("swage.coupling.grasp") {
    EXPECT_EQ(stage_.configure({{"level", level},
                                {"touch_force", 1e-3},
                                {"balance", 0.1},
                                {"settle_time", 0.03},
                                {"hard_force", 1.0},
                                {"skin", 25e-6}}),
              SWAGE_OK);
    table_ = &stage_.table<swage_coupling>(SWAGE_EXT_COUPLING);
    EXPECT_EQ(table_->bind(stage_.raw(), &gripper_.raw, &wire_.raw), SWAGE_OK);
    EXPECT_EQ(stage_.activate(), SWAGE_OK);
    stage_.on_rt();
    state_.resize(stage_.n_state);
    signal_.resize(stage_.declared[SWAGE_DECLARE_SIGNAL].size());
    gripper_.state.tip_W = {1.5e-3, 0, 0};
  }

  /// n steps with the left jaw pressing on the wire from above and the right one from below, at places along it.
  void press(double left, double right, int n = 1, double y_left = 0, double y_right = 0) {
    for (int i = 0; i < n; ++i) {
      contacts_.clear();
      if (left != 0) contacts_.push_back(touch(1, left, y_left, {0, 0, 1}));
      if (right != 0) contacts_.push_back(touch(2, right, y_right, {0, 0, -1}));
      step();
    }
  }
  /// A contact on a jaw: the wire pushes it along n with the force f.
  static swage_contact touch(uint32_t body, double f, double y, swage_vec3 n) {
    swage_contact c{};
    c.body_a = body;
    c.p_W = {0, y, 0.05e-3 * n.z};
    c.n_W = n;
    c.f_a_W = {f * n.x, f * n.y, f * n.z};
    return c;
  }
  void step() {
    static Grasp* listening;
    listening = this;
    swage_coupling_step s{};
    swage_object_step a{}, b{};
    s.struct_size = sizeof(s);
    s.time_s = time_;
    s.dt_s = 1e-3;
    s.a = &a;
    s.b = &b;
    s.contact = contacts_.data();
    s.n_contact = static_cast<uint32_t>(contacts_.size());
    s.state = state_.data();
    s.n_state = static_cast<uint32_t>(state_.size());
    s.signal = signal_.data();
    s.n_signal = static_cast<uint32_t>(signal_.size());
    s.event = [](const swage_coupling_step*, uint32_t event, double value) {
      listening->said_.push_back({event, value});
    };
    ASSERT_EQ(table_->finish(stage_.raw(), &s), SWAGE_OK);
    time_ += 1e-3;
  }
  double signal(const char* id) { return signal_[stage_.index_of(SWAGE_DECLARE_SIGNAL, id)]; }
  int count(const char* id) {
    const uint32_t event = stage_.index_of(SWAGE_DECLARE_EVENT, id);
    return static_cast<int>(
        std::count_if(said_.begin(), said_.end(), [&](const auto& s) { return s.event == event; }));
  }

  stage::Stage stage_;
  stage::FakeGripper gripper_;
  stage::FakeWire wire_;
  const swage_coupling* table_ = nullptr;
  std::vector<swage_contact> contacts_;
  std::vector<double> state_, signal_;
  std::vector<stage::Said> said_;
  double time_ = 0;
};

TEST_F(Grasp, OnlyLooksAndNeedsBothSides) {
  EXPECT_EQ(table_->detects, 0u);
  EXPECT_STREQ(table_->needs_a[0], SWAGE_TRAIT_GRIPPER);
  EXPECT_STREQ(table_->needs_b[0], SWAGE_TRAIT_GRASPABLE);
}

TEST_F(Grasp, TwoEvenJawsHoldAfterSettling) {
  press(0.6, 0.6, 29);
  EXPECT_EQ(signal("grasp.held"), 0);
  press(0.6, 0.6, 2);
  EXPECT_EQ(signal("grasp.held"), 1);
  EXPECT_NEAR(signal("grasp.force"), 0.6, 1e-12);
  EXPECT_EQ(count("grasp.taken"), 1);
  EXPECT_EQ(count("grasp.touched"), 1);
}

TEST_F(Grasp, OneJawAloneOrUnevenOnesDoNotHold) {
  press(0.6, 0, 100);
  EXPECT_EQ(signal("grasp.held"), 0);
  EXPECT_EQ(signal("grasp.balance"), 1);
  press(0.6, 0.6 * 0.89, 100);  // 11 % apart
  EXPECT_EQ(signal("grasp.held"), 0);
  press(0.6, 0.6 * 0.91, 100);  // 9 %
  EXPECT_EQ(signal("grasp.held"), 1);
  EXPECT_NEAR(signal("grasp.balance"), 0.09, 1e-12);
}

TEST_F(Grasp, PullingJawsDoNotCount) {
  press(-0.6, -0.6, 100);  // sticky forces, towards each other
  EXPECT_EQ(signal("grasp.held"), 0);
  EXPECT_EQ(signal("grasp.force"), 0);
}

TEST_F(Grasp, ReleaseComesOnceAndTellsHowLong) {
  press(0.6, 0.6, 500);
  press(0, 0, 20);
  EXPECT_EQ(count("grasp.released"), 0) << "a flicker is not a release";
  press(0.6, 0.6, 100);
  EXPECT_EQ(count("grasp.taken"), 1);
  press(0, 0, 100);
  EXPECT_EQ(count("grasp.released"), 1);
  EXPECT_NEAR(said_.back().value, 0.62, 0.015);
  EXPECT_EQ(signal("grasp.held"), 0);
}

TEST_F(Grasp, TouchesAreDebounced) {
  for (int i = 0; i < 5; ++i) {
    press(0.01, 0, 5);
    press(0, 0, 100);  // below the pause of 0.15 s
  }
  EXPECT_EQ(count("grasp.touched"), 1);
  press(0, 0, 151);
  press(0.01, 0, 5);
  EXPECT_EQ(count("grasp.touched"), 2);
}

TEST_F(Grasp, TooHardHasAGap) {
  press(1.01, 1.01, 10);
  EXPECT_EQ(count("grasp.too_hard"), 1);
  press(0.95, 0.95, 10);
  press(1.01, 1.01, 10);
  EXPECT_EQ(count("grasp.too_hard"), 1) << "it never went below nine tenths";
  press(0.89, 0.89, 10);
  press(1.01, 1.01, 10);
  EXPECT_EQ(count("grasp.too_hard"), 2);
}

TEST_F(Grasp, PlaceIsWeightedByForceAndStays) {
  // one outer jaw in the middle, the inner one on its two edges, unevenly
  contacts_ = {touch(1, 0.6, 1e-3, {0, 0, 1}), touch(2, 0.4, 0.75e-3, {0, 0, -1}),
               touch(2, 0.2, 1.25e-3, {0, 0, -1})};
  step();
  const double y = (0.6 * 1e-3 + 0.4 * 0.75e-3 + 0.2 * 1.25e-3) / 1.2;
  EXPECT_NEAR(signal("grasp.s"), 0.5 + y / 10e-3, 1e-12);
  EXPECT_NEAR(signal("grasp.tip_reach"), 1.5e-3, 1e-15);
  EXPECT_NEAR(signal("grasp.balance"), 0, 1e-12);
  press(0, 0, 10);
  EXPECT_NEAR(signal("grasp.s"), 0.5 + y / 10e-3, 1e-12);
}

TEST_F(Grasp, TiltIsZeroWhenSquareBothWays) {
  press(0.6, 0.6);
  EXPECT_NEAR(signal("grasp.tilt_axis"), 0, 1e-12);
  EXPECT_NEAR(signal("grasp.tilt_plane"), 0, 1e-12);
  // the needle leans by 0.2 rad along the jaw axis, its plane by 0.3 rad towards the jaw faces
  wire_.tangent_W = {std::sin(0.2), std::cos(0.2), 0};
  wire_.normal_W = {std::cos(0.3), 0, std::sin(0.3)};
  press(0.6, 0.6);
  EXPECT_NEAR(signal("grasp.tilt_axis"), 0.2, 1e-12);
  EXPECT_NEAR(signal("grasp.tilt_plane"), 0.3, 1e-12);
}

TEST_F(Grasp, SlipIsTheSpeedAtTheContacts) {
  contacts_ = {touch(1, 0.3, 0, {0, 0, 1}), touch(2, 0.1, 0, {0, 0, -1})};
  contacts_[0].slip = 1e-3;
  contacts_[1].slip = 5e-3;
  step();
  EXPECT_NEAR(signal("grasp.slip"), (0.3 * 1e-3 + 0.1 * 5e-3) / 0.4, 1e-15);
}

// Jaws that close obliquely on a wire touch it at opposite edges: the couple would turn them about their axis.
TEST_F(Grasp, TellsTheMomentOfObliqueJawsAboutTheirAxis) {
  gripper_.state.axis_W = {1, 0, 0};
  gripper_.state.closing_W = {0, 0, 1};
  press(0.6, 0.6, 1, 0.2e-3, -0.2e-3);
  EXPECT_NEAR(signal("grasp.roll_moment"), 2 * 0.6 * 0.2e-3, 1e-12) << "right-handed about the axis: the left jaw's +y edge is pushed to the left";
  press(0.6, 0.6, 1, -0.2e-3, 0.2e-3);
  EXPECT_NEAR(signal("grasp.roll_moment"), -2 * 0.6 * 0.2e-3, 1e-12);
  press(0.6, 0.6, 1, 0.2e-3, 0.2e-3);
  EXPECT_NEAR(signal("grasp.roll_moment"), 0, 1e-12) << "both beside the axis: nothing turns";
  press(0.6, 0, 1, 0.2e-3);
  EXPECT_EQ(signal("grasp.roll_moment"), 0) << "one jaw pushes, and turns nothing";
  press(0.6, 0.1, 1, 0.2e-3, -0.2e-3);
  EXPECT_NEAR(signal("grasp.roll_moment"), 2 * 0.1 * 0.2e-3, 1e-12) << "the weaker jaw counts";
}

TEST_F(Grasp, TheToolBodyIsNoJaw) {
  contacts_ = {touch(0, 0.6, 0, {0, 0, 1}), touch(2, 0.6, 0, {0, 0, -1})};
  for (int i = 0; i < 100; ++i) step();
  EXPECT_EQ(signal("grasp.held"), 0);
  EXPECT_EQ(signal("grasp.left"), 0);
}

/// The level of thesis 5.2.1 looks at particles and not at forces.
class Thesis : public Grasp {
 protected:
  Thesis() : Grasp(0) {}
  /// Faces that touch the wire of 0.1 mm from above and below with these gaps, at places along it.
  void faces(double gap_left, double gap_right, int n = 40, double y_left = 0, double y_right = 0) {
    for (int i = 0; i < n; ++i) {
      contacts_ = {touch(1, 0.6, y_left, {0, 0, 1}), touch(2, 0.2, y_right, {0, 0, -1})};
      contacts_[0].gap = gap_left;
      contacts_[1].gap = gap_right;
      // p_W is midway between the surfaces, and the wire's own is 50 um from its middle
      contacts_[0].p_W.z = 50e-6 + 0.5 * gap_left;
      contacts_[1].p_W.z = -50e-6 - 0.5 * gap_right;
      step();
    }
  }
};

TEST_F(Thesis, HoldsByEvenPenetrationWhateverTheForces) {
  faces(-1e-6, -1e-6);
  EXPECT_EQ(signal("grasp.held"), 1);
  EXPECT_NEAR(signal("grasp.balance"), 0, 1e-9);
  // what is reported besides is the same as for contacts
  EXPECT_NEAR(signal("grasp.left"), 0.6, 1e-12);
  EXPECT_NEAR(signal("grasp.force"), 0.4, 1e-12);
}

TEST_F(Thesis, TenPercentIsTheRule) {
  // 25 um of skin: 27 um against 24.5 um differ by 9.3 %, 23.5 um by 13 %
  faces(-2e-6, 0.5e-6);
  EXPECT_EQ(signal("grasp.held"), 1);
  EXPECT_NEAR(signal("grasp.balance"), 1 - 24.5 / 27, 1e-6);
  faces(-2e-6, 8e-6, 80);
  EXPECT_EQ(signal("grasp.held"), 0) << "beyond twice the rule it is lost";
}

TEST_F(Thesis, OneJawAloneHasNoParticle) {
  press(0.6, 0, 100);
  EXPECT_EQ(signal("grasp.held"), 0);
  EXPECT_EQ(signal("grasp.balance"), 1);
  faces(-1e-6, 30e-6);  // the other face is further than the skin
  EXPECT_EQ(signal("grasp.held"), 0);
}

}  // namespace
}  // namespace swage::coupling_grasp
