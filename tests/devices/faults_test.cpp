// SPDX-License-Identifier: Apache-2.0
//
// Every driver in a whole lesson in real time, its plug pulled and put back at a hundred random moments: no crash, no leap of the tool
// or of a force, and the attempt is kept. What leaps is read from the samples that the step saw, not from this machine's clock. The
// mouse has no plug of its own: the window system says when it moves. (The game pad's is also pulled in the middle of a grasp, in
// jaw_and_pad_test.cpp.)
#include <random>

#include "puppets.hpp"

namespace swage::test {
namespace {

using sensor::now_s;

// of the way of a tool: steps of a pen's tablet, 5 um, over the motion scale, and some rounding of the rest
constexpr double kSameX = 2e-6;
constexpr double kSameClosure = 5e-3;  // of a sensor with 12 bit and of 8192 steps of pressure, smoothed
// closure in one exchange by a button: 50 ms of 1.5 s
constexpr double kButtonStep = 0.05 / 1.5;

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
      looks_.push_back({now_->step, now_s(), now_->X_WB[0].p});
      const double t = now_s() - begun_;
      LedPoint led = puppet_->led(t);
      led.wall_s = now_s();
      path_.push_back(led);
      puppet_->move(t, now_->X_WB[0].p.x - 6e-3);
    }
  }
  void expect_led(const record::Recording& kept);
  void expect_driven(const HeardHand& pose, const HeardHand& closure);

  std::unique_ptr<Puppet> puppet_;
  std::unique_ptr<snapshot::Snapshot> now_ = std::make_unique<snapshot::Snapshot>();
  std::vector<ToolLook> looks_;
  std::vector<LedPoint> path_;
  std::size_t came_ = 0;  // looks before the tool was at the hand
  double begun_ = 0;  // s
};

/// The hand's samples go as the person went: at the speed of an axis, or on the way of who is where it is.
void Plug::expect_driven(const HeardHand& pose, const HeardHand& closure) {
  if (puppet_->top_speed() > 0) {
    EXPECT_EQ(faster_than_led(pose, puppet_->top_speed()), 0) << "samples further than their speed goes";
  } else {
    double x0 = 0;
    for (const swage_sample& s : pose.sample)
      if (s.valid & SWAGE_VALID_POSE) {
        x0 = s.pose.p.x;
        break;
      }
    EXPECT_EQ(beside_the_way(pose, SWAGE_VALID_POSE, path_, looks_, kSameX, [&](const swage_sample& s) { return (s.pose.p.x - x0) / pose.scale; },
                             [](const LedPoint& p) { return p.x; }),
              0)
        << "samples where the person was not";
  }
  if (std::isnan(puppet_->led(0).closure)) {
    EXPECT_LE(closure_step(closure), kButtonStep + 1e-9);
  } else {
    EXPECT_EQ(beside_the_way(closure, SWAGE_VALID_CLOSURE, path_, looks_, kSameClosure, [](const swage_sample& s) { return s.closure; },
                             [](const LedPoint& p) { return p.closure; }),
              0)
        << "samples that the person did not press";
  }
}

/// And the tool goes as its samples go, and its grip.
void Plug::expect_led(const record::Recording& kept) {
  ASSERT_EQ(kept.step.back() - kept.step.front() + 1, kept.step.size()) << "a step was not recorded";
  const HeardHand pose = heard_hand(kept, 0, puppet_->scale()), closure = heard_hand(kept, kept.info.devices.size() - 1);
  const std::vector<double> grip = kept_signal(kept, "grip.command");
  ASSERT_FALSE(grip.empty());

  const double tool = tool_leap(pose, {looks_.begin() + static_cast<std::ptrdiff_t>(came_), looks_.end()}), force = grip_leap(closure, grip, kGripGain, looks_[came_].step - closure.first);
  const std::vector<double> led = led_way(pose);
  std::printf("%s: tool led over %.1f mm, beyond its samples %.4f mm; grip beyond its samples %.3f N; %.1f s simulated\n", GetParam(),
              1e3 * led.back(), 1e3 * tool, force, now_->time_s);
  EXPECT_GT(led.back(), 5e-3) << "m: it was led at all";
  EXPECT_LT(tool, 1e-6) << "m: the tool goes only where its samples lead";
  EXPECT_LT(force, 0.05) << "N: jaws that spring open or shut make more than 1";
  expect_driven(pose, closure);
}

TEST_P(Plug, AHundredPulledPlugsLeaveNoLeapAndTheAttemptIsKept) {
  path_.push_back(puppet_->led(0));
  puppet_->move(0, 0);
  auto session = open();
  ASSERT_NE(session, nullptr);
  session->start();
  // the hand rests until it is heard: from there on its places are known
  for (; !session->finished() && !(session->latest(*now_) && (now_->device[0].valid & SWAGE_VALID_POSE) != 0); nap(2e-3)) puppet_->move(0, 0);
  begun_ = now_s();
  watch(*session, 1.5);  // the tool comes to the hand
  came_ = looks_.size();
  watch(*session, 0.5);
  std::mt19937 random(15);
  std::uniform_real_distribution<double> there(0.02, 0.15), away(0.01, 0.3);
  int pulled = 0;
  for (; pulled < 100 && !session->finished(); ++pulled) {
    watch(*session, there(random));
    puppet_->unplug();
    watch(*session, away(random));
    if (const double closure = puppet_->closure_when_plugged(); !std::isnan(closure)) path_.push_back({now_s(), path_.back().x, closure});
    puppet_->plug();
  }
  EXPECT_EQ(pulled, 100);
  // it is found again, and leads
  const double last = now_->time_s;
  const uint64_t steps = now_->step;
  for (int i = 0; i < 600 && now_->time_s < last + 1 && !session->finished(); ++i) watch(*session, 0.1);
  EXPECT_GE(now_->time_s, last + 1) << "the lesson goes on";
  EXPECT_FALSE(session->finished());
  session->stop();
  session->wait();
  EXPECT_EQ(session->result().outcome, judge::Outcome::kAborted) << session->result().reason;
  record::Recording kept;
  expect_kept(session->result(), steps / 2, &kept);
  if (HasFatalFailure()) return;
  expect_led(kept);
  session.reset();
  puppet_->check();
}

INSTANTIATE_TEST_SUITE_P(Devices, Plug, testing::Values("gamepad", "jaw_sensor", "spacemouse", "openhaptics", "tablet", "inverse3", "openxr"),
                         [](const auto& one) { return std::string(one.param); });

}  // namespace
}  // namespace swage::test
