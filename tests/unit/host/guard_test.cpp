// SPDX-License-Identifier: Apache-2.0
#include "host/guard.hpp"

#include <gtest/gtest.h>

#include <sched.h>

#include <atomic>
#include <clocale>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <thread>

#include "base/clock.hpp"
#include "host/sentences.hpp"

using namespace swage::host;

namespace {

// burns processor time, not wall time
void work_ns(int64_t ns) {
  const int64_t end = swage::base::cpu_ns() + ns;
  while (swage::base::cpu_ns() < end) {
  }
}

// both threads of a test on the first processor that this program may use
void pin_to_one_processor() {
  cpu_set_t allowed, one;
  CPU_ZERO(&one);
  sched_getaffinity(0, sizeof allowed, &allowed);
  int first = 0;
  while (!CPU_ISSET(first, &allowed)) ++first;
  CPU_SET(first, &one);
  sched_setaffinity(0, sizeof one, &one);
}

void sleep_ns(int64_t ns) { swage::base::sleep_until_ns(swage::base::wall_ns() + ns); }

}  // namespace

TEST(Guard, MapsResults) {
  Instance good, discards, errs, faults;
  EXPECT_TRUE(guarded(good, Call::kForces, 1, [] { return swage_result{SWAGE_OK}; }));
  EXPECT_TRUE(guarded(good, Call::kForces, 1, [] { return swage_result{7}; })) << "zero and above is success";
  EXPECT_TRUE(guarded(good, Call::kReset, 1, [] {}));
  EXPECT_FALSE(guarded(discards, Call::kForces, 1, [] { return swage_result{SWAGE_DISCARD}; }));
  EXPECT_EQ(discards.quarantined, 0u);
  EXPECT_FALSE(guarded(errs, Call::kForces, 5, [] { return swage_result{SWAGE_ERROR}; }));
  EXPECT_EQ(errs.fault, FaultKind::kError);
  EXPECT_EQ(errs.quarantine_step, 5u);
  EXPECT_FALSE(guarded(faults, Call::kForces, 5, [] { return swage_result{SWAGE_FAULT}; }));
  EXPECT_EQ(faults.fault, FaultKind::kFault);
}

TEST(Guard, StopsExceptionsAndRemembersTheFirstMisdeed) {
  Instance i;
  i.name = "needle";
  i.plugin_id = "org.example.needle";
  i.plugin_version = "1.0.0";
  EXPECT_FALSE(guarded(i, Call::kForces, 12, []() -> swage_result { throw std::runtime_error("no"); }));
  quarantine(i, FaultKind::kLate, Call::kFinish, 13);
  EXPECT_EQ(
      quarantine_text(i),
      say::kQuarantine("needle", "org.example.needle", "1.0.0", text(FaultKind::kFault), text(Call::kForces), 12));
  bool called = false;
  EXPECT_FALSE(guarded(i, Call::kForces, 14, [&] { called = true; }));
  EXPECT_FALSE(called) << "nobody in quarantine is called";
}

#if defined(__x86_64__)
TEST(Guard, RestoresTheFloatingPointMode) {
  const FpuMode before = fpu_mode();
  Instance i;
  EXPECT_FALSE(guarded(i, Call::kForces, 3, [] {
    set_fpu_mode({fpu_mode().mxcsr | 0x8040u, fpu_mode().x87});
  }));
  EXPECT_EQ(i.fault, FaultKind::kFpuMode);
  EXPECT_EQ(fpu_mode(), before);
  volatile double tiny = 1e-310;
  EXPECT_GT(tiny * 0.5, 0.0) << "subnormal numbers live";
}
#endif

TEST(Guard, AcceptsOnlyFiniteNumbersWithinTheLimit) {
  double data[5] = {0, -1, 2, 1e-310, 3};
  Instance i;
  EXPECT_TRUE(accept(i, Call::kForces, 1, data, 5, 3));
  EXPECT_FALSE(accept(i, Call::kForces, 1, data, 5, 2.5));
  EXPECT_EQ(i.fault, FaultKind::kTooLarge);
  for (const double bad :
       {std::nan(""), std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()})
    for (int at = 0; at < 5; ++at) {
      double spoilt[5] = {0, 1, 2, 3, 4};
      spoilt[at] = bad;
      Instance j;
      EXPECT_FALSE(finite(spoilt, 5));
      EXPECT_FALSE(accept(j, Call::kForces, 1, spoilt, 5, 1e9));
      EXPECT_EQ(j.fault, FaultKind::kNotFinite);
    }
  EXPECT_TRUE(finite(nullptr, 0));
}

TEST(Guard, ShowsTheCallThatIsRunning) {
  Instance i;
  guarded(i, Call::kResolve, 9, [&] {
    EXPECT_EQ(last_call.instance.load(), &i);
    EXPECT_EQ(last_call.call.load(), Call::kResolve);
    EXPECT_EQ(last_call.step.load(), 9u);
  });
  EXPECT_EQ(last_call.instance.load(), nullptr);
}

TEST(Guard, EachCallHasItsWord) {
  EXPECT_STREQ(text(Call::kCreate), "create");
  EXPECT_STREQ(text(Call::kOnSolved), "on_solved");
  EXPECT_STREQ(text(Call::kDisplacement), "displacement");
  EXPECT_STREQ(text(Call::kDraw), "draw");
  EXPECT_STREQ(text(Call::kLinearise), "linearise");
  EXPECT_STREQ(text(Call::kDisplace), "displace");
}

TEST(Guard, QuarantinesWhoIsLateByItsOwnTime) {
  Instance i;
  i.watch.budget_ns = 200'000;
  uint64_t badge_at = 0, quarantined_at = 0;
  for (uint64_t step = 1; step <= 60 && quarantined_at == 0; ++step) {
    guarded(i, Call::kForces, step, [] { work_ns(300'000); });
    if (badge_at == 0 && i.watch.badge != 0) badge_at = step;
    if (i.quarantined != 0) quarantined_at = step;
  }
  // the first overrun only raises the suspicion; the 5th and the 20th measured one count
  EXPECT_EQ(badge_at, 6u);
  EXPECT_EQ(quarantined_at, 21u);
  EXPECT_EQ(i.fault, FaultKind::kLate);
}

TEST(Guard, TimeIsCountedPerStepOverAllCalls) {
  Instance i;
  i.watch.budget_ns = 200'000;
  for (uint64_t step = 1; step <= 10; ++step)
    for (int call = 0; call < 3; ++call) guarded(i, Call::kForces, step, [] { work_ns(100'000); });
  EXPECT_EQ(i.watch.late_steps, 9u) << "one late step is one, however many calls are over the line";
  EXPECT_EQ(i.quarantined, 0u);
}

TEST(Guard, EachPartOfADividedStepHasTheBudgetOfAStep) {
  // a tenth of the budget is spent: a guest of a virtual machine is charged for what its host takes away
  Instance good, late;
  for (Instance* i : {&good, &late}) i->watch.budget_ns = 2'000'000;
  for (uint64_t step = 1; step <= 30; ++step)
    for (int part = 0; part < 4; ++part) {
      for (Instance* i : {&good, &late}) i->watch.renew();
      guarded(good, Call::kForces, step, [] { work_ns(200'000); });
      guarded(late, Call::kForces, step, [] { work_ns(3'000'000); });
    }
  EXPECT_EQ(good.watch.late_steps, 0u);
  EXPECT_EQ(late.fault, FaultKind::kLate);
  EXPECT_EQ(late.watch.late_steps, 20u) << "a step counts once, however many of its parts are over the line";
}

TEST(Guard, WhoeverIsHeldUpByTheMachineIsInnocent) {
  // this thread has a processor only when a busy one on the same processor leaves it some
  std::atomic<bool> over{false};
  std::thread busy([&] {
    pin_to_one_processor();
    while (!over) {
    }
  });
  std::thread slow([&] {
    pin_to_one_processor();
    sched_param none{};
    sched_setscheduler(0, SCHED_IDLE, &none);
    Instance i;
    i.watch.budget_ns = 2'000'000;
    // a tenth of the budget, as above: what the host of a virtual machine takes away is charged to it
    for (uint64_t step = 1; step <= 3000 && i.watch.preempted < 15; ++step)
      guarded(i, Call::kForces, step, [] { work_ns(200'000); });
    EXPECT_EQ(i.quarantined, 0u);
    EXPECT_EQ(i.watch.late_steps, 0u);
    EXPECT_GE(i.watch.preempted, 15u);
  });
  slow.join();
  over = true;
  busy.join();
}

TEST(Guard, WhoeverSleepsOrWaitsIsQuarantined) {
  Instance i;
  i.watch.budget_ns = 200'000;
  for (uint64_t step = 1; step <= 30; ++step) guarded(i, Call::kForces, step, [] { sleep_ns(2'000'000); });
  EXPECT_EQ(i.fault, FaultKind::kWaited);
  EXPECT_EQ(i.quarantine_step, 21u);

  Instance long_one;
  long_one.watch.budget_ns = 200'000;
  for (uint64_t step = 1; step <= 4; ++step) guarded(long_one, Call::kForces, step, [] { sleep_ns(130'000'000); });
  EXPECT_EQ(long_one.fault, FaultKind::kStalled) << "a quarter of a second is enough";
  EXPECT_EQ(long_one.quarantine_step, 3u);
}

TEST(Guard, ADriverMayWait) {
  Instance i;
  i.watch.budget_ns = 200'000;
  i.watch.may_wait = true;
  for (uint64_t step = 1; step <= 40; ++step) guarded(i, Call::kExchange, step, [] { sleep_ns(1'000'000); });
  EXPECT_EQ(i.quarantined, 0u);
}

TEST(Guard, TheLanguageOfTheProgramStays) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const Call call : {Call::kConfigure, Call::kForces}) {
    Instance i;
    EXPECT_FALSE(guarded(i, call, 3, [] { ASSERT_NE(std::setlocale(LC_ALL, "C.UTF-8"), nullptr); }));
    EXPECT_EQ(i.fault, FaultKind::kLocale) << text(call);
    EXPECT_EQ(before, std::setlocale(LC_ALL, nullptr));
  }
}

TEST(Guard, OldLatenessIsForgotten) {
  Instance i;
  i.watch.budget_ns = 200'000;
  uint64_t step = 0;
  // 10 late steps, then 100 good ones, five times: never 20 in any 100
  for (int round = 0; round < 5; ++round) {
    for (int k = 0; k < 10; ++k) guarded(i, Call::kForces, ++step, [] { work_ns(250'000); });
    EXPECT_EQ(i.watch.badge, 1u);
    for (int k = 0; k < 101; ++k) guarded(i, Call::kForces, ++step, [] {});
    EXPECT_EQ(i.watch.badge, 0u);
  }
  EXPECT_EQ(i.quarantined, 0u);
  EXPECT_GE(i.watch.late_steps, 40u);
}

TEST(Guard, NobodyIsTimedWithoutABudget) {
  Instance i;
  for (uint64_t step = 1; step <= 30; ++step) guarded(i, Call::kForces, step, [] { work_ns(300'000); });
  EXPECT_EQ(i.quarantined, 0u);
  EXPECT_EQ(i.watch.late_steps, 0u);
}
