// SPDX-License-Identifier: Apache-2.0
//
// The state of the world as bytes: saved, restored, compared, hashed. Other rooms append their memory with
// the same Writer and Reader, so that one image holds everything that the next step depends on.
//
// Threads: image_size [main]; the rest [rt], noexcept, without allocation: the buffer is reserved on [main].
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

#include "base/hash.hpp"
#include "scene/world.hpp"

namespace swage::scene {

/// Layout of the image; raise it when a field is added, removed or moved.
inline constexpr uint64_t kImageVersion = 1;

/// Hash of a stream of 8-byte words in four independent lanes, so that one multiplication need not wait for
/// the last.
class StateHash {
 public:
  void add(uint64_t word) noexcept { lane_[count_++ & 3].add(word); }
  /// Adds the words one by one, without storing each lane in between.
  void add(const std::byte* data, size_t words) noexcept {
    const auto word = [&](size_t i) {
      uint64_t w;
      std::memcpy(&w, data + 8 * i, 8);
      return w;
    };
    size_t i = 0;
    for (; i < words && (count_ & 3) != 0; ++i) add(word(i));
    base::Hash a = lane_[0], b = lane_[1], c = lane_[2], d = lane_[3];
    for (; i + 4 <= words; i += 4, count_ += 4)
      a.add(word(i)), b.add(word(i + 1)), c.add(word(i + 2)), d.add(word(i + 3));
    lane_[0] = a, lane_[1] = b, lane_[2] = c, lane_[3] = d;
    for (; i < words; ++i) add(word(i));
  }
  uint64_t value() const noexcept {
    base::Hash all(count_);
    for (const base::Hash& lane : lane_) all.add(lane.value());
    return all.value();
  }

 private:
  base::Hash lane_[4] = {base::Hash(1), base::Hash(2), base::Hash(3), base::Hash(4)};
  uint64_t count_ = 0;
};

/// Appends plain values to a buffer of fixed size, or only counts and hashes them when there is no buffer.
class Writer {
 public:
  Writer() = default;
  explicit Writer(std::span<std::byte> buffer) : buffer_(buffer), stores_(true) {}

  /// T: plain, without padding, a multiple of 8 bytes.
  template <class T>
  void put(const T& value) noexcept {
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % 8 == 0);
    put_bytes(&value, sizeof(T));
  }
  template <class T>
  void put(const std::vector<T>& values) noexcept {
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % 8 == 0);
    put_bytes(values.data(), values.size() * sizeof(T));
  }
  void put_bytes(const void* data, size_t size) noexcept;

  size_t size() const noexcept { return size_; }
  /// Hash of the values put or, with a buffer, of the buffer: an image that is kept only in case a step is repeated costs no hash.
  uint64_t hash() const noexcept;
  /// False when the buffer was too small; nothing is written past it.
  bool ok() const noexcept { return ok_; }

 private:
  std::span<std::byte> buffer_;
  bool stores_ = false, ok_ = true;
  size_t size_ = 0;
  StateHash hash_;
};

/// Reads what a Writer wrote, in the same order.
class Reader {
 public:
  explicit Reader(std::span<const std::byte> image) : image_(image) {}

  template <class T>
  void get(T& value) noexcept {
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % 8 == 0);
    get_bytes(&value, sizeof(T));
  }
  template <class T>
  void get(std::vector<T>& values) noexcept {
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % 8 == 0);
    get_bytes(values.data(), values.size() * sizeof(T));
  }
  void get_bytes(void* data, size_t size) noexcept;

  /// False when the image ended early or did not fit the world; values after the fault are not written.
  bool ok() const noexcept { return ok_; }
  void fail() noexcept { ok_ = false; }

 private:
  std::span<const std::byte> image_;
  bool ok_ = true;
};

/// Appends the world's state, headed by version and the length of every array.
void save(const World& world, Writer& out) noexcept;

/// Puts a saved state back. False, and the world untouched, when version or lengths differ from this world's.
bool restore(World& world, Reader& in) noexcept;

/// Bytes that save() appends for this world. [main]
size_t image_size(const World& world);

/// Hash of the world's state alone; equal states of equal scenes have equal hashes, bit for bit.
uint64_t hash(const World& world) noexcept;

}  // namespace swage::scene
