// SPDX-License-Identifier: Apache-2.0
#include "session/device_ports.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "fake_device.hpp"

namespace swage::session {
namespace {

using namespace std::chrono_literals;

step::ToolForce push(double fx) {
  step::ToolForce f;
  f.force.x = fx;
  f.anchor.q.w = 1;
  return f;
}

// Sends forces like a step does, once per millisecond, until `done`: CTest's limit ends what never comes. A machine that was
// held up for 200 ms disarms rightly; that is not what is asked here.
template <class F>
void step_until(Port& port, double fx, F done) {
  while (!done()) {
    port.send(push(fx));
    if (port.fault() == ForceFault::kLost) port.arm();
    std::this_thread::sleep_for(1ms);
  }
}

// the step says nothing until `done`
template <class F>
void silent_until(F done) {
  while (!done()) std::this_thread::sleep_for(1ms);
}

TEST(IoPort, CarriesSamplesFromItsOwnThread) {
  FakeDevice device(0, 0);
  host::DeviceSlot slot = device.slot();
  IoPort port(slot, nullptr);
  device.position = 0.25;
  port.start();
  swage_sample sample{};
  step_until(port, 0, [&] {
    port.read(0, 0, sample);
    return sample.sequence > 5;
  });
  EXPECT_EQ(sample.pose.p.x, 0.25);
  step_until(port, 0, [&] { return !port.stale(); });
  device.frozen = true;
  step_until(port, 0, [&] { return port.stale(); });
}

TEST(IoPort, WhatIsOldIsNotValidAnyMore) {
  FakeDevice device(0, 0);
  host::DeviceSlot slot = device.slot();
  IoPort port(slot, nullptr);
  port.start();
  swage_sample sample{};
  step_until(port, 0, [&] {
    port.read(0, 0, sample);
    return sample.valid == SWAGE_VALID_POSE && port.lost_s() < 0.05;
  });
  device.frozen = true;
  step_until(port, 0, [&] {
    port.read(0, 0, sample);
    return sample.valid == 0;
  });
  EXPECT_TRUE(port.stale());
  step_until(port, 0, [&] { return port.lost_s() > 0.5; });
  device.frozen = false;
  // by the scene's time it was lost for no time yet: it is heard once that has gone on
  double time_s = 0;
  step_until(port, 0, [&] {
    port.read(0, time_s += 1e-3, sample);
    return sample.valid == SWAGE_VALID_POSE && port.lost_s() < 0.05;
  });
}

TEST(IoPort, GivesForceOnlyWhileTheStepGoesOn) {
  FakeDevice device(SWAGE_DEVICE_FORCE, 2);
  host::DeviceSlot slot = device.slot();
  IoPort port(slot, nullptr);
  port.start();
  step_until(port, 1, [&] { return device.exchanges > 20; });
  EXPECT_EQ(device.most.load(), 0);  // nobody has armed it
  port.arm();
  step_until(port, 1, [&] { return device.force > 0.3; });
  // the step falls silent: no force; and after 200 ms disarmed, needs a person
  silent_until([&] { return device.force == 0; });
  silent_until([&] { return port.fault() == ForceFault::kLost; });
  EXPECT_EQ(device.force.load(), 0);
  port.arm();
  step_until(port, 1, [&] { return device.force > 0.1; });
  port.disarm();
  step_until(port, 1, [&] { return device.force == 0; });
}

TEST(IoPort, ReleasesTheHandWhenTheWatchdogSaysSo) {
  FakeDevice device(SWAGE_DEVICE_FORCE, 2);
  host::DeviceSlot slot = device.slot();
  std::atomic<bool> stalled{false};
  IoPort port(slot, &stalled);
  port.start();
  port.arm();
  step_until(port, 1, [&] { return device.force > 0.2; });
  stalled = true;
  step_until(port, 1, [&] { return device.force == 0; });
}

TEST(IoPort, TakesTheForceAwayWhenItLeaves) {
  FakeDevice device(SWAGE_DEVICE_FORCE, 2);
  host::DeviceSlot slot = device.slot();
  IoPort port(slot, nullptr);
  port.start();
  port.arm();
  step_until(port, 1, [&] { return device.force > 0.2; });
  port.stop();
  EXPECT_EQ(device.force.load(), 0);
}

TEST(IoPort, NeverGivesMoreThanTheDeviceBears) {
  FakeDevice device(SWAGE_DEVICE_FORCE, 0.5);
  host::DeviceSlot slot = device.slot();
  IoPort port(slot, nullptr);
  port.start();
  port.arm();
  step_until(port, 100, [&] { return device.force > 0.49; });
  EXPECT_LE(device.most.load(), 0.5 + 1e-12);
}

TEST(IoPort, ADeviceThatThrowsIsLeftAlone) {
  FakeDevice device(0, 0);
  host::DeviceSlot slot = device.slot();
  IoPort port(slot, nullptr);
  device.throws = true;
  port.start();
  step_until(port, 0, [&] { return slot.instance->quarantined.load() != 0; });
  port.stop();
  EXPECT_EQ(device.exchanges.load(), 1u);
}

TEST(StepPort, IsAskedOncePerStepAndGuardsItsForce) {
  FakeDevice device(SWAGE_DEVICE_FORCE | SWAGE_DEVICE_LOCKSTEP, 2);
  host::DeviceSlot slot = device.slot();
  StepPort port(slot, 1e-3, true);
  port.arm();
  swage_sample sample{};
  for (uint64_t i = 0; i < 600; ++i) {
    port.read(i, static_cast<double>(i) * 1e-3, sample);
    port.send(push(5));
  }
  EXPECT_EQ(device.exchanges.load(), 600u);
  EXPECT_NEAR(device.force.load(), 1.75, 0.3);  // 2 N, or what the motors bear for ever
  EXPECT_LE(device.most.load(), 2.0 + 1e-12);
  EXPECT_EQ(sample.time_s, 0.599);
}

TEST(StepPort, GivesNoForceInRealTime) {
  FakeDevice device(SWAGE_DEVICE_FORCE | SWAGE_DEVICE_LOCKSTEP, 2);
  host::DeviceSlot slot = device.slot();
  StepPort port(slot, 1e-3, false);
  port.arm();
  swage_sample sample{};
  for (uint64_t i = 0; i < 600; ++i) {
    port.read(i, 0, sample);
    port.send(push(5));
  }
  EXPECT_EQ(device.most.load(), 0);
}

}  // namespace
}  // namespace swage::session
