// SPDX-License-Identifier: Apache-2.0
//
// The newest complete value of a plain struct, from one writer to many readers. The writer never waits; a reader
// that was overtaken (eight publications during one copy) tries again.
//
// Each slot has a sequence number: odd while it is written. The words are atomics: stored with release
// and loaded with acquire, so a reader that saw one word of a newer value must also see that the number has
// changed. On x86 these are plain moves, there are no fences, and ThreadSanitizer models every access.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <type_traits>

namespace swage::base {

template <class T, std::size_t kSlots = 8>
class SnapshotRing {
  static_assert(std::is_trivially_copyable_v<T>, "a snapshot is plain data");

 public:
  SnapshotRing() : slot_(std::make_unique<Slot[]>(kSlots)) {}

  /// Copies only the first `bytes` of the value; behind them readers get older contents. [writer]
  /// wait-free
  void publish(const T& value, std::size_t bytes = sizeof(T)) noexcept {
    const std::size_t words = bytes < sizeof(T) ? (bytes + 7) / 8 : kWords;
    const uint64_t n = published_.load(std::memory_order_relaxed) + 1;
    Slot& slot = slot_[n % kSlots];
    slot.sequence.store(2 * n - 1, std::memory_order_relaxed);
    const char* from = reinterpret_cast<const char*>(&value);
    for (std::size_t i = 0; i < words; ++i) {
      uint64_t word = 0;
      std::memcpy(&word, from + 8 * i, bytes_of(i));
      slot.word[i].store(word, std::memory_order_release);
    }
    slot.sequence.store(2 * n, std::memory_order_release);
    published_.store(n, std::memory_order_release);
  }

  /// Number of publications so far; 0 before the first. [any]
  uint64_t published() const noexcept { return published_.load(std::memory_order_acquire); }

  /// Copies the newest complete value. Returns its publication number, 0 before the first. [any] lock-free
  uint64_t latest(T& out) const noexcept {
    for (;;) {
      const uint64_t n = published_.load(std::memory_order_acquire);
      if (n == 0) return 0;
      if (read(n, out)) return n;
    }
  }

 private:
  static constexpr std::size_t kWords = (sizeof(T) + 7) / 8;
  struct Slot {
    std::atomic<uint64_t> sequence{0};
    std::atomic<uint64_t> word[kWords];
  };

  static constexpr std::size_t bytes_of(std::size_t i) {
    return i + 1 < kWords ? 8 : sizeof(T) - 8 * (kWords - 1);
  }

  bool read(uint64_t n, T& out) const noexcept {
    const Slot& slot = slot_[n % kSlots];
    if (slot.sequence.load(std::memory_order_acquire) != 2 * n) return false;
    char* to = reinterpret_cast<char*>(&out);
    for (std::size_t i = 0; i < kWords; ++i) {
      const uint64_t word = slot.word[i].load(std::memory_order_acquire);
      std::memcpy(to + 8 * i, &word, bytes_of(i));
    }
    return slot.sequence.load(std::memory_order_relaxed) == 2 * n;
  }

  std::unique_ptr<Slot[]> slot_;
  alignas(64) std::atomic<uint64_t> published_{0};
};

}  // namespace swage::base
