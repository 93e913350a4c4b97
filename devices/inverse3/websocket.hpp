// SPDX-License-Identifier: Apache-2.0
//
// A client of the WebSocket protocol (RFC 6455) for a service on this machine or its network: text messages, no extensions, no TLS. No
// method waits, but open() for the name of the host. [main or io], one thread at a time
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <string_view>

namespace swage::inverse3 {

class WebSocket {
 public:
  enum class State { kClosed, kConnecting, kOpening, kOpen };

  WebSocket() = default;
  ~WebSocket() { drop(""); }
  WebSocket(const WebSocket&) = delete;
  WebSocket& operator=(const WebSocket&) = delete;

  /// Begins to connect. "" or why it cannot, as a sentence.
  std::string open(const std::string& host, int port, const std::string& path);
  /// Says good-bye where the connection is open, and ends it.
  void close();
  /// Takes what has come and sends what is due. After it: the state.
  State progress();
  State state() const { return state_; }
  /// Why the connection ended or was not made, as a sentence; "" after close().
  const std::string& trouble() const { return trouble_; }
  /// A text message. False where the connection is not open, or takes nothing any more and has been dropped.
  bool send(std::string_view text);
  /// The next text message that has come whole; false when there is none.
  bool receive(std::string& text);

 private:
  void drop(const std::string& why);
  void flush();
  void read_socket();
  void shake();
  void queue(int opcode, std::string_view payload);
  bool take_frame(std::string& text);
  bool take_control(int opcode, const std::string& payload);

  State state_ = State::kClosed;
  int file_ = -1;
  std::string key_, request_, trouble_;
  std::string in_, out_;     // bytes as they came, and those that are due
  std::string message_;      // of which fragments have come
  bool fragmented_ = false;
  std::mt19937 random_{std::random_device{}()};  // keys and masks need not be secret from a local service
};

}  // namespace swage::inverse3
