// SPDX-License-Identifier: Apache-2.0
//
// One writer, one reader, fixed capacity, wait-free on both sides: commands into the step, events and records
// out of it. A full ring refuses, and the caller counts the loss; nothing ever blocks or allocates after construction.
#pragma once

#include <atomic>
#include <bit>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace swage::base {

template <class T>
class SpscRing {
  static_assert(std::is_trivially_copyable_v<T>, "what crosses a ring is plain data");

 public:
  /// Capacity is rounded up to a power of two. [main]
  explicit SpscRing(std::size_t capacity)
      : slot_(std::bit_ceil(capacity < 2 ? std::size_t{2} : capacity)), mask_(slot_.size() - 1) {}
  SpscRing(const SpscRing&) = delete;
  SpscRing& operator=(const SpscRing&) = delete;

  /// False when full. [writer]
  bool try_push(const T& value) noexcept {
    const std::size_t tail = tail_.load(std::memory_order_relaxed);
    if (tail - head_seen_ > mask_) {
      head_seen_ = head_.load(std::memory_order_acquire);
      if (tail - head_seen_ > mask_) return false;
    }
    slot_[tail & mask_] = value;
    tail_.store(tail + 1, std::memory_order_release);
    return true;
  }

  /// False when empty. [reader]
  bool try_pop(T& out) noexcept {
    const std::size_t head = head_.load(std::memory_order_relaxed);
    if (head == tail_seen_) {
      tail_seen_ = tail_.load(std::memory_order_acquire);
      if (head == tail_seen_) return false;
    }
    out = slot_[head & mask_];
    head_.store(head + 1, std::memory_order_release);
    return true;
  }

  /// Number of values in the ring at this moment. [any]
  std::size_t size() const noexcept {
    const std::size_t head = head_.load(std::memory_order_acquire);
    return tail_.load(std::memory_order_acquire) - head;
  }
  std::size_t capacity() const noexcept { return mask_ + 1; }

 private:
  // 64 B: a cache line; on one shared line every access of one side would invalidate the other's cache (false sharing)
  std::vector<T> slot_;
  const std::size_t mask_;
  alignas(64) std::atomic<std::size_t> tail_{0};  // written by the writer
  std::size_t head_seen_ = 0;                     // writer's last read of head_
  alignas(64) std::atomic<std::size_t> head_{0};  // written by the reader
  std::size_t tail_seen_ = 0;                     // reader's last read of tail_
};

}  // namespace swage::base
