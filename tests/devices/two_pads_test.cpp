// SPDX-License-Identifier: Apache-2.0
//
// Two instruments led at the same time, in real time: the halves of a pad lead the two needleholders of lesson 045, each its own. What
// one stick and trigger do moves one tool and its jaws; both at once move both.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <cmath>

#include "record/recorder.hpp"
#include "sensor_thread.hpp"
#include "session/session.hpp"
#include "temp_folder.hpp"
#include "test_places.hpp"
#include "toolkit/math.hpp"
#include "virtual_pad.hpp"

namespace swage::session {
namespace {

using test::nap;
using test::VirtualPad;
using toolkit::Vec3;

class TwoHalves : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(VirtualPad::possible()) << "the package libsdl2-2.0-0 is missing";
    for (const char* place : {"XDG_STATE_HOME", "XDG_DATA_HOME"}) setenv(place, folder_.path().c_str(), 1);
    unsetenv("SWAGE_PLUGIN_PATH");
    pad_ = std::make_unique<VirtualPad>();
    options_.lesson_path = SWAGE_SOURCE_DIR "/lessons/series/045_pass_the_needle.json";
    options_.device = "pad";
    options_.plugin_dirs = {SWAGE_BINARY_DIR "/plugins"};
    options_.store_path = folder_ / "attempts.db";
    Problems problems;
    session_ = Session::open(options_, problems);
    std::string told;
    for (const Problem& p : problems) told += p.where + ": " + p.message + "\n";
    ASSERT_NE(session_, nullptr) << told;
    session_->start();
    until([&] { return shown_.step > 100; });
  }
  /// The tools' places, by their objects; 0 the right hand's, 1 the left hand's.
  Vec3 tool(std::size_t i) const { return toolkit::vec(shown_.X_WB[session_->card().objects[i].first_body].p); }
  template <class F>
  void until(F done) {
    do {
      nap(2e-3);
      session_->latest(shown_);
    } while (!done() && !session_->finished());
  }

  test::TempFolder folder_;
  std::unique_ptr<VirtualPad> pad_;
  Options options_;
  std::unique_ptr<Session> session_;
  snapshot::Snapshot shown_;
};

TEST_F(TwoHalves, LeadTwoToolsAtTheSameTime) {
  const Vec3 right = tool(0), left = tool(1);
  EXPECT_NEAR(right.x(), 6e-3, 1e-5);
  EXPECT_NEAR(left.x(), -6e-3, 1e-5);
  // the right stick to the left: the right tool goes to the left
  pad_->axis(gamepad::kRightX, -1);
  until([&] { return (tool(0) - right).norm() > 2e-3; });
  EXPECT_LT(tool(0).x(), right.x() - 1.5e-3);
  EXPECT_LT((tool(1) - left).norm(), 1e-9) << "and the other one stays";
  // both at once, up and right
  const Vec3 right_then = tool(0);
  pad_->axis(gamepad::kRightX, 0);
  pad_->axis(gamepad::kRightY, -1);
  pad_->axis(gamepad::kLeftX, 1);
  until([&] { return tool(0).z() > right_then.z() + 2e-3 && tool(1).x() > left.x() + 2e-3; });
  EXPECT_NEAR(tool(1).z(), left.z(), 1e-5);
  pad_->axis(gamepad::kRightY, 0);
  pad_->axis(gamepad::kLeftX, 0);
  // one trigger, one pair of jaws
  pad_->axis(gamepad::kLeftTrigger, 1);
  until([&] { return shown_.device[1].closure > 0.9; });
  EXPECT_EQ(shown_.device[0].closure, 0);
  session_->stop();
  session_->wait();
  const Result result = session_->result();
  EXPECT_EQ(result.health.quarantined, 0u);
  ASSERT_FALSE(result.attempt_id.empty());
  record::Recording recording;
  std::string error;
  ASSERT_TRUE(record::read_recording(options_.store_path, result.attempt_id, recording, error)) << error;
  Replay again;
  Problems problems;
  ASSERT_TRUE(replay(recording, options_.plugin_dirs, again, problems));
  EXPECT_TRUE(again.identical) << again.reason;
}

}  // namespace
}  // namespace swage::session
