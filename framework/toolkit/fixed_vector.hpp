// SPDX-License-Identifier: Apache-2.0
//
// A short list on the stack, for code that must not allocate. Elements that were not added are not even initialised.
// Header-only.
#pragma once

#include <cstddef>
#include <new>
#include <type_traits>

namespace swage::toolkit {

/// Up to N elements of a type that needs no destruction. Adding to a full list is refused and returns false.
template <class T, int N>
class FixedVector {
  static_assert(std::is_trivially_destructible_v<T>);

 public:
  FixedVector() {}  // leaves the storage as it is
  FixedVector(const FixedVector& other) { *this = other; }
  FixedVector& operator=(const FixedVector& other) {
    if (this == &other) return *this;
    clear();
    for (const T& t : other) add(t);
    return *this;
  }

  bool add(const T& t) {
    if (size_ == N) return false;
    new (&data()[size_++]) T(t);
    return true;
  }
  /// Puts t before element i.
  bool insert(int i, const T& t) {
    const T copy = t;
    if (!add(copy)) return false;
    for (int k = size_ - 1; k > i; --k) data()[k] = data()[k - 1];
    data()[i] = copy;
    return true;
  }
  void clear() { size_ = 0; }
  void shrink(int size) { size_ = size; }
  int size() const { return size_; }
  bool empty() const { return size_ == 0; }
  bool full() const { return size_ == N; }

  T& operator[](int i) { return data()[i]; }
  const T& operator[](int i) const { return data()[i]; }
  T& back() { return data()[size_ - 1]; }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size_; }
  T* begin() { return data(); }
  T* end() { return data() + size_; }

 private:
  T* data() { return reinterpret_cast<T*>(bytes_); }
  const T* data() const { return reinterpret_cast<const T*>(bytes_); }

  alignas(T) std::byte bytes_[N * sizeof(T)];
  int size_ = 0;
};

}  // namespace swage::toolkit
