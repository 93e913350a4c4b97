// SPDX-License-Identifier: Apache-2.0
//
// Events of spacenavd over its socket, in the protocol of all its versions: eight 32-bit numbers each. Never blocks.
// [main or io], one thread at a time
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace swage::spacemouse {

struct SpnavEvent {
  enum Type : int32_t { kMotion = 0, kPress = 1, kRelease = 2 };
  int32_t type = kMotion;
  int32_t data[7]{};  // motion: x, y, z, rx, ry, rz, ms since the last event; button: its number
};

class SpnavSocket {
 public:
  SpnavSocket() = default;
  ~SpnavSocket() { close(); }
  SpnavSocket(const SpnavSocket&) = delete;
  SpnavSocket& operator=(const SpnavSocket&) = delete;

  /// Opens a socket. `path`: "" for that of SPNAV_SOCKET or /var/run/spnav.sock. "" or the reason, with the remedy.
  std::string open(const std::string& path);
  void close();
  bool is_open() const { return file_ >= 0; }
  /// The next complete event; false when there is none, or when the daemon is gone.
  bool next(SpnavEvent& out);

 private:
  int file_ = -1;
  char buffer_[sizeof(SpnavEvent)]{};
  std::size_t have_ = 0;  // bytes received of an incomplete event
};

}  // namespace swage::spacemouse
