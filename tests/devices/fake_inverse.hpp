// SPDX-License-Identifier: Apache-2.0
//
// A service on a socket of its own in the place of Haply's: greets with everything that it knows, then answers each message with one.
// It checks its caller: masked frames, one message at a time, finite and bounded forces of bounded slew, none at the end.
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <utility>

#include "inverse3/handshake.hpp"
#include "sensor_thread.hpp"

namespace swage::test {

class FakeInverse {
 public:
  enum class Manners { kGood, kSilent, kNoWebSocket, kWrongKey, kRubbish, kFragments, kHuge };

  explicit FakeInverse(Manners manners = Manners::kGood) : manners_(manners) { start(); }
  ~FakeInverse() { stop(); }
  int port() const { return port_; }
  bool running() const { return running_; }

  void start() {
    listener_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const int on = 1;
    setsockopt(listener_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<uint16_t>(port_));
    socklen_t size = sizeof address;
    if (bind(listener_, reinterpret_cast<sockaddr*>(&address), size) != 0 || listen(listener_, 4) != 0) return blame("cannot listen");
    getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
    port_ = ntohs(address.sin_port);
    running_ = true;
    thread_ = std::thread([this] { run(); });
  }
  void stop() {
    running_ = false;
    if (thread_.joinable()) thread_.join();
    if (listener_ >= 0) ::close(listener_);
    listener_ = -1;
  }

  // what the test moves; metres and newtons in Haply's axes: x right, y forward, z up
  std::atomic<double> battery{0.5};  // share
  std::atomic<double> x{0}, y{0}, z{0}, vx{0}, qw{1}, qx{0}, qy{0}, qz{0};
  std::atomic<uint32_t> buttons{0};
  std::atomic<bool> arm{true}, grip{true}, newer{true}, answers{true};
  std::atomic<double> limit{3};  // N, above which a force is blamed
  // what it heard
  std::atomic<double> fx{0}, fy{0}, fz{0}, most{0}, jump{0};
  std::atomic<unsigned long> forces{0}, hellos{0}, byes{0};

  std::string wrong() const {
    const std::lock_guard<std::mutex> guard(lock_);
    return wrong_;
  }
  nlohmann::json state(bool whole) const {
    using Json = nlohmann::json;
    const auto v = [](double a, double b, double c) { return Json{{"x", a}, {"y", b}, {"z", c}}; };
    Json out = {{"session_id", 7}, {"inverse3", Json::array()}, {"wireless_verse_grip", Json::array()}};
    if (arm) {
      Json one = {{"device_id", "049D"}, {"state", {{"cursor_position", v(x, y, z)}, {"cursor_velocity", v(vx, 0, 0)}}}};
      if (whole) one["config"] = {{"type", "inverse3"}, {"handedness", "right"}};
      if (whole && newer) one["config"]["preset"] = "defaults";
      out["inverse3"].push_back(one);
    }
    if (grip) {
      const uint32_t down = buttons;
      out["wireless_verse_grip"].push_back({{"device_id", "61576"},
                                            {"state",
                                             {{"orientation", {{"w", qw.load()}, {"x", qx.load()}, {"y", qy.load()}, {"z", qz.load()}}},
                                              {"battery_level", battery.load()},
                                              {"buttons", {{"a", (down & 1) != 0}, {"b", (down & 2) != 0}, {"c", (down & 4) != 0}}}}}});
    }
    return out;
  }

 private:
  void blame(const std::string& what) {
    const std::lock_guard<std::mutex> guard(lock_);
    if (wrong_.find(what) == std::string::npos) wrong_ += what + "; ";
  }
  void run() {
    while (running_) {
      pollfd ready{listener_, POLLIN, 0};
      if (::poll(&ready, 1, 5) <= 0) continue;
      const int client = accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
      if (client < 0) continue;
      const int on = 1;
      setsockopt(client, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
      serve(client);
      ::close(client);
    }
  }
  static void say(int client, const std::string& bytes) {
    for (std::size_t at = 0; at < bytes.size();) {
      const ssize_t n = ::send(client, bytes.data() + at, bytes.size() - at, MSG_NOSIGNAL);
      if (n < 0 && errno != EAGAIN) return;
      at += n > 0 ? static_cast<std::size_t>(n) : 0;
    }
  }
  static std::string frame(int opcode, bool last, const std::string& payload) {
    std::string out(1, static_cast<char>((last ? 0x80 : 0) | opcode));
    if (payload.size() < 126) {
      out += static_cast<char>(payload.size());
    } else {
      out += static_cast<char>(126);
      out += static_cast<char>(payload.size() >> 8);
      out += static_cast<char>(payload.size() & 255);
    }
    return out + payload;
  }
  void tell(int client, bool whole) {
    const std::string text = state(whole).dump();
    if (manners_ == Manners::kRubbish) return say(client, frame(1, true, "{\"inverse3\": [{\"state\": {\"cursor_position\": 7}}, nul"));
    if (manners_ == Manners::kHuge) return say(client, std::string("\x81\x7f\0\0\0\1\0\0\0\0", 10));
    if (manners_ != Manners::kFragments) return say(client, frame(1, true, text));
    // three fragments with a ping between them, and a pong that nobody asked for
    const std::size_t third = text.size() / 3;
    say(client, frame(1, false, text.substr(0, third)) + frame(9, true, "are you there"));
    say(client, frame(0, false, text.substr(third, third)) + frame(10, true, ""));
    say(client, frame(0, true, text.substr(2 * third)));
  }
  bool greet(int client, std::string& in) {
    const std::size_t end = in.find("\r\n\r\n");
    if (end == std::string::npos) return false;
    const std::size_t at = in.find("Sec-WebSocket-Key: "), stop = in.find("\r\n", at);
    const std::string key = at == std::string::npos ? "" : in.substr(at + 19, stop - at - 19);
    if (key.size() != 24) blame("a key that is none");
    in.erase(0, end + 4);
    if (manners_ == Manners::kNoWebSocket) return say(client, "HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\n\r\n"), false;
    const std::string accept = manners_ == Manners::kWrongKey ? "bm9uZQ==" : inverse3::accept_for(key);
    say(client, "HTTP/1.1 101 Switching Protocols\r\nupgrade: WebSocket\r\nConnection: keep-alive, Upgrade\r\nSec-WebSocket-Accept: " + accept + "\r\n\r\n");
    ++hellos;
    tell(client, true);
    return true;
  }
  void serve(int client) {
    std::string in;
    bool open = false;
    double last[3] = {0, 0, 0}, looked_s = sensor::now_s();
    while (running_) {
      pollfd ready{client, POLLIN, 0};
      if (::poll(&ready, 1, 2) <= 0) {
        looked_s = sensor::now_s();
        continue;
      }
      char bytes[4096];
      const ssize_t n = ::read(client, bytes, sizeof bytes);
      const double held_s = sensor::now_s() - std::exchange(looked_s, sensor::now_s());
      if (n == 0 || (n < 0 && errno != EAGAIN)) {
        if (open && last[0] * last[0] + last[1] * last[1] + last[2] * last[2] > 0) blame("left under force");
        return;
      }
      in.append(bytes, static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
      if (manners_ == Manners::kSilent) continue;
      if (!open && !(open = greet(client, in))) continue;
      const unsigned long before = texts_;
      while (take(client, in, last)) {
      }
      // a service that the machine has held up is asked again every 0.1 s
      if (texts_ > before + 1 + static_cast<unsigned long>(held_s / 0.1) && answers) blame("two messages at a time");
    }
  }
  // one frame of the caller
  bool take(int client, std::string& in, double* last) {
    if (in.size() < 6) return false;
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(in[i]); };
    if ((byte(1) & 0x80) == 0) blame("a frame without a mask");
    std::size_t size = byte(1) & 127u, header = 2;
    if (size == 126) {
      size = byte(2) * 256u + byte(3);
      header = 4;
    }
    if (in.size() < header + 4 + size) return false;
    std::string payload = in.substr(header + 4, size);
    for (std::size_t i = 0; i < size; ++i) payload[i] = static_cast<char>(payload[i] ^ in[header + i % 4]);
    const int opcode = byte(0) & 15;
    in.erase(0, header + 4 + size);
    if (opcode == 10) return payload == "are you there" ? true : (blame("a pong for no ping"), true);
    if (opcode == 8) return ++byes, true;
    ++texts_;
    obey(payload, last);
    if (answers) tell(client, false);
    return true;
  }
  void obey(const std::string& payload, double* last) {
    const auto message = nlohmann::json::parse(payload, nullptr, false);
    if (!message.is_object()) return blame("a message that is no JSON");
    if (message.contains("session")) return;
    const auto& one = message["inverse3"][0];
    if (one["device_id"] != "049D") blame("a force for another arm");
    const auto& command = one["commands"]["set_cursor_force"];
    const char* key = newer ? "vector" : "values";
    if (!command.contains(key)) return blame("a force in the words of another version");
    const double f[3] = {command[key]["x"].get<double>(), command[key]["y"].get<double>(), command[key]["z"].get<double>()};
    const double size = std::hypot(f[0], f[1], f[2]), change = std::hypot(f[0] - last[0], f[1] - last[1], f[2] - last[2]);
    if (!std::isfinite(size)) blame("a force that is no number");
    if (size > limit + 1e-9) blame("a force above the limit");
    if (size > most) most = size;
    if (change > jump) jump = change;
    fx = last[0] = f[0], fy = last[1] = f[1], fz = last[2] = f[2];
    ++forces;
  }

  const Manners manners_;
  mutable std::mutex lock_;
  std::string wrong_;
  unsigned long texts_ = 0;
  int listener_ = -1, port_ = 0;
  std::atomic<bool> running_{false};
  std::thread thread_;
};

}  // namespace swage::test
