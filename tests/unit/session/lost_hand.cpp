// SPDX-License-Identifier: Apache-2.0
//
// A hand on a thread of its own that falls silent: the lesson waits for it, tells, and goes on when it is back.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "../step/fake_scene.hpp"
#include "base/clock.hpp"
#include "session/device_ports.hpp"
#include "session/loop.hpp"
#include "session/rt_thread.hpp"

namespace swage::session {
namespace {

// The scene's device has a thread of its own at 1 kHz and gives a pose, unless it is silent.
void speak_unless(const std::atomic<bool>& silent, step::FakeScene& s) {
  s.device_.device.flags = 0;
  s.device_.device.rate_hz = 1000;
  s.device_.exchange = [&silent](const swage_command*, swage_sample* out) {
    if (silent) return swage_result{SWAGE_OK};
    ++out->sequence;
    out->pose.q = {1, 0, 0, 0};
    out->valid = SWAGE_VALID_POSE;
    return swage_result{SWAGE_OK};
  };
}

TEST(LostHand, TheLessonWaitsAndGoesOn) {
  step::FakeScene s;
  std::atomic<bool> silent{false};
  speak_unless(silent, s);
  IoPort port(s.rig.devices[0], nullptr);
  step::Engine engine(s.rig, step::Options(), {&port});
  Loop loop(s.rig, engine, {&port}, nullptr, {});
  std::unique_ptr<RtThread> thread;
  thread = std::make_unique<RtThread>(Lateness::kCatchUp, 1e-3,
                                      [&](const RtThread::Tick& t) { return loop.tick(t, thread->stats()); });
  port.start();
  thread->start([](const RtGrant&) {});
  const auto until = [](auto done) {
    while (!done()) base::sleep_until_ns(base::wall_ns() + 1'000'000);
  };
  snapshot::Snapshot shown;
  until([&] { return loop.steps() > 100; });
  silent = true;
  until([&] { return loop.latest(shown) && shown.paused != 0; });
  EXPECT_EQ(shown.device[0].stale, 1u);
  const uint64_t then = loop.steps();
  base::sleep_until_ns(base::wall_ns() + 300'000'000);
  EXPECT_EQ(loop.steps(), then) << "no step is made while the hand is lost";
  silent = false;
  until([&] { return loop.steps() > then + 50; });
  loop.stop();
  thread->join();
  port.stop();
  EXPECT_EQ(loop.times_lost(0), 1u);
  EXPECT_GT(loop.seconds_lost(0), 0.7);

  int lost = 0, back = 0;
  double waited = 0;
  judge::Event e;
  while (loop.next_event(e)) {
    const std::string& id = s.rig.script.events[e.event].id;
    lost += id == "host.hand_lost";
    back += id == "host.hand_back";
    if (id == "host.hand_back") waited = e.value;
  }
  EXPECT_EQ(lost, 1);
  EXPECT_EQ(back, 1);
  EXPECT_GT(waited, 0.7);
}

TEST(LostHand, AHandThatMovedWhileTheSceneWasPausedIsMetWhereItsToolStands) {
  step::FakeScene s;
  std::atomic<double> place{0};
  s.device_.device.flags = 0;
  s.device_.device.rate_hz = 1000;
  s.device_.exchange = [&](const swage_command*, swage_sample* out) {
    ++out->sequence;
    out->pose = {{place, 0, 0}, {1, 0, 0, 0}};
    out->valid = SWAGE_VALID_POSE;
    return swage_result{SWAGE_OK};
  };
  IoPort port(s.rig.devices[0], nullptr);
  step::Engine engine(s.rig, step::Options(), {&port});
  Loop loop(s.rig, engine, {&port}, nullptr, {});
  std::unique_ptr<RtThread> thread;
  thread = std::make_unique<RtThread>(Lateness::kCatchUp, 1e-3,
                                      [&](const RtThread::Tick& t) { return loop.tick(t, thread->stats()); });
  port.start();
  thread->start([](const RtGrant&) {});
  snapshot::Snapshot shown;
  const auto after = [&](uint64_t steps) {
    for (const uint64_t then = loop.steps() + steps; loop.steps() < then || !loop.latest(shown) || shown.step < then;)
      base::sleep_until_ns(base::wall_ns() + 1'000'000);
    return shown.device[0].X_WD.p.x;
  };
  const double scale = 1 / s.rig.devices[0].motion_scale, start = after(200);
  loop.pause(true);
  base::sleep_until_ns(base::wall_ns() + 75'000'000);
  place = 5e-3;
  base::sleep_until_ns(base::wall_ns() + 75'000'000);
  loop.pause(false);
  EXPECT_NEAR(after(300), start, 1e-9) << "the tool does not leap after its hand";
  place = 6e-3;
  EXPECT_NEAR(after(300), start + 1e-3 * scale, 1e-9) << "and follows it from there";
  loop.stop();
  thread->join();
  port.stop();
}

// A scene that loses steps sees less of a silence than there was: here 10 ms of 150.
TEST(LostHand, AHandThatWasSilentForLongerThanTheSceneSawIsMetAnew) {
  step::FakeScene s;
  std::atomic<bool> silent{false};
  speak_unless(silent, s);
  IoPort port(s.rig.devices[0], nullptr);
  port.start();
  const auto wait = [] { base::sleep_until_ns(base::wall_ns() + 1'000'000); };
  double time_s = 0;
  swage_sample sample{};
  while (sample.valid == 0) wait(), port.read(0, time_s, sample);
  silent = true;
  while (!port.stale()) wait();
  base::sleep_until_ns(base::wall_ns() + 50'000'000);
  time_s += 10e-3;
  port.read(10, time_s, sample);
  EXPECT_EQ(sample.valid, 0u) << "silent";
  silent = false;
  while (port.stale()) wait();
  for (; time_s < 0.1; time_s += 1e-3) {
    port.read(0, time_s, sample);
    ASSERT_EQ(sample.valid, 0u) << time_s << " s: back, and not yet lost for as long as the step asks for";
  }
  // a test that is held up for 0.1 s between two reads begins the rest anew, at the same place
  for (time_s = 0.12; sample.valid == 0 && time_s < 0.2; time_s += 1e-3) port.read(0, time_s, sample);
  EXPECT_EQ(sample.valid, static_cast<uint32_t>(SWAGE_VALID_POSE)) << "heard again";
  port.stop();
}

}  // namespace
}  // namespace swage::session
