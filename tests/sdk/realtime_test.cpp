// SPDX-License-Identifier: Apache-2.0
//
// On [rt] the wrapper allocates nothing, whatever it finds wrong; and without checks it does not ask for threads.
#include <gtest/gtest.h>
#include <swage/testbed.hpp>

#include <cstdlib>
#include <new>

#include "sample_plugins.hpp"

namespace {
size_t allocations = 0;
}

void* operator new(size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, size_t) noexcept { std::free(memory); }

namespace swage::test {
namespace {

size_t thread_questions = 0;

/// Counts the questions for the role of the thread.
void count_questions(testbed::Host& host) {
  host.raw.thread_kind = [](const swage_host* raw) {
    ++thread_questions;
    return testbed::Host::of(raw).role;
  };
}

TEST(Realtime, the_guard_of_an_allocation_sees_one) {
  const size_t before = allocations;
  ::operator delete(::operator new(8));
  EXPECT_EQ(allocations, before + 1);
}

TEST(Realtime, no_call_of_an_object_allocates) {
  testbed::ObjectBench<Everything> bench;
  ASSERT_TRUE(bench.start());
  bench.host.faults.reserve(100);
  const auto* solver = bench.get<swage_solver>(SWAGE_EXT_SOLVER);
  const auto* live = bench.get<swage_live>(SWAGE_EXT_LIVE);
  const auto* graspable = bench.get<swage_graspable>(SWAGE_TRAIT_GRASPABLE);
  const swage_contact_point point{};
  const swage_value value{{2e-3, 0, 0, 0}, {}};
  swage_graspable_place place{};
  double v[3], W[9], j[3] = {0, 0, 0};

  const size_t before = allocations;
  bench.forces();
  bench.finish();
  solver->advance(bench.raw, &bench.step);
  solver->mobility(bench.raw, &bench.step, 1, &point, v, W);
  solver->apply_impulses(bench.raw, &bench.step, 1, &point, j);
  live->change(bench.raw, 0, &value);
  graspable->locate(bench.raw, &bench.step, {}, &place);
  bench.raw->get_extension(bench.raw, SWAGE_TRAIT_GRIPPER);
  EXPECT_EQ(allocations, before);

  // nor does telling of a fault
  bench.raw->configure(bench.raw, nullptr, &bench.declared.raw);
  bench.raw->activate(bench.raw, 1e-3);
  EXPECT_EQ(allocations, before);
  EXPECT_EQ(bench.host.faults.size(), SWAGE_CHECKS ? 4u : 2u);
}

TEST(Realtime, threads_are_asked_for_only_where_checks_are_on) {
  testbed::ObjectBench<Everything> bench;
  count_questions(bench.host);
  ASSERT_TRUE(bench.start());
  thread_questions = 0;
  bench.forces();
  EXPECT_EQ(thread_questions, SWAGE_CHECKS ? 1u : 0u);
}

}  // namespace
}  // namespace swage::test
