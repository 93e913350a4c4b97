// SPDX-License-Identifier: Apache-2.0
//
// A daemon of a few lines in the place of spacenavd.
#pragma once

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <initializer_list>
#include <string>
#include <utility>

#include "spacemouse/spnav.hpp"

namespace swage::test {

using spacemouse::SpnavEvent;

/// Listens like spacenavd; tells whoever has come.
class Daemon {
 public:
  explicit Daemon(std::string path) : path_(std::move(path)) { start(); }
  ~Daemon() { stop(); }
  void start() {
    listener_ = socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path, path_.c_str(), path_.size());
    ::unlink(path_.c_str());
    EXPECT_EQ(bind(listener_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(listen(listener_, 4), 0);
  }
  void stop() {
    if (client_ >= 0) ::close(client_);
    if (listener_ >= 0) ::close(listener_);
    client_ = listener_ = -1;
    ::unlink(path_.c_str());
  }
  void tell(int32_t type, std::initializer_list<int32_t> data, std::size_t bytes = sizeof(SpnavEvent)) {
    SpnavEvent e;
    e.type = type;
    std::copy(data.begin(), data.end(), e.data);
    send(&e, bytes);
  }
  void send(const void* data, std::size_t bytes) {
    if (const int next = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC); next >= 0) {
      if (client_ >= 0) ::close(client_);
      client_ = next;
    }
    EXPECT_TRUE(client_ < 0 || ::send(client_, data, bytes, MSG_NOSIGNAL) == static_cast<ssize_t>(bytes));
  }

 private:
  const std::string path_;
  int listener_ = -1, client_ = -1;
};

}  // namespace swage::test
