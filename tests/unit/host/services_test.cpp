// SPDX-License-Identifier: Apache-2.0
#include "host/services.hpp"

#include <gtest/gtest.h>
#include <swage/display.hpp>

#include <cstring>
#include <thread>

#include "scene/world.hpp"

using namespace swage::host;

namespace {
swage_str str(const char* text) { return {text, std::strlen(text)}; }
}  // namespace

TEST(Services, RandomNumbersBelongToTheSavedState) {
  swage::scene::World world;
  world.random = {0, 0};
  const Shared shared{&world};
  Services needle("needle", shared, 0, 7), jaws("jaws", shared, 1, 7);
  const ScopedRole rt(SWAGE_THREAD_RT);
  const uint64_t saved = world.random[0];
  const uint64_t first = needle.abi()->random_u64(needle.abi());
  EXPECT_NE(first, needle.abi()->random_u64(needle.abi()));
  EXPECT_NE(first, jaws.abi()->random_u64(jaws.abi())) << "every instance has its own stream";
  world.random[0] = saved;
  EXPECT_EQ(first, needle.abi()->random_u64(needle.abi())) << "rewinding the world rewinds the stream";
  Services again("needle", {}, swage::scene::kNone, 7), other("needle", {}, swage::scene::kNone, 8);
  EXPECT_EQ(first, again.abi()->random_u64(again.abi())) << "seed and name decide, nothing else";
  EXPECT_NE(first, other.abi()->random_u64(other.abi()));
}

TEST(Services, ReportsAreKeptForPeople) {
  Services s("needle", {}, swage::scene::kNone, 0);
  s.abi()->report(s.abi(), SWAGE_WARNING, str(""), str("thin"));
  s.abi()->report(s.abi(), 99, str("arc"), str("wrong"));
  const auto reports = s.take_reports();
  ASSERT_EQ(reports.size(), 2u);
  EXPECT_EQ(reports[0].where, "needle");
  EXPECT_EQ(reports[0].severity, swage::base::Severity::kWarning);
  EXPECT_EQ(reports[1].where, "arc");
  EXPECT_EQ(reports[1].severity, swage::base::Severity::kError);
  EXPECT_TRUE(s.take_reports().empty());
}

TEST(Services, TextOnTheStepIsDroppedAndCounted) {
  Services s("needle", {}, swage::scene::kNone, 0);
  EXPECT_EQ(s.role_breaches(), 0u);
  const ScopedRole rt(SWAGE_THREAD_RT);
  s.abi()->report(s.abi(), SWAGE_NOTE, str(""), str("hello"));
  EXPECT_EQ(s.role_breaches(), 1u);
  EXPECT_TRUE(s.take_reports().empty());
}

TEST(Services, RolesBelongToThreads) {
  EXPECT_EQ(thread_role(), SWAGE_THREAD_MAIN);
  {
    const ScopedRole rt(SWAGE_THREAD_RT);
    EXPECT_EQ(thread_role(), SWAGE_THREAD_RT);
    std::thread([] { EXPECT_EQ(thread_role(), SWAGE_THREAD_MAIN); }).join();
  }
  EXPECT_EQ(thread_role(), SWAGE_THREAD_MAIN);
}

TEST(Services, ThePointerIsOfferedAndNothingElse) {
  Attempt attempt;
  attempt.pointer.dx = 0.25;
  Services with("hand", {nullptr, &attempt}, swage::scene::kNone, 0),
      without("hand", {}, swage::scene::kNone, 0);
  const auto* table =
      static_cast<const swage_host_pointer*>(with.abi()->get_extension(with.abi(), SWAGE_HOST_POINTER));
  ASSERT_NE(table, nullptr);
  EXPECT_EQ(table->read(with.abi())->dx, 0.25);
  EXPECT_EQ(table->read(without.abi())->dx, 0) << "never NULL";
  EXPECT_EQ(with.abi()->get_extension(with.abi(), "swage.host.pointer/2"), nullptr);
  EXPECT_EQ(with.abi()->get_extension(with.abi(), nullptr), nullptr);
}

TEST(Services, HowManyEyesSeeTheSceneIsSaid) {
  Attempt attempt;
  attempt.eyes = SWAGE_EYES_STEREO;
  Services with("lesson", {nullptr, &attempt}, swage::scene::kNone, 0),
      without("lesson", {}, swage::scene::kNone, 0);
  EXPECT_EQ(swage::eyes(*with.abi()), SWAGE_EYES_STEREO);
  EXPECT_EQ(swage::eyes(*without.abi()), SWAGE_EYES_NONE);
  swage_host older = *with.abi();
  older.get_extension = [](const swage_host*, const char*) -> const void* { return nullptr; };
  EXPECT_EQ(swage::eyes(older), SWAGE_EYES_NONE) << "a host that does not say";
}

TEST(FaultRing, KeepsTheLatestAndCountsTheRest) {
  FaultRing ring;
  for (int i = 0; i < 40; ++i) ring.push(i, i * 0.5, -i);
  uint64_t lost = 0;
  const auto faults = ring.take(&lost);
  ASSERT_EQ(faults.size(), FaultRing::kCapacity);
  EXPECT_EQ(lost, 8u);
  EXPECT_EQ(faults.front().code, 8);
  EXPECT_EQ(faults.back().code, 39);
  EXPECT_EQ(faults.back().a, 19.5);
  EXPECT_TRUE(ring.take(&lost).empty());
  EXPECT_EQ(lost, 0u);
}

TEST(FaultRing, TakesManyWriters) {
  FaultRing ring;
  std::vector<std::thread> writers;
  for (int w = 0; w < 3; ++w)
    writers.emplace_back([&ring, w] {
      for (int i = 0; i < 1000; ++i) ring.push(w, w, w);
    });
  uint64_t seen = 0;
  const auto look = [&] {
    uint64_t lost = 0;
    for (const Fault& f : ring.take(&lost)) {
      EXPECT_EQ(f.a, f.code) << "a torn record";
      ++seen;
    }
    seen += lost;
  };
  for (int i = 0; i < 50; ++i) look();
  for (std::thread& t : writers) t.join();
  look();
  EXPECT_EQ(seen, 3000u) << "every fault is taken or counted";
}
