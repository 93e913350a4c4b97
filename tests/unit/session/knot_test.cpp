// SPDX-License-Identifier: Apache-2.0
//
// The pull of the knot of an attempt that was passed. The knots are those of lesson 134, which are looked at for 10 ms and then passed: at a friction of 0.4
// the square knot bears 80 mN, the granny 34.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>

#include "judge/pull_rule.hpp"
#include "record/recorder.hpp"
#include "session/knot_copy.hpp"
#include "session/sentences.hpp"
#include "session_bed.hpp"

namespace swage::session {
namespace {

using testing::HasSubstr;

const std::string kPull = std::string(SWAGE_SOURCE_DIR "/lessons/series/") + kPullLesson;
constexpr double kPoints = 40;

class KnotTestTest : public SessionTest {
 protected:
  enum Shape { kSquare = 1, kGranny = 2 };
  /// `more`: further members of the lesson.
  void prepare(Shape shape, const std::string& load, const std::string& more = "") {
    options.lesson_path = folder + "/look.json";
    std::ofstream(options.lesson_path)
        << R"({"format": "swage-lesson/1", "id": "test.look", "title": "Look", "gravity": [0, 0, 0], "pull": {"load": ")" << load << R"(", "points": 40},)" << more
        << R"("environment": {"medium": "water", "viscosity": "1 Pa*s", "density": "1260 kg/m3"},
              "objects": [{"name": "knot", "plugin": "swage.object.thread", "params": {"suture": "nylon_8_0.json", "memory": "0 1/m", "start": "nodes",
                           "length": "16.74 mm", "segments": 124, "paths": ")" SWAGE_SOURCE_DIR R"(/lessons/shapes/134_knots.txt", "shape": )" << shape << R"(}}],
              "couplings": [{"name": "itself", "plugin": "swage.coupling.contact", "between": ["knot", "knot"], "params": {"friction": 0.4, "stiffness": "5e4 N/m"}}],
              "lesson": {"plugin": "swage.lesson.look", "params": {"duration": "10 ms"}}})";
    options.device = "";
    options.pull_lesson = kPull;
  }
  Result run() {
    const auto session = open();
    session->start();
    session->wait();
    return session->result();
  }
  /// An attempt that is over, before its knot is pulled.
  std::unique_ptr<Session> finished() {
    auto session = open();
    session->start();
    while (!session->finished()) usleep(1000);
    return session;
  }
  static double value(const Result& r, const std::string& id) {
    for (const Result::Metric& m : r.metrics)
      if (m.id == id) return m.value;
    ADD_FAILURE() << "no metric " << id;
    return std::nan("");
  }
};

TEST_F(KnotTestTest, AKnotThatHoldsCostsNothing) {
  prepare(kSquare, "60 mN");
  const Result r = run();
  ASSERT_EQ(r.outcome, judge::Outcome::kPassed) << r.reason << told(r.problems);
  EXPECT_GE(value(r, "knot.bears"), 60e-3) << "N";
  EXPECT_LT(value(r, "knot.pull_slip"), 0.5e-3) << "m";
  EXPECT_EQ(value(r, "points.pull"), 0);
  EXPECT_EQ(r.score, 100);
  const Result again = run();
  EXPECT_EQ(value(again, "knot.bears"), value(r, "knot.bears")) << "the same bits";
  EXPECT_EQ(value(again, "knot.pull_slip"), value(r, "knot.pull_slip"));
}

TEST_F(KnotTestTest, OneThatGivesWayCostsPoints) {
  prepare(kGranny, "60 mN");
  const Result r = run();
  ASSERT_EQ(r.outcome, judge::Outcome::kPassed) << r.reason << told(r.problems);
  const double bears = value(r, "knot.bears");
  EXPECT_NEAR(bears, 34e-3, 5e-3) << "N";
  EXPECT_DOUBLE_EQ(value(r, "points.pull"), kPoints * (1 - bears / 60e-3));
  EXPECT_DOUBLE_EQ(r.score, 100 - kPoints * (1 - bears / 60e-3));
}

TEST_F(KnotTestTest, AnAttemptThatWasNotPassedIsNotPulled) {
  prepare(kGranny, "60 mN", R"("max_time": "5 ms",)");
  const Result r = run();
  EXPECT_EQ(r.outcome, judge::Outcome::kFailed);
  EXPECT_TRUE(std::isnan(value(r, "knot.bears")));
}

TEST_F(KnotTestTest, WhoStopsDuringThePullHasAResultWithoutIt) {
  prepare(kSquare, "50 mN");
  const auto session = finished();
  PullProgress now;
  EXPECT_TRUE(session->pull_knot(100, now));
  EXPECT_EQ(now.load, 50e-3);
  session->stop();
  EXPECT_FALSE(session->pull_knot(100, now));
  const Result r = session->result();
  EXPECT_EQ(r.outcome, judge::Outcome::kPassed);
  EXPECT_EQ(r.score, 100);
  EXPECT_TRUE(std::isnan(value(r, "knot.bears")));
}

TEST_F(KnotTestTest, AStepAtATimeIsTheSame) {
  prepare(kSquare, "50 mN");
  const auto session = finished();
  PullProgress now;
  double most = 0;
  int calls = 0;
  for (; session->pull_knot(7, now); ++calls) most = std::max(most, now.bears);
  session->wait();
  EXPECT_GT(calls, 100);
  EXPECT_GT(most, 0);
  EXPECT_EQ(value(session->result(), "knot.bears"), value(run(), "knot.bears"));
}

TEST_F(KnotTestTest, ThatItCannotBePulledIsToldAndCostsNothing) {
  prepare(kSquare, "50 mN");
  options.pull_lesson = folder + "/none.json";
  const Result r = run();
  EXPECT_EQ(r.outcome, judge::Outcome::kPassed);
  EXPECT_EQ(r.score, 100);
  EXPECT_TRUE(std::isnan(value(r, "knot.bears")));
  EXPECT_THAT(told(r.problems), HasSubstr(say::kNotPulled("").substr(0, 20)));
}

// as `swage replay --grade` does
TEST_F(KnotTestTest, AKeptAttemptIsJudgedTheSameAgain) {
  prepare(kGranny, "60 mN");
  options.store_path = folder + "/attempts.db";
  const Result then = run();
  record::Recording recording;
  std::string error;
  ASSERT_TRUE(record::read_recording(options.store_path, then.attempt_id, recording, error)) << error;
  Replay now;
  Problems problems;
  ASSERT_TRUE(judge_again(recording, options.plugin_dirs, kPull, now, problems)) << told(problems);
  EXPECT_TRUE(now.identical);
  EXPECT_EQ(now.verdict.score, then.score);
  EXPECT_EQ(value(now.verdict, "knot.bears"), value(then, "knot.bears"));
  ASSERT_TRUE(replay(recording, options.plugin_dirs, now, problems)) << told(problems);
  EXPECT_TRUE(std::isnan(value(now.verdict, "knot.bears"))) << "the bits alone are compared";
}

TEST_F(KnotTestTest, ALessonThatDoesNotAskForItHasNoSuchMetric) {
  options.lesson_path = kPull;
  for (const Result::Metric& m : run().metrics) EXPECT_NE(m.id, "knot.bears");
}

}  // namespace
}  // namespace swage::session
