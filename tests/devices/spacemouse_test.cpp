// SPDX-License-Identifier: Apache-2.0
//
// The 3D mouse's driver against a daemon of a few lines on a socket of its own.
#include "spacemouse/spacemouse.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <swage/testbed.hpp>
#include <time.h>

#include <cmath>
#include <random>

#include "fake_spnav.hpp"
#include "spacemouse/sentences.hpp"
#include "temp_folder.hpp"

namespace swage::spacemouse {
namespace {

using test::Daemon;
using testing::HasSubstr;
using toolkit::Vec3;
using Bench = testbed::DeviceBench<Spacemouse>;

double now_s() {
  timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

void nap(double seconds) {
  const timespec pause{0, static_cast<long>(1e9 * seconds)};
  nanosleep(&pause, nullptr);
}

class Cap : public testing::Test {
 protected:
  Cap() : daemon_(folder_ / "spnav.sock") {}
  void start(Bench& bench) {
    bench.set_text("socket", folder_ / "spnav.sock");
    bench.set("start_closing", 0, 0, 1);
    bench.set("smoothing", 0);
    ASSERT_TRUE(bench.start()) << (bench.host.reports.empty() ? "" : bench.host.reports[0]);
  }
  static int ask(Bench& bench, double seconds) {
    int came = 0;
    int asked = 0;  // a busy machine asks as often as a quick one
    for (const double until = now_s() + seconds; now_s() < until || asked < 200 * seconds; nap(2e-3), ++asked) {
      const swage_sample last = bench.sample;
      EXPECT_GE(bench.exchange(now_s()), 0);
      came += bench.sample.sequence != last.sequence;
      EXPECT_TRUE(p(bench).allFinite());
      EXPECT_LE((p(bench) - toolkit::vec(last.pose.p)).norm(), 0.05 * 20e-3 * std::sqrt(3.0) + 1e-12);
    }
    return came;
  }
  static Vec3 p(const Bench& bench) { return toolkit::vec(bench.sample.pose.p); }

  test::TempFolder folder_;
  Daemon daemon_;
};

TEST_F(Cap, NoDaemonIsToldWithTheRemedy) {
  daemon_.stop();
  Bench bench;
  bench.set_text("socket", folder_ / "spnav.sock");
  EXPECT_FALSE(bench.start());
  EXPECT_THAT(bench.host.reports.at(0), HasSubstr(say::kNoDaemon(folder_ / "spnav.sock")));
}

TEST_F(Cap, SixAxesGoTheirWaysAndStandWhenTheCapIsLetGo) {
  for (int axis = 0; axis < 6; ++axis) {
    Bench bench;
    start(bench);
    int32_t data[7]{};
    data[axis] = 350;
    daemon_.tell(0, {data[0], data[1], data[2], data[3], data[4], data[5], 16});
    ask(bench, 0.05);
    const Vec3 v = toolkit::vec(bench.sample.twist.v), w = toolkit::vec(bench.sample.twist.w);
    const double sign = axis % 3 == 2 ? -1 : 1;  // their z goes away from the user
    const Vec3 wanted = sign * Vec3::Unit(axis % 3);
    EXPECT_LT((v - (axis < 3 ? Vec3(20e-3 * wanted) : Vec3(Vec3::Zero()))).norm(), 1e-12) << axis;
    EXPECT_LT((w - (axis < 3 ? Vec3(Vec3::Zero()) : Vec3(1.2 * wanted))).norm(), 1e-12) << axis;
    daemon_.tell(0, {0, 0, 0, 0, 0, 0, 16});
    ask(bench, 0.02);
    const Vec3 at = p(bench);
    ask(bench, 0.05);
    EXPECT_EQ(p(bench), at);
  }
}

TEST_F(Cap, ButtonsCloseAndOpenTheJawsUnlessTheyAreAnotherDevices) {
  Bench bench;
  bench.set("close_time", 0.2);
  start(bench);
  daemon_.tell(1, {0});
  ask(bench, 0.3);
  for (const double until = now_s() + 60; bench.sample.closure < 1 && now_s() < until;) ask(bench, 0.02);
  EXPECT_EQ(bench.sample.closure, 1);
  EXPECT_EQ(bench.sample.buttons, 1u);
  daemon_.tell(2, {0});
  daemon_.tell(1, {1});
  ask(bench, 0.3);
  for (const double until = now_s() + 60; bench.sample.closure > 0 && now_s() < until;) ask(bench, 0.02);
  EXPECT_EQ(bench.sample.closure, 0);
  Bench other;
  other.set("jaws", 0);
  start(other);
  ask(other, 0.02);
  EXPECT_EQ(other.sample.valid, SWAGE_VALID_POSE | SWAGE_VALID_TWIST | SWAGE_VALID_BUTTONS);
}

TEST_F(Cap, AMouseThatFallsSilentWhilePushedStands) {
  Bench bench;
  start(bench);
  daemon_.tell(0, {350, 0, 0, 0, 0, 0, 16});
  ask(bench, 0.6);
  const Vec3 at = p(bench);
  EXPECT_GT(at.x(), 0);
  EXPECT_LT(at.x(), 10e-3) << "0.3 s at 20 mm/s, and then nothing";
  ask(bench, 0.1);
  EXPECT_EQ(p(bench), at);
}

TEST_F(Cap, EventsInPiecesAndRubbishAreNoLeap) {
  Bench bench;
  start(bench);
  daemon_.tell(0, {350, 0, 0, 0, 0, 0, 16}, 13);
  ask(bench, 0.03);
  EXPECT_EQ(p(bench), Vec3::Zero()) << "half an event is none";
  const char rest[19]{};
  daemon_.send(rest, sizeof rest);
  ask(bench, 0.03);
  EXPECT_GT(p(bench).x(), 0) << "its other half makes it one";
  std::mt19937 random(9);
  for (int i = 0; i < 200; ++i) {
    SpnavEvent e;
    e.type = static_cast<int32_t>(random() % 6) - 1;
    for (int32_t& d : e.data) d = static_cast<int32_t>(random());
    daemon_.send(&e, sizeof e);
    ask(bench, 2e-3);
  }
}

TEST_F(Cap, ADaemonThatIsRestartedAHundredTimesIsFoundAgainWithoutALeap) {
  Bench bench;
  start(bench);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> moment(0.002, 0.06);
  for (int round = 0; round < 100; ++round) {
    daemon_.tell(0, {350, 0, 0, 0, 0, 0, 16});
    ask(bench, moment(random));
    daemon_.stop();
    ask(bench, 3e-3);
    const swage_sample held = bench.sample;
    EXPECT_EQ(ask(bench, moment(random)), 0) << "round " << round;
    daemon_.start();
    const double until = now_s() + 60;
    while (bench.sample.sequence == held.sequence && now_s() < until) ask(bench, 2e-3);
    ASSERT_LT(now_s(), until) << "round " << round;
    EXPECT_EQ(p(bench), toolkit::vec(held.pose.p)) << "the cap is at rest until it says otherwise";
  }
}

}  // namespace
}  // namespace swage::spacemouse
