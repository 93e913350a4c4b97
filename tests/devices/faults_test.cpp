// SPDX-License-Identifier: Apache-2.0
//
// Every driver in a whole lesson in real time, its plug pulled and put back at a hundred random moments: no crash, no leap of the tool
// or of a force, and the attempt is kept. The mouse has no plug of its own: the window system says when it moves. (The game
// pad's is also pulled in the middle of a grasp, in jaw_and_pad_test.cpp.)
#include <random>

#include "puppets.hpp"

namespace swage::test {
namespace {

using sensor::now_s;

// s for which a driver of speeds moves at once after it was held up (rate/rate_hand.hpp); a hand that is lost for longer is met anew
constexpr double kLongestGap = 0.05;

class Plug : public LiveLesson, public testing::WithParamInterface<const char*> {
 protected:
  void SetUp() override {
    const std::string kind = GetParam();
    if (kind == "gamepad" || kind == "jaw_sensor") {
      ASSERT_TRUE(VirtualPad::possible()) << "the package libsdl2-2.0-0 is missing";
    }
    if (kind == "gamepad") puppet_ = std::make_unique<PadPuppet>();
    if (kind == "jaw_sensor") puppet_ = std::make_unique<JawPuppet>(folder_);
    if (kind == "spacemouse") puppet_ = std::make_unique<CapPuppet>(folder_);
    if (kind == "openhaptics") puppet_ = std::make_unique<ArmPuppet>();
    if (kind == "inverse3") puppet_ = std::make_unique<InversePuppet>();
#ifdef SWAGE_FAKE_XR
    if (kind == "openxr") puppet_ = std::make_unique<ControllerPuppet>();
#endif
    if (kind == "tablet") puppet_ = std::make_unique<PenPuppet>(folder_);
    if (kind == "tablet") options_.plugin_dirs.insert(options_.plugin_dirs.begin(), SWAGE_BINARY_DIR "/tests/fake_pen");
    ASSERT_NE(puppet_, nullptr) << "it was built without the package libopenxr-dev";
    write_lesson(puppet_->devices(), "hand", puppet_->closure());
  }
  /// The person moves, and the tool is watched.
  void watch(const session::Session& session, double seconds) {
    for (const double until = now_s() + seconds; now_s() < until && !session.finished(); nap(2e-3)) {
      if (!session.latest(*now_)) continue;
      leaps_.look(session, *now_);
      puppet_->move(now_s() - begun_, now_->X_WB[0].p.x - 6e-3);
    }
  }

  std::unique_ptr<Puppet> puppet_;
  std::unique_ptr<snapshot::Snapshot> now_ = std::make_unique<snapshot::Snapshot>();
  LeapWatch leaps_;
  double begun_ = now_s();
};

TEST_P(Plug, AHundredPulledPlugsLeaveNoLeapAndTheAttemptIsKept) {
  puppet_->move(0, 0);
  auto session = open();
  ASSERT_NE(session, nullptr);
  session->start();
  watch(*session, 1.5);  // the tool comes to the hand
  leaps_ = LeapWatch(puppet_->top_speed());
  watch(*session, 0.5);
  std::mt19937 random(15);
  std::uniform_real_distribution<double> there(0.02, 0.15), away(0.01, 0.3);
  int pulled = 0;
  for (; pulled < 100 && !session->finished(); ++pulled) {
    watch(*session, there(random));
    puppet_->unplug();
    watch(*session, away(random));
    puppet_->plug();
  }
  EXPECT_EQ(pulled, 100);
  // it is found again, and leads
  const double last = now_->time_s;
  const uint64_t steps = now_->step;
  for (int i = 0; i < 600 && now_->time_s < last + 1 && !session->finished(); ++i) watch(*session, 0.1);
  EXPECT_GE(now_->time_s, last + 1) << "the lesson goes on";
  std::printf("%s: leaps of %.3f mm, of %.3f; grip up to %.2f N/s, %.1f s simulated\n", GetParam(), 1e3 * std::max(leaps_.leap(), 0.0),
              1e3 * kLongestGap * puppet_->top_speed(), leaps_.force(), now_->time_s);
  EXPECT_GT(leaps_.speed(), 0.5e-3) << "m/s: it was led at all";
  EXPECT_LT(leaps_.leap(), kLongestGap * puppet_->top_speed()) << "m: a hand that was not heard for that long is caught up with, and no more";
  EXPECT_LT(leaps_.force(), 22) << "N/s: twice what the sensor's hand squeezes with; jaws that spring open or shut make 30";
  EXPECT_FALSE(session->finished());
  session->stop();
  session->wait();
  EXPECT_EQ(session->result().outcome, judge::Outcome::kAborted) << session->result().reason;
  expect_kept(session->result(), steps / 2);
  session.reset();
  puppet_->check();
}

INSTANTIATE_TEST_SUITE_P(Devices, Plug, testing::Values("gamepad", "jaw_sensor", "spacemouse", "openhaptics", "tablet", "inverse3", "openxr"),
                         [](const auto& one) { return std::string(one.param); });

}  // namespace
}  // namespace swage::test
