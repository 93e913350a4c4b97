// SPDX-License-Identifier: Apache-2.0
//
// swage calibrate and swage simulate-sensor as a person uses them, and what validator and doctor say of drivers with their fakes.
#include <signal.h>
#include <stdio.h>

#include <atomic>
#include <filesystem>
#include <fstream>

#include "program.hpp"
#include "sensor/calibration_file.hpp"
#include "sensor/sentences.hpp"
#include "sensor_thread.hpp"
#include "test_places.hpp"
#include "toolkit/sentences.hpp"
#include "tools/sentences.hpp"

namespace swage::tools::test {
namespace {

using sensor::SimulatedSensor;
using swage::test::nap;
using swage::test::SensorThread;
using testing::HasSubstr;

class Calibrate : public Program {
 protected:
  void plug() {
    SimulatedSensor::Options options;
    options.serial = "B7";
    sensor_ = std::make_unique<SensorThread>(
        options, [this](double) { return SimulatedSensor::Measured{volts_, 0, 0}; }, path("port"));
  }
  /// Answers a verb step by step: each of its questions is waited for, the sensor is brought to its volts, and then the line is typed.
  /// Nothing depends on how fast the machine is.
  int answer(const std::string& arguments, const std::vector<std::pair<double, std::string>>& lines) {
    signal(SIGPIPE, SIG_IGN);  // a verb that has ended early says why; the answers are not heard
    std::filesystem::remove(path("said"));
    const std::string command =
        "{ " + std::string(SWAGE_PROGRAM) + " " + arguments + "; code=$?; echo ended; exit $code; } > " + path("said") + " 2>&1";
    FILE* in = popen(command.c_str(), "w");
    std::size_t heard = 0;  // bytes of the verb's words: they come out with a question, or with its end
    for (const auto& [volts, text] : lines) {
      EXPECT_TRUE(eventually([&] { return said().size() > heard || said().ends_with("ended\n"); })) << arguments << " asks nothing";
      heard = said().size();
      bring_to(volts);
      fprintf(in, "%s\n", text.c_str());
      fflush(in);
    }
    const int code = pclose(in);
    return WEXITSTATUS(code);
  }
  /// Returns once the sensor has sent these volts, and no message from before is on its way.
  void bring_to(double volts) {
    volts_ = volts;
    const std::uint64_t before = sent();
    EXPECT_TRUE(eventually([&] { return sent() > before + 20; })) << "a tenth of a second of messages";
  }
  template <class Condition>
  static bool eventually(Condition condition) {
    for (const double until = sensor::now_s() + 120; sensor::now_s() < until; nap(2e-3))
      if (condition()) return true;
    return false;
  }
  std::string said() const {
    std::ifstream in(path("said"));
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::uint64_t sent() {
    std::uint64_t n = 0;
    sensor_->with([&](SimulatedSensor& s) { n = s.sent(); });
    return n;
  }

  std::atomic<double> volts_{0};
  std::unique_ptr<SensorThread> sensor_;  // reads volts_
};

TEST_F(Calibrate, FromTheBenchOverTheScaleToThePosesOfASession) {
  plug();
  const std::string port = " --port " + path("port") + " --seconds 0.1";
  std::vector<std::pair<double, std::string>> points;
  for (int i = 0; i <= 12; ++i) points.emplace_back(-3 + 0.5 * i, std::to_string(0.5 * i));
  points.emplace_back(0, "");
  ASSERT_EQ(answer("calibrate displacement --by Ada" + port, points), 0) << said();
  EXPECT_THAT(said(), HasSubstr(say::kSlope("1.00000", "3.0000")));

  points = {{-1, ""}, {-1, "0.2"}, {-1.5, "1"}, {-2, "4"}, {-2.5, "10"}, {0, ""}};
  EXPECT_EQ(answer("calibrate force --by Ada" + port, points), 1) << "four points are too few";
  points = {{-1, ""}, {-1, "0.2"}, {-1.5, "1"}, {-2, "4"}, {-2.25, "6.5"}, {-2.5, "10"}, {0, ""}};
  ASSERT_EQ(answer("calibrate force --by Ada" + port, points), 0) << said();
  // 0.8, 3.8, 6.3, 9.8 N of the handle beyond what closes it, and nothing where the tips touch
  points = {{-1, ""}, {-1, "0"}, {-1.5, "0.15"}, {-2, "0.75"}, {-2.25, "1.25"}, {-2.5, "1.95"}, {0, ""}};
  ASSERT_EQ(answer("calibrate tip --by Ada" + port, points), 0) << said();
  EXPECT_EQ(answer("calibrate check --tip-force 0.75" + port, {{-1, ""}, {-2, ""}}), 0) << said();
  EXPECT_THAT(said(), HasSubstr(say::kTipForces("0.750", "0.750")));
  EXPECT_EQ(answer("calibrate check" + port, {{-1, ""}, {-2, ""}}), 1);
  EXPECT_THAT(said(), HasSubstr(sensor::say::kTipOff("0.60", "0.75", "25", "10")));
  EXPECT_THAT(swage({"calibrate", "show"}).out, HasSubstr("0.60 N checked on " + sensor::today() + ": +25 %"));
  ASSERT_EQ(answer("calibrate check --tip-force 0.75" + port, {{-1, ""}, {-2, ""}}), 0) << said();
  ASSERT_EQ(answer("calibrate poses --a 40 --b 40 --gap 10" + port, {{2, ""}, {-1, ""}, {-2.5, ""}}), 0) << said();

  sensor::Calibration c;
  ASSERT_EQ(sensor::load_calibration(sensor::calibration_path("B7"), c), "");
  EXPECT_EQ(c.by, "Ada");
  EXPECT_EQ(c.date, sensor::today());
  EXPECT_EQ(c.expires, sensor::days_after(sensor::today(), 365));
  EXPECT_NEAR(c.force.value(0.5e-3), 1, 1e-6);
  EXPECT_NEAR(c.tip.value(3.8), 0.75, 1e-6);
  EXPECT_NEAR(c.poses.open, 5e-3, 1e-6);
  EXPECT_NEAR(c.poses.squeezed, 0.5e-3, 1e-6);
  const nlohmann::json list = swage({"calibrate", "show", "--json"}).json();
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0]["serial"], "B7");
  EXPECT_EQ(list[0]["trouble"], "");

  // a sensor that drifted by 0.1 V: the zero alone is set anew; a handle that is held is no zero
  EXPECT_EQ(answer("calibrate zero" + port, {{0.9, ""}}), 1);
  EXPECT_THAT(said(), HasSubstr(sensor::say::kRestsElsewhere.words(1) + "3 mm" + sensor::say::kRestsElsewhere.words(2)));
  ASSERT_EQ(answer("calibrate zero" + port, {{2.1, ""}}), 0) << said();
  EXPECT_THAT(said(), HasSubstr(say::kPosesMoved("0.100")));
  ASSERT_EQ(sensor::load_calibration(sensor::calibration_path("B7"), c), "");
  EXPECT_NEAR(c.poses.open, 5.1e-3, 1e-6);
  EXPECT_NEAR(c.poses.closed, 2.1e-3, 1e-6);
  EXPECT_EQ(c.zero_date, sensor::today());

  // another needleholder under the same sensor is noticed, and taken when it is meant
  EXPECT_EQ(answer("calibrate poses" + port, {{3, ""}, {-1, ""}, {-2.5, ""}}), 1);
  EXPECT_THAT(said(), HasSubstr(sensor::say::kOtherHolder.words(4) + say::kNothingKept()));
  EXPECT_EQ(answer("calibrate poses --another-needleholder" + port, {{3, ""}, {-1, ""}, {-2.5, ""}}), 0) << said();
}

TEST_F(Calibrate, WhatCannotBeIsSaidAndNothingIsKept) {
  const auto fails = [&](const std::vector<std::string>& arguments, int code, const std::string& words) {
    const Said s = swage(arguments);
    EXPECT_EQ(s.code, code) << s.out;
    EXPECT_THAT(s.err, HasSubstr(words));
  };
  fails({"calibrate", "displacement", "--table", path("none.csv"), "--serial", "B7", "--by", "Ada"}, 2, toolkit::say::kNoFile());
  fails({"calibrate", "displacement", "--table", path("none.csv"), "--serial", "B7"}, 2, say::kSayWho());
  write("bent.csv", "mm,V\n0,0\n1,1.2\n2,1.8\n3,3.4\n4,3.7\n5,5.5\n6,5.5\n");
  fails({"calibrate", "displacement", "--table", path("bent.csv"), "--serial", "B7", "--by", "Ada"}, 1, say::kNothingKept());
  fails({"calibrate", "displacement", "--table", path("bent.csv"), "--by", "Ada"}, 2, say::kWhoseTable());
  fails({"calibrate", "displacement", "--table", path("bent.csv"), "--by", "Ada", "--serial", "../x"}, 2, say::kCannotName("../x"));
  write("words.csv", "mm,V\n0,0\n1,one\n");
  fails({"calibrate", "displacement", "--table", path("words.csv"), "--serial", "B7", "--by", "Ada"}, 2, say::kRowOf(path("words.csv"), 3, 2));
  write("f.csv", "0 0.2\n1 4\n2 3\n");
  fails({"calibrate", "tip", "--table", path("f.csv"), "--serial", "B7", "--by", "Ada"}, 2, say::kVoltsFirst());
  fails({"calibrate", "force", "--table", path("f.csv"), "--serial", "B7", "--by", "Ada"}, 2, say::kVoltsFirst());
  fails({"calibrate", "poses", "--port", path("nothing")}, 2, sensor::say::kNotThere(path("nothing")));
  EXPECT_THAT(swage({"calibrate", "show"}).out, HasSubstr(say::kNoneKept.words(0)));
}

TEST_F(Calibrate, ASimulatedSensorIsFoundByTheDriverInTheValidator) {
  Running simulated({"simulate-sensor", "--link", path("jaw"), "--corrupt-each", "20", "--drift", "0.004"}, folder());
  ASSERT_TRUE(eventually([&] { return access(path("jaw").c_str(), F_OK) == 0; }));
  write("lesson.json", R"({ "format": "swage-lesson/1", "id": "org.example.try", "title": "Try", "summary": "Try.", "scene_length": "1 mm",
    "requires": { "swage.device.jaw_sensor": "^1", "swage.lesson.look": "^1", "swage.object.jaws": "^1" },
    "devices": [ { "name": "hand", "plugin": "swage.device.jaw_sensor", "params": { "port": ")" +
                            path("jaw") + R"(" } } ],
    "objects": [ { "name": "holder", "plugin": "swage.object.jaws", "follows": { "pose": "hand", "closure": "hand" } } ],
    "lesson": { "plugin": "swage.lesson.look", "params": { "duration": "1 s" } } })");
  const Said s = swage({"validate", SWAGE_BINARY_DIR "/plugins/swage.device.jaw_sensor", "--with", path("lesson.json"), "--only", "driver",
                        "--strictness", "10"});
  EXPECT_EQ(s.code, 0) << s.out << s.err;
  EXPECT_THAT(s.out, testing::ContainsRegex("driver +success +[0-9]+ measurements")) << s.out << s.err;
  simulated.signal(SIGTERM);
  EXPECT_EQ(simulated.end().code, 0);
  EXPECT_NE(access(path("jaw").c_str(), F_OK), 0) << "its port is gone with it";
}

TEST_F(Calibrate, WhatADeviceTellsOfItselfIsDescribed) {
  const nlohmann::json list = swage({"describe", SWAGE_BINARY_DIR "/plugins/swage.device.jaw_sensor", "--json"}).json();
  ASSERT_EQ(list.size(), 1u);
  ASSERT_EQ(list[0]["signals"].size(), 1u) << list;
  EXPECT_EQ(list[0]["signals"][0]["id"], "sensor.volts");
  EXPECT_EQ(list[0]["signals"][0]["unit"], "V");
}

}  // namespace
}  // namespace swage::tools::test
