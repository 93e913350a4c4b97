// SPDX-License-Identifier: Apache-2.0
//
// A scene with a force device that is held up in the middle of a touch: what the hand feels, what is told, how it goes on.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <vector>

#include "../step/fake_scene.hpp"
#include "base/clock.hpp"
#include "session/device_ports.hpp"
#include "session/loop.hpp"
#include "session/rt_thread.hpp"
#include "session/watchdog.hpp"

namespace swage::session {
namespace {

/// What the hand felt, when.
struct Felt {
  int64_t at;    // ns
  double force;  // N, magnitude along the device's z
};

/// A ball lies on the tool with 0.1 mN; ten thousand times that is 1 N at the hand. Held up once for `stall_ms` after 800 steps.
class Stalled {
 public:
  explicit Stalled(int64_t stall_ms) {
    felt_.reserve(100000);
    step::FakeScene& s = scene;
    s.device_.device.flags = SWAGE_DEVICE_FORCE | SWAGE_DEVICE_WORLD;
    s.device_.device.rate_hz = 1000;
    s.device_.device.max_force = 2;
    s.rig.devices[0].force_scale = 1e4;
    s.rig.world.body[1].start.p.z = 1e-3;
    s.device_.exchange = [this](const swage_command* c, swage_sample* out) {
      felt_.push_back({base::wall_ns(), -c->force.z});
      ++out->sequence;
      out->pose.q = {1, 0, 0, 0};
      out->valid = SWAGE_VALID_POSE;
      return swage_result{SWAGE_OK};
    };
    s.ball_.forces = [this, stall_ms](const swage_object_step* step) {
      if (step->step == 800) {
        began = base::wall_ns();
        base::sleep_until_ns(began + stall_ms * 1'000'000);
        ended = base::wall_ns();
      }
      const swage_vec3 &p = step->X_WB[0].p, &v = step->V_WB[0].v;
      step->F_B_W[0].f = {-1.0 * p.x - 1e-3 * v.x, -1.0 * p.y - 1e-3 * v.y, -1e-4};
      return swage_result{SWAGE_OK};
    };
  }

  void run() {
    Watchdog dog([this] { return thread_->beats(); }, [this] { hung = true; });
    IoPort port(scene.rig.devices[0], dog.stalled_flag());
    step::Engine engine(scene.rig, step::Options(), {&port});
    Loop::Settings settings;
    settings.max_time_s = 2;
    Loop loop(scene.rig, engine, {&port}, nullptr, settings);
    thread_ = std::make_unique<RtThread>(
        Lateness::kDrop, 1e-3, [&](const RtThread::Tick& t) { return loop.tick(t, thread_->stats()); });
    dog.start();
    port.start();
    thread_->start([](const RtGrant&) {});
    thread_->join();
    dog.stop();
    fault = port.fault();
    port.stop();
    stalls = dog.stalls();
    judge::Event e;
    while (loop.next_event(e)) {
      const std::string& id = scene.rig.script.events[e.event].id;
      if (id == "host.gap") lost += e.value;
      stopped += id == "host.force_stopped";
    }
  }

  /// Largest force between two moments.
  double most(int64_t from, int64_t to) const {
    double out = 0;
    for (const Felt& f : felt_)
      if (f.at >= from && f.at < to) out = std::max(out, f.force);
    return out;
  }

  step::FakeScene scene;
  std::atomic<int64_t> began{0}, ended{0};
  std::atomic<bool> hung{false};
  ForceFault fault = ForceFault::kNone;
  double lost = 0;
  int stopped = 0;
  uint64_t stalls = 0;

 private:
  std::unique_ptr<RtThread> thread_;
  std::vector<Felt> felt_;  // written by the device's thread, read after it has ended
};

constexpr int64_t kMs = 1'000'000;

TEST(Stall, OfTwentyMillisecondsIsTold) {
  Stalled s(25);
  s.run();
  EXPECT_NEAR(s.most(s.began - 50 * kMs, s.began), 1.0, 0.05);  // the touch was felt
  EXPECT_GE(s.lost, 20);
  EXPECT_FALSE(s.hung);
}

TEST(Stall, OfSixtyLetsGoAndFadesInAgain) {
  Stalled s(60);
  s.run();
  EXPECT_GT(s.most(s.began - 50 * kMs, s.began), 0.9);
  // 20 ms until it counts as old, 10 ms of slew at most, then nothing until the step is back
  EXPECT_EQ(s.most(s.began + 40 * kMs, s.ended), 0);
  EXPECT_LT(s.most(s.ended, s.ended + 50 * kMs), 0.2);
  EXPECT_GT(s.most(s.ended + 500 * kMs, s.ended + 1000 * kMs), 0.9);
  EXPECT_GE(s.lost, 55);
  EXPECT_GE(s.stalls, 1u);
  EXPECT_FALSE(s.hung);
}

TEST(Stall, OfSixHundredDisarmsAndIsCalledAHang) {
  Stalled s(700);
  s.run();
  EXPECT_EQ(s.most(s.began + 40 * kMs, s.ended + 2000 * kMs), 0);  // a person has to arm it again
  EXPECT_EQ(s.fault, ForceFault::kLost);
  EXPECT_EQ(s.stopped, 1);
  EXPECT_TRUE(s.hung);
}

}  // namespace
}  // namespace swage::session
