// SPDX-License-Identifier: Apache-2.0
//
// The scripted hand through the boundary: time, end, flaws that are drawn from the instance's stream.
#include <fstream>

#include "../temp_folder.hpp"
#include "stage.hpp"
#include "toolkit/sentences.hpp"

namespace swage::scripted {
namespace {

using stage::Stage;

class Scripted : public ::testing::Test {
 protected:
  void SetUp() override {
    path_ = folder_ / "hand.json";
    std::ofstream(path_) << R"({"format": "swage-hand/1", "title": "two keys", "keys": [
      {"t": 0, "p": [0, 0, 0], "closure": 0}, {"t": 2, "p": ["8 mm", 0, 0], "closure": 1}]})";
  }

  static swage_sample at(Stage& stage, double t) {
    swage_command command{};
    command.time_s = t;
    swage_sample sample{};
    const auto& device = stage.table<swage_device>(SWAGE_EXT_DEVICE);
    EXPECT_EQ(device.exchange(stage.raw(), &command, &sample), SWAGE_OK);
    return sample;
  }
  std::unique_ptr<Stage> make(stage::Params params, uint64_t seed = 1) const {
    auto stage = std::make_unique<Stage>("swage.device.scripted", seed);
    params.insert_or_assign("file", path_);
    EXPECT_EQ(stage->configure(params), SWAGE_OK);
    EXPECT_EQ(stage->activate(), SWAGE_OK);
    stage->on_rt();
    return stage;
  }
  test::TempFolder folder_;
  std::string path_;
};

TEST_F(Scripted, FollowsTheFileAndSaysWhenItIsDone) {
  const auto stage = make({});
  const auto& device = stage->table<swage_device>(SWAGE_EXT_DEVICE);
  EXPECT_EQ(device.flags, SWAGE_DEVICE_LOCKSTEP | SWAGE_DEVICE_WORLD | SWAGE_DEVICE_SCRIPTED);
  const swage_sample middle = at(*stage, 1);
  EXPECT_NEAR(middle.pose.p.x, 4e-3, 1e-15);
  EXPECT_NEAR(middle.closure, 0.5, 1e-12);
  EXPECT_EQ(middle.valid, SWAGE_VALID_POSE | SWAGE_VALID_TWIST | SWAGE_VALID_CLOSURE);
  EXPECT_NE(at(*stage, 2).valid & SWAGE_VALID_DONE, 0u);
}

TEST_F(Scripted, SpeedAndDelay) {
  const auto stage = make({{"speed", 2}, {"delay", 1}});
  EXPECT_EQ(at(*stage, 0.9).pose.p.x, 0);
  const swage_sample middle = at(*stage, 1.5);
  EXPECT_NEAR(middle.pose.p.x, 4e-3, 1e-15);
  EXPECT_NEAR(middle.twist.v.x, 2 * 1.875 * 8e-3 / 2, 1e-12);
}

TEST_F(Scripted, FlawsRepeatWithTheSeedOnly) {
  const stage::Params shaky = {{"tremor", 50e-6}, {"spot_error", 0.2e-3}};
  const auto a = make(shaky, 5), b = make(shaky, 5), c = make(shaky, 6);
  const swage_sample x = at(*a, 0.7), y = at(*b, 0.7), z = at(*c, 0.7);
  EXPECT_EQ(std::memcmp(&x.pose, &y.pose, sizeof x.pose), 0);
  EXPECT_GT(std::abs(x.pose.p.y - z.pose.p.y), 1e-6);
}

TEST_F(Scripted, SpotErrorHasTheAskedSize) {
  double square = 0;
  const int n = 400;
  for (int i = 0; i < n; ++i) {
    const auto stage = make({{"spot_error", 1e-3}}, 100 + static_cast<uint64_t>(i));
    const swage_sample s = at(*stage, 0);
    square += (s.pose.p.x * s.pose.p.x + s.pose.p.y * s.pose.p.y + s.pose.p.z * s.pose.p.z) / n;
  }
  EXPECT_NEAR(std::sqrt(square), 1e-3, 0.08e-3);  // three standard errors of 400 draws
}

TEST_F(Scripted, AFileThatIsNotThereIsAProblemOfTheParameter) {
  Stage stage("swage.device.scripted");
  EXPECT_LT(stage.configure({{"file", std::string("/no/such/hand.json")}}), 0);
  ASSERT_EQ(stage.errors.size(), 1u);
  EXPECT_EQ(stage.errors[0], "file: /no/such/hand.json: " + toolkit::say::kNoFile());
}

}  // namespace
}  // namespace swage::scripted
