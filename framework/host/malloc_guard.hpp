// SPDX-License-Identifier: Apache-2.0
//
// Counts heap allocations of a thread: code on [rt] must make none. Only programs that link the object
// library swage_malloc_guard count (tests, `swage`); under a sanitizer, which replaces the allocator,
// none does.
#pragma once

#include <cstdint>

extern "C" {
/// Allocations (malloc, calloc, realloc, aligned ones; so also operator new and throw) of the calling thread
/// so far. nullptr when the program does not count. [any]
__attribute__((weak)) uint64_t swage_thread_allocations();
}

namespace swage::host {

inline bool counts_allocations() { return &swage_thread_allocations != nullptr; }
inline uint64_t thread_allocations() { return counts_allocations() ? swage_thread_allocations() : 0; }

}  // namespace swage::host
