// SPDX-License-Identifier: Apache-2.0
//
// Counts what a real-time thread must not do: take or release heap memory, lock, wait, sleep, read, write, make threads.
// A definition in the program is found by every library that it loads, so plugins are counted too. Calls that the C library
// makes inside itself (the write of printf) are not seen; rusage sees those that block.
#pragma once

#include <cstdint>

namespace swage::realtime {

/// Counted calls of the calling thread.
struct Calls {
  uint64_t heap = 0;    // malloc family; operator new and throw end there
  uint64_t lock = 0;    // mutex, condition variable, read-write lock
  uint64_t sleep = 0;   // nanosleep and its relatives
  uint64_t file = 0;    // read, write, open, fsync, poll
  uint64_t thread = 0;  // pthread_create
  uint64_t all() const { return heap + lock + sleep + file + thread; }
};

/// So far, on this thread.
Calls calls();

/// False where the program cannot count, i.e. under a sanitizer, which has these functions itself.
bool counts();

inline Calls operator-(const Calls& a, const Calls& b) {
  return {a.heap - b.heap, a.lock - b.lock, a.sleep - b.sleep, a.file - b.file, a.thread - b.thread};
}

}  // namespace swage::realtime
