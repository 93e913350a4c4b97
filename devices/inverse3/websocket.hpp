// SPDX-License-Identifier: Apache-2.0
//
// A client of the WebSocket protocol (RFC 6455) for a service on this machine or its network: text messages, no extensions, no TLS. No
// method blocks, except open() while it resolves the host's name. [main or io], one thread at a time
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
  /// Sends a close frame where the connection is open, and closes it.
  void close();
  /// Receives available bytes and sends pending ones. Returns the state.
  State progress();
  State state() const { return state_; }
  /// Why the connection ended or was not made, as a sentence; "" after close().
  const std::string& trouble() const { return trouble_; }
  /// Sends a text message. False where the connection is not open, or its peer no longer reads and it was dropped.
  bool send(std::string_view text);
  /// The next complete text message; false when there is none.
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
  std::string in_, out_;     // received bytes, and bytes to send
  std::string message_;      // fragments received so far
  bool fragmented_ = false;
  std::mt19937 random_{std::random_device{}()};  // keys and masks need not be secret from a local service
};

}  // namespace swage::inverse3
