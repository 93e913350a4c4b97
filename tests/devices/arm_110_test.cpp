// SPDX-License-Identifier: Apache-2.0
//
// Lesson 110 at the arm itself: what a libHD.so was told, tick by tick of its own scheduler, is the law of the lesson's reaction applied to the
// contact forces of the scene. Between the two lie scale, force guard, driver, servo and slew.
#include <dlfcn.h>
#include <swage/testbed.hpp>
#include <time.h>

#include <algorithm>
#include <cmath>

#include "arm_in_110.hpp"
#include "openhaptics/openhaptics.hpp"

namespace swage::session {
namespace {

using openhaptics::Openhaptics;

constexpr const char* kLibrary = SWAGE_BINARY_DIR "/tests/fake_hd/libHD.so";
constexpr uint64_t kEach = 4;  // steps between two words to the arm
constexpr int kTicks = 60;     // in which the arm's slew lets any force come: 3.3 N at 300 N/s are 11

template <class R, class... A>
R fake(const char* name, A... arguments) {
  static void* const library = dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
  return reinterpret_cast<R (*)(A...)>(dlsym(library, name))(arguments...);
}

double now_s() {
  timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

Vec3 told() { return {fake<double>("fake_force_of", 0), fake<double>("fake_force_of", 1), fake<double>("fake_force_of", 2)}; }

/// Gives the guard's command to the driver, and waits for the arm's own ticks: no clock of the machine decides.
void give(testbed::DeviceBench<Openhaptics>& arm, const swage_command& command) {
  arm.command = command;
  arm.command.stiffness = arm.command.damping = 0;  // the hand of this test does not move
  arm.command.deadline_s = now_s() + 10;
  ASSERT_GE(arm.exchange(now_s()), 0);
  const auto from = fake<unsigned long>("fake_ticks");
  unsigned long ticks = 0;
  while (ticks < kTicks && (ticks < 2 || (told() - toolkit::vec(command.force)).norm() > 1e-12)) {
    const timespec pause{0, 200'000};
    nanosleep(&pause, nullptr);
    ticks = fake<unsigned long>("fake_ticks") - from;
  }
}

struct Held {
  double peak = 0;            // N, greatest force wanted
  std::vector<double> error;  // N, told against the law
  double share(double of_all) {
    std::sort(error.begin(), error.end());
    return error[static_cast<std::size_t>(of_all * static_cast<double>(error.size() - 1))];
  }
};

/// `played`: the law in the scene; `judged`: the formula that the arm is held to.
Held play(const host::Reaction& played, const host::Reaction& judged) {
  Held out;
  ArmIn110 scene(played);
  fake<void>("fake_reset");
  testbed::DeviceBench<Openhaptics> arm;
  arm.set_text("library", kLibrary);
  EXPECT_TRUE(arm.start());
  if (!scene.engine || testing::Test::HasFailure()) return out;
  Vec3 before = Vec3::Zero();
  while (scene.engine->verdict().outcome == judge::Outcome::kRunning && scene.rig->world.time() < 30) {
    scene.engine->step();
    const double f = before.norm();
    const Vec3 wanted = f > 0 ? Vec3(scene.scale * formula(judged, f) / f * before) : Vec3(Vec3::Zero());
    before = scene.scene();
    if (scene.rig->world.step % kEach != 0) continue;
    give(arm, ArmIn110::given());
    if (testing::Test::HasFatalFailure()) break;
    if (scene.rig->world.time() < 1 || wanted.norm() > 1.7) continue;  // fades in; what the motors do not bear is cut
    out.peak = std::max(out.peak, wanted.norm());
    out.error.push_back((told() - wanted).norm());
  }
  EXPECT_EQ(scene.engine->verdict().outcome, judge::Outcome::kPassed);
  give(arm, swage_command{});
  arm.host.role = SWAGE_THREAD_MAIN;
  arm.get<swage_device>(SWAGE_EXT_DEVICE)->close(arm.raw);
  EXPECT_STREQ(fake<const char*>("fake_wrong"), "");
  return out;
}

class ArmIn110Test : public testing::TestWithParam<host::Reaction> {};

TEST_P(ArmIn110Test, IsToldTheLawOfTheReactionToTwoPercent) {
  Held held = play(GetParam(), GetParam());
  ASSERT_FALSE(held.error.empty());
  std::printf("told %zu times, peak %.3f N, error: median %.2f %%, 99 %% %.2f %% of the peak\n", held.error.size(), held.peak,
              100 * held.share(0.5) / held.peak, 100 * held.share(0.99) / held.peak);
  EXPECT_GT(held.peak, 0.1) << "there is something to feel";
  EXPECT_LT(held.share(0.99), 0.02 * held.peak) << "a hundredth is left to the guard's slew and to passivity control";
}

INSTANTIATE_TEST_SUITE_P(Laws, ArmIn110Test,
                         testing::Values(host::Reaction{}, host::Reaction{host::Law::kNullZone, 5e-3, {}}, host::Reaction{host::Law::kQuadratic, 50e-3, {}}));

// An arm with another law than the one that it is held to is found.
TEST(ArmIn110Control, AnotherLawIsNotHeld) {
  Held held = play({}, {host::Law::kNullZone, 20e-3, {}});
  ASSERT_FALSE(held.error.empty());
  EXPECT_GT(held.share(0.99), 0.02 * held.peak);
}

}  // namespace
}  // namespace swage::session
