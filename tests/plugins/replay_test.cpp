// SPDX-License-Identifier: Apache-2.0
//
// The replayed hand: what went in comes out, and a file of keys is refused with a hint.
#include <fstream>

#include "../temp_folder.hpp"
#include "stage.hpp"

namespace swage::replay {
namespace {

using stage::Stage;

class Replay : public ::testing::Test {
 protected:
  void SetUp() override { path_ = folder_ / "hand.json"; }
  static swage_sample at(Stage& stage, double t) {
    swage_command command{};
    command.time_s = t;
    swage_sample sample{};
    EXPECT_EQ(stage.table<swage_device>(SWAGE_EXT_DEVICE).exchange(stage.raw(), &command, &sample), SWAGE_OK);
    return sample;
  }
  test::TempFolder folder_;
  std::string path_;
};

TEST_F(Replay, HoldsTheLastSampleExactly) {
  std::ofstream(path_) << R"({"format": "swage-hand/1", "samples": [
    [0, 0.001, 0, 0, 1, 0, 0, 0, 0.1], [0.5, 0.002, 0, 0, 0.6, 0.8, 0, 0, 0.2], [1, 0.003, 0, 0, 1, 0, 0, 0, 0.3]]})";
  Stage stage("swage.device.replay");
  ASSERT_EQ(stage.configure({{"file", path_}}), SWAGE_OK);
  ASSERT_EQ(stage.activate(), SWAGE_OK);
  stage.on_rt();
  const swage_sample s = at(stage, 0.75);
  EXPECT_EQ(s.pose.p.x, 0.002);
  EXPECT_EQ(s.pose.q.x, 0.8);
  EXPECT_EQ(s.closure, 0.2);
  EXPECT_EQ(s.valid, SWAGE_VALID_POSE | SWAGE_VALID_CLOSURE);
  EXPECT_NE(at(stage, 1).valid & SWAGE_VALID_DONE, 0u);
}

TEST_F(Replay, GoesStraightWhenAsked) {
  std::ofstream(path_) << R"({"format": "swage-hand/1", "samples": [
    [0, 0.001, 0, 0, 1, 0, 0, 0, 0.1], [1, 0.003, 0, 0, 1, 0, 0, 0, 0.3]]})";
  Stage stage("swage.device.replay");
  ASSERT_EQ(stage.configure({{"file", path_}, {"between", 1}, {"start", 0.25}}), SWAGE_OK);
  ASSERT_EQ(stage.activate(), SWAGE_OK);
  stage.on_rt();
  const swage_sample s = at(stage, 0.25);
  EXPECT_NEAR(s.pose.p.x, 0.002, 1e-15);
  EXPECT_NEAR(s.twist.v.x, 0.002, 1e-15);
}

TEST_F(Replay, AFileOfKeysIsForTheOtherDevice) {
  std::ofstream(path_) << R"({"format": "swage-hand/1", "keys": [{"t": 0, "p": [0, 0, 0]}]})";
  Stage stage("swage.device.replay");
  EXPECT_LT(stage.configure({{"file", path_}}), 0);
  ASSERT_EQ(stage.errors.size(), 1u);
  EXPECT_NE(stage.errors[0].find("swage.device.scripted"), std::string::npos);
}

}  // namespace
}  // namespace swage::replay
