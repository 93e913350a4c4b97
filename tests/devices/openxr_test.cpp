// SPDX-License-Identifier: Apache-2.0
//
// The driver of VR controllers, through the system's OpenXR loader, against a runtime that checks its caller.
#include "openxr/openxr.hpp"

#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <swage/testbed.hpp>

#include <cmath>
#include <random>

#include "openxr/sentences.hpp"
#include "test_places.hpp"

namespace swage::openxr {
namespace {

using testing::HasSubstr;
using Bench = testbed::DeviceBench<Openxr>;

const std::string kFake = SWAGE_BINARY_DIR "/tests/fake_xr/fake_xr.so";

/// The fake's own door.
template <class R, class... A>
R fake(const char* name, A... arguments) {
  static void* const library = dlopen(kFake.c_str(), RTLD_NOW | RTLD_LOCAL);
  return reinterpret_cast<R (*)(A...)>(dlsym(library, name))(arguments...);
}

double now_s() {
  timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

class Vr : public testing::Test {
 protected:
  Vr() {
    setenv("XR_RUNTIME_JSON", SWAGE_BINARY_DIR "/tests/fake_xr/runtime.json", 1);
    fake<void>("fake_reset");
  }
  static void start(Bench& bench) { ASSERT_TRUE(bench.start()) << (bench.host.reports.empty() ? "" : bench.host.reports[0]); }
  static void stop(Bench& bench) {
    bench.host.role = SWAGE_THREAD_MAIN;
    bench.get<swage_device>(SWAGE_EXT_DEVICE)->close(bench.raw);
  }
  static void ask(Bench& bench) {
    EXPECT_GE(bench.exchange(now_s()), 0);
    const timespec pause{0, 1'000'000};
    nanosleep(&pause, nullptr);
  }
  template <class F>
  static void until(Bench& bench, F done) {
    while (!done()) ask(bench);
  }
  static std::string refusal() {
    Bench bench;
    EXPECT_FALSE(bench.start());
    return bench.host.reports.empty() ? "" : bench.host.reports[0];
  }
  static std::string wrong() { return fake<const char*>("fake_wrong"); }
};

TEST_F(Vr, TheControllerLeadsFromWhereItWasFirstSeenAndPointsWhereItAims) {
  fake<void>("fake_place", 1, 0.3, -0.2, -0.4);
  Bench bench;
  bench.set("start", 0.01, 0.02, 0);
  start(bench);
  EXPECT_THAT(bench.host.reports.at(0), HasSubstr(say::kRuntime("Fake runtime")));
  until(bench, [&] { return bench.sample.sequence > 2; });
  EXPECT_NEAR(bench.sample.pose.p.x, 0.01, 1e-7) << "floats";
  EXPECT_NEAR(bench.sample.pose.p.y, 0.02, 1e-7);
  fake<void>("fake_place", 1, 0.35, -0.2, -0.5);
  fake<void>("fake_velocity", 1, 0.25);
  fake<void>("fake_squeeze", 1, 0.75, 2u);
  until(bench, [&] { return bench.sample.closure > 0.7; });
  EXPECT_NEAR(bench.sample.pose.p.x, 0.06, 1e-7);
  EXPECT_NEAR(bench.sample.pose.p.z, -0.1, 1e-7) << "away from the user";
  EXPECT_NEAR(bench.sample.twist.v.x, 0.25, 1e-12);
  EXPECT_NEAR(bench.sample.closure, 0.75, 1e-12);
  EXPECT_EQ(bench.sample.buttons, 2u);
  EXPECT_NEAR(bench.sample.time_s, now_s(), 1);
  const Quat q = toolkit::quat(bench.sample.pose.q);
  EXPECT_LT((q * Vec3::UnitX() - Vec3(0, 0, -1)).norm(), 1e-6);
  EXPECT_LT((q * Vec3::UnitZ() - Vec3(-1, 0, 0)).norm(), 1e-6);
  // a quarter turn to the left about the vertical
  fake<void>("fake_turn", 1, std::sqrt(0.5), 0.0, std::sqrt(0.5), 0.0);
  until(bench, [&] { return std::abs((toolkit::quat(bench.sample.pose.q) * Vec3::UnitX()).x() + 1) < 1e-6; });
  stop(bench);
  EXPECT_EQ(wrong(), "");
  EXPECT_EQ(fake<int>("fake_bindings"), 3 * 2 + 4 * 2 + 4 * 2 + 4 * 2) << "every part of every profile, for both hands";
}

TEST_F(Vr, TwoHandsShareOneConnection) {
  Bench left, right;
  left.set("side", 0);
  start(left);
  start(right);
  fake<void>("fake_squeeze", 0, 0.25, 1u);
  fake<void>("fake_squeeze", 1, 1.0, 0u);
  until(left, [&] { return left.sample.closure > 0.2; });
  until(right, [&] { return right.sample.closure > 0.9; });
  EXPECT_NEAR(left.sample.closure, 0.25, 1e-12);
  EXPECT_EQ(left.sample.buttons, 1u);
  EXPECT_EQ(right.sample.buttons, 0u);
  EXPECT_EQ(fake<int>("fake_instances"), 1);
  stop(left);
  const uint64_t last = right.sample.sequence;
  until(right, [&] { return right.sample.sequence > last + 3; });
  stop(right);
  EXPECT_EQ(fake<int>("fake_running"), 0) << "the last one closes it";
  EXPECT_EQ(wrong(), "");
}

TEST_F(Vr, AControllerThatIsGuessedAndNotTrackedIsSilent) {
  Bench bench;
  start(bench);
  until(bench, [&] { return bench.sample.sequence > 2; });
  const auto silent = [&] {
    for (int i = 0; i < 5; ++i) ask(bench);
    const uint64_t last = bench.sample.sequence;
    for (int i = 0; i < 50; ++i) ask(bench);
    return bench.sample.sequence == last;
  };
  for (const unsigned flags : {0u, 3u, 7u, 11u}) {
    fake<void>("fake_flags", 1, flags);
    EXPECT_TRUE(silent()) << flags;
  }
  fake<void>("fake_flags", 1, 15u);
  EXPECT_FALSE(silent());
  fake<void>("fake_turn", 1, 0.0, 0.0, 0.0, 0.0);
  EXPECT_TRUE(silent()) << "no rotation";
  fake<void>("fake_turn", 1, 1.0, 0.0, 0.0, 0.0);
  fake<void>("fake_place", 1, std::nan(""), 0.0, 0.0);
  EXPECT_TRUE(silent()) << "no number";
  fake<void>("fake_place", 1, 0.0, 0.0, 0.0);
  EXPECT_FALSE(silent());
  fake<void>("fake_focus", 0);
  EXPECT_TRUE(silent()) << "another program is in front";
  fake<void>("fake_focus", 1);
  EXPECT_FALSE(silent());
  stop(bench);
  EXPECT_EQ(wrong(), "");
}

TEST_F(Vr, ASessionThatStopsAndGoesOnIsFollowed) {
  Bench bench;
  start(bench);
  until(bench, [&] { return bench.sample.sequence > 2; });
  fake<void>("fake_state", static_cast<int>(XR_SESSION_STATE_STOPPING));
  until(bench, [&] { return fake<int>("fake_running") == 0; });
  for (int i = 0; i < 20; ++i) ask(bench);
  fake<void>("fake_state", static_cast<int>(XR_SESSION_STATE_READY));
  const uint64_t last = bench.sample.sequence;
  until(bench, [&] { return bench.sample.sequence > last + 2; });
  stop(bench);
  EXPECT_EQ(wrong(), "");
}

TEST_F(Vr, ARuntimeThatEndsInAnyWayIsFoundAgain) {
  Bench bench;
  start(bench);
  for (int way = 0; way < 4; ++way) {
    until(bench, [&] { return bench.sample.sequence > 0; });
    const uint64_t last = bench.sample.sequence;
    if (way == 0) fake<void>("fake_state", static_cast<int>(XR_SESSION_STATE_EXITING));
    if (way == 1) fake<void>("fake_state", static_cast<int>(XR_SESSION_STATE_LOSS_PENDING));
    if (way == 2) fake<void>("fake_instance_loss");
    if (way == 3) fake<void>("fake_plug", 0);
    for (int i = 0; i < 50; ++i) ask(bench);
    fake<void>("fake_plug", 1);
    const int before = fake<int>("fake_instances");
    until(bench, [&] { return bench.sample.sequence > last + 60; });
    EXPECT_GE(before + 1, fake<int>("fake_instances"));
    EXPECT_GE(fake<int>("fake_instances"), way + 2) << "a new connection";
  }
  stop(bench);
  EXPECT_EQ(wrong(), "");
}

TEST_F(Vr, WhatIsMissingIsToldWithTheRemedy) {
  fake<void>("fake_headset", 0);
  EXPECT_THAT(refusal(), HasSubstr("Fake runtime" + say::kNoHeadset.words(1)));
  fake<void>("fake_headset", 1);
  setenv("XR_RUNTIME_JSON", "/no/such/runtime.json", 1);
  EXPECT_THAT(refusal(), HasSubstr(say::kNoRuntime()));
  setenv("XR_RUNTIME_JSON", SWAGE_BINARY_DIR "/tests/fake_xr/runtime.json", 1);
  fake<void>("fake_plug", 0);
  EXPECT_THAT(refusal(), HasSubstr(say::kNotStarted.words(0)));
  fake<void>("fake_plug", 1);
  fake<void>("fake_touch", 0);
  Bench bench;
  start(bench);
  until(bench, [&] { return bench.sample.sequence > 2; });
  stop(bench);
  EXPECT_EQ(wrong(), "") << "a profile that the runtime does not know is no obstacle";
}

TEST_F(Vr, OpensAndClosesAHundredTimes) {
  for (int i = 0; i < 100; ++i) {
    Bench bench;
    ASSERT_TRUE(bench.start()) << i;
    ask(bench);
    stop(bench);
  }
  EXPECT_EQ(wrong(), "");
  EXPECT_EQ(fake<int>("fake_instances"), 100);
}

// The loader keeps the runtime and its list of extensions until an instance is destroyed, and here none is made: the last test.
TEST_F(Vr, WithoutSessionsThatShowNoPicturesItIsRefused) {
  fake<void>("fake_without", XR_MND_HEADLESS_EXTENSION_NAME);
  EXPECT_THAT(refusal(), HasSubstr(say::kNeedsPictures(XR_MND_HEADLESS_EXTENSION_NAME)));
}

}  // namespace
}  // namespace swage::openxr
