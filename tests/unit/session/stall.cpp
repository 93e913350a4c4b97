// SPDX-License-Identifier: Apache-2.0
//
// A scene with a force device that is held up in the middle of a touch: what the hand feels, what is told, how it goes on.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <iterator>
#include <memory>
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

/// A ball lies on the tool with 0.1 mN; ten thousand times that is 1 N at the hand. As soon as the hand feels it the step is
/// held up, until `enough` has come true; it goes on until `over`. Nothing here depends on how fast the machine is.
class Stalled {
 public:
  using Condition = std::function<bool(const Stalled&)>;
  Stalled(Condition enough, Condition over) : enough_(std::move(enough)), over_(std::move(over)) {
    felt_.reserve(1'000'000);
    step::FakeScene& s = scene;
    s.device_.device.flags = SWAGE_DEVICE_FORCE | SWAGE_DEVICE_WORLD;
    s.device_.device.rate_hz = 1000;
    s.device_.device.max_force = 2;
    s.rig.devices[0].force_scale = 1e4;
    s.rig.world.body[1].start.p.z = 1e-3;
    s.device_.exchange = [this](const swage_command* c, swage_sample* out) {
      feels = -c->force.z;
      if (felt_.size() < felt_.capacity()) felt_.push_back({base::wall_ns(), -c->force.z});
      ++out->sequence;
      out->pose.q = {1, 0, 0, 0};
      out->valid = SWAGE_VALID_POSE;
      return swage_result{SWAGE_OK};
    };
    s.ball_.forces = [this](const swage_object_step* step) {
      if (began == 0) wait_for_touch();
      const swage_vec3 &p = step->X_WB[0].p, &v = step->V_WB[0].v;
      step->F_B_W[0].f = {-1.0 * p.x - 1e-3 * v.x, -1.0 * p.y - 1e-3 * v.y, -1e-4};
      return swage_result{SWAGE_OK};
    };
  }

  void run() {
    dog = std::make_unique<Watchdog>([this] { return thread_->beats(); }, [this] { hung = true; });
    port = std::make_unique<IoPort>(scene.rig.devices[0], dog->stalled_flag());
    step::Engine engine(scene.rig, step::Options(), {port.get()});
    Loop loop(scene.rig, engine, {port.get()}, nullptr, {});
    thread_ = std::make_unique<RtThread>(Lateness::kDrop, 1e-3, [&](const RtThread::Tick& t) {
      ticks_after += ended != 0;
      if (ended != 0 && over_(*this)) loop.stop();
      return loop.tick(t, thread_->stats());
    });
    dog->start();
    port->start();
    thread_->start([](const RtGrant&) {});
    thread_->join();
    dog->stop();
    fault = port->fault();
    forces_off_s = loop.forces_off_s();
    port->stop();
    judge::Event e;
    while (loop.next_event(e)) {
      const std::string& id = scene.rig.script.events[e.event].id;
      if (id == "host.gap") lost += e.value;
      stopped += id == "host.force_stopped";
    }
  }

  /// Samples felt between two moments.
  std::vector<Felt> felt(int64_t from, int64_t to) const {
    std::vector<Felt> out;
    std::copy_if(felt_.begin(), felt_.end(), std::back_inserter(out),
                 [&](const Felt& f) { return f.at >= from && f.at < to; });
    return out;
  }

  step::FakeScene scene;
  std::atomic<int64_t> began{0}, ended{0};  // ns, of the stall
  std::atomic<bool> hung{false};
  std::atomic<double> feels{0};
  std::unique_ptr<Watchdog> dog;
  std::unique_ptr<IoPort> port;
  ForceFault fault = ForceFault::kNone;
  double lost = 0;
  double forces_off_s = 0;  // as a result tells it
  int stopped = 0, ticks_after = 0;

 private:
  void wait_for_touch() {
    // a machine that was held up before has disarmed rightly; that is not what is asked here
    if (port->fault() == ForceFault::kLost) port->arm();
    if (feels < 0.95) return;
    began = base::wall_ns();
    while (!enough_(*this)) base::sleep_until_ns(base::wall_ns() + 1'000'000);
    ended = base::wall_ns();
  }

  const Condition enough_, over_;
  std::unique_ptr<RtThread> thread_;
  std::vector<Felt> felt_;  // written by the device's thread, read after it has ended
};

constexpr int64_t kMs = 1'000'000;

// The force is old after 20 ms and gone after 10 ms of slew, counted from the first exchange that surely saw it old. An exchange
// began after the one before it was felt.
void expect_let_go(const std::vector<Felt>& felt, int64_t began) {
  std::size_t old = 1;
  while (old < felt.size() && felt[old - 1].at < began + 20 * kMs) ++old;
  std::size_t gone = old + 1;
  while (gone < felt.size() && felt[gone - 1].at < felt[old].at + 10 * kMs) ++gone;
  ASSERT_LT(gone, felt.size()) << "the stall was too short for its question";
  for (std::size_t i = gone; i < felt.size(); ++i) EXPECT_EQ(felt[i].force, 0) << i;
}

bool felt_again(const Stalled& now) {
  // on a machine that holds everything up for a fifth of a second the guard disarms: a person arms it again
  if (now.port->fault() == ForceFault::kLost) now.port->arm();
  return now.feels > 0.9;
}

TEST(Stall, OfTwentyMillisecondsIsTold) {
  Stalled s([](const Stalled& now) { return base::wall_ns() > now.began + 25 * kMs; }, felt_again);
  s.run();
  EXPECT_NEAR(s.felt(0, s.began).back().force, 1.0, 0.05);  // the touch was felt
  EXPECT_GE(s.lost, 20);
}

TEST(Stall, OfSixtyLetsGoAndFadesInAgain) {
  const auto let_go = [](const Stalled& now) { return now.feels == 0 && now.dog->stalls() > 0; };
  Stalled s(let_go, felt_again);
  s.run();
  EXPECT_NEAR(s.felt(0, s.began).back().force, 1.0, 0.05);
  EXPECT_GE(s.lost, static_cast<double>((s.ended - s.began) / kMs) - 5);
  // half a second of fade-in: a tenth of it gives a fifth of the force at most
  for (const Felt& f : s.felt(s.ended, s.ended + 50 * kMs)) EXPECT_LT(f.force, 0.2);
}

TEST(Stall, OfHalfASecondDisarmsAndIsCalledAHang) {
  const auto disarmed = [](const Stalled& now) { return now.port->fault() == ForceFault::kLost; };
  Stalled s([&](const Stalled& now) { return now.hung && now.feels == 0 && disarmed(now); },
            [](const Stalled& now) { return now.ticks_after >= 300; });
  s.run();
  expect_let_go(s.felt(s.began, s.ended), s.began);
  for (const Felt& f : s.felt(s.ended, INT64_MAX)) EXPECT_EQ(f.force, 0);  // a person has to arm it again
  EXPECT_EQ(s.fault, ForceFault::kLost);
  EXPECT_GE(s.stopped, 1);
  EXPECT_GE(s.forces_off_s, 0.25) << "of 300 steps";
}

}  // namespace
}  // namespace swage::session
