// SPDX-License-Identifier: Apache-2.0
#include "websocket.hpp"

#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "handshake.hpp"
#include "sentences.hpp"

namespace swage::inverse3 {
namespace {

// bytes; normal messages have one or two thousand. A longer one does not come from this service, and would fill the memory
constexpr std::size_t kMostMessage = std::size_t{1} << 20;
constexpr std::size_t kMostHeader = 16384;
// bytes not yet accepted by the service; normally none. With so many it does not respond any more
constexpr std::size_t kMostDue = std::size_t{1} << 18;

constexpr int kContinuation = 0, kText = 1, kBinary = 2, kClose = 8, kPing = 9, kPong = 10;

}  // namespace

std::string WebSocket::open(const std::string& host, int port, const std::string& path) {
  drop("");
  addrinfo hints{}, *found = nullptr;
  hints.ai_family = AF_INET;  // on Debian "localhost" is ::1 first, where services of this kind do not listen
  hints.ai_socktype = SOCK_STREAM;
  if (const int error = getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found); error != 0)
    return trouble_ = say::kHostUnknown(host, gai_strerror(error));
  int error = ECONNREFUSED;
  for (const addrinfo* at = found; at != nullptr && file_ < 0; at = at->ai_next) {
    const int file = socket(at->ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (file < 0) continue;
    if (connect(file, at->ai_addr, at->ai_addrlen) == 0 || errno == EINPROGRESS) {
      file_ = file;
    } else {
      error = errno;
      ::close(file);
    }
  }
  freeaddrinfo(found);
  if (file_ < 0) return trouble_ = say::kHostSilent(host, port, std::strerror(error));
  const int on = 1;  // send without delay: a force must not wait for the next one (Nagle)
  setsockopt(file_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  std::string bytes;
  for (int i = 0; i < 16; ++i) bytes += static_cast<char>(random_() & 255);
  key_ = base64(bytes);
  request_ = request_text(host, port, path, key_);
  state_ = State::kConnecting;
  return "";
}

void WebSocket::drop(const std::string& why) {
  if (file_ >= 0) ::close(file_);
  file_ = -1;
  state_ = State::kClosed;
  trouble_ = why;
  in_.clear(), out_.clear(), message_.clear();
  fragmented_ = false;
}

void WebSocket::close() {
  if (state_ == State::kOpen) {
    queue(kClose, std::string_view("\x03\xe8", 2));  // 1000: normal closure
    flush();
  }
  drop("");
}

WebSocket::State WebSocket::progress() {
  if (state_ == State::kConnecting) {
    pollfd ready{file_, POLLOUT, 0};
    if (::poll(&ready, 1, 0) <= 0) return state_;
    int error = 0;
    socklen_t size = sizeof error;
    getsockopt(file_, SOL_SOCKET, SO_ERROR, &error, &size);
    if (error != 0) {
      drop(say::kSilent(std::strerror(error)));
      return state_;
    }
    out_ = request_;
    state_ = State::kOpening;
  }
  if (state_ != State::kClosed) flush();
  if (state_ != State::kClosed) read_socket();
  if (state_ == State::kOpening) shake();
  return state_;
}

void WebSocket::flush() {
  while (!out_.empty()) {
    const ssize_t n = ::send(file_, out_.data(), out_.size(), MSG_NOSIGNAL);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return;
    if (n < 0) return drop(say::kTakesNothing(std::strerror(errno)));
    out_.erase(0, static_cast<std::size_t>(n));
  }
}

void WebSocket::read_socket() {
  char bytes[4096];
  while (in_.size() < kMostMessage + sizeof bytes) {
    const ssize_t n = ::read(file_, bytes, sizeof bytes);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return;
    if (n <= 0) return drop(n == 0 ? say::kEnded() : say::kBroke(std::strerror(errno)));
    in_.append(bytes, static_cast<std::size_t>(n));
  }
}

void WebSocket::shake() {
  const std::size_t end = in_.find("\r\n\r\n");
  if (end == std::string::npos) {
    if (in_.size() > kMostHeader) drop(say::kEndless());
    return;
  }
  if (const std::string wrong = check_answer(std::string_view(in_).substr(0, end + 2), key_); !wrong.empty()) return drop(wrong);
  in_.erase(0, end + 4);
  state_ = State::kOpen;
}

// RFC 6455, 5.2: a client masks its payload
void WebSocket::queue(int opcode, std::string_view payload) {
  const std::size_t n = payload.size();
  out_ += static_cast<char>(0x80 | opcode);
  if (n < 126) {
    out_ += static_cast<char>(0x80 | n);
  } else if (n < 65536) {
    out_ += static_cast<char>(0x80 | 126);
    out_ += static_cast<char>(n >> 8 & 255);
    out_ += static_cast<char>(n & 255);
  } else {
    out_ += static_cast<char>(0x80 | 127);
    for (int shift = 56; shift >= 0; shift -= 8) out_ += static_cast<char>(uint64_t{n} >> shift & 255);
  }
  char mask[4];
  for (char& m : mask) m = static_cast<char>(random_() & 255);
  out_.append(mask, 4);
  for (std::size_t i = 0; i < n; ++i) out_ += static_cast<char>(payload[i] ^ mask[i % 4]);
}

bool WebSocket::send(std::string_view text) {
  if (state_ != State::kOpen) return false;
  if (out_.size() > kMostDue) {
    drop(say::kHangs());
    return false;
  }
  queue(kText, text);
  flush();
  return state_ == State::kOpen;
}

bool WebSocket::receive(std::string& text) {
  while (state_ == State::kOpen) {
    const std::size_t before = in_.size();
    if (take_frame(text)) return true;
    if (in_.size() == before) return false;
  }
  return false;
}

// Takes one frame from the received bytes. True when it completes a text message.
bool WebSocket::take_frame(std::string& text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(in_[i]); };
  if (in_.size() < 2) return false;
  const bool last = (byte(0) & 0x80) != 0, control = (byte(0) & 8) != 0;
  const int opcode = byte(0) & 15;
  std::size_t header = 2;
  uint64_t size = byte(1) & 127;
  if ((byte(0) & 0x70) != 0 || (byte(1) & 0x80) != 0) return drop(say::kNoServerFrame()), false;
  if (control && (size > 125 || !last)) return drop(say::kNoControl()), false;
  if (size >= 126) {
    const std::size_t more = size == 126 ? 2 : 8;
    if (in_.size() < 2 + more) return false;
    size = 0;
    for (std::size_t i = 0; i < more; ++i) size = size << 8 | byte(2 + i);
    header += more;
  }
  if (size > kMostMessage || message_.size() + size > kMostMessage) return drop(say::kHuge()), false;
  if (in_.size() < header + size) return false;
  const std::string payload = in_.substr(header, static_cast<std::size_t>(size));
  in_.erase(0, header + static_cast<std::size_t>(size));
  if (control) return take_control(opcode, payload);
  if ((opcode == kContinuation) != fragmented_ || opcode > kBinary) return drop(say::kFrameOrder()), false;
  message_ += payload;
  fragmented_ = !last;
  if (fragmented_) return false;
  text = std::move(message_);
  message_.clear();
  return true;
}

bool WebSocket::take_control(int opcode, const std::string& payload) {
  if (opcode == kPing) {
    queue(kPong, payload);
    flush();
  } else if (opcode == kClose) {
    queue(kClose, payload.substr(0, 2));
    flush();
    drop(say::kEnded());
  } else if (opcode != kPong) {
    drop(say::kNoControl());
  }
  return false;
}

}  // namespace swage::inverse3
