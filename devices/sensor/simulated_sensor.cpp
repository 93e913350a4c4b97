// SPDX-License-Identifier: Apache-2.0
#include "sensor/simulated_sensor.hpp"

#include <fcntl.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace swage::sensor {

SimulatedSensor::SimulatedSensor(Options options, Script script)
    : options_(std::move(options)), script_(std::move(script)) {}

std::string SimulatedSensor::plug(const std::string& link) {
  unplug();
  master_ = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (master_ < 0) return "";
  char name[64];
  termios settings{};
  if (grantpt(master_) != 0 || unlockpt(master_) != 0 || ptsname_r(master_, name, sizeof name) != 0 ||
      tcgetattr(master_, &settings) != 0) {
    unplug();
    return "";
  }
  cfmakeraw(&settings);
  tcsetattr(master_, TCSANOW, &settings);
  binary_ = false;
  heard_.clear();
  waiting_.clear();
  restart();
  restarted_ = false;
  if (link.empty()) return name;
  ::unlink(link.c_str());
  if (symlink(name, link.c_str()) != 0) {
    unplug();
    return "";
  }
  link_ = link;
  return link;
}

void SimulatedSensor::unplug() {
  if (!link_.empty()) ::unlink(link_.c_str());
  link_.clear();
  if (master_ >= 0) ::close(master_);
  master_ = -1;
}

void SimulatedSensor::restart() {
  sequence_ = 0;
  clock_zero_s_ = -1;
  restarted_ = true;
}

void SimulatedSensor::raw(const std::string& bytes) {
  waiting_ += bytes;
}

void SimulatedSensor::hear() {
  char bytes[256];
  for (ssize_t n = 0; (n = ::read(master_, bytes, sizeof bytes)) > 0;)
    for (ssize_t i = 0; i < n; ++i) {
      if (bytes[i] != '\n') {
        if (heard_.size() < 64) heard_ += bytes[i];
        continue;
      }
      obey(heard_);
      heard_.clear();
    }
}

void SimulatedSensor::obey(const std::string& command) {
  if (command == "B0") binary_ = false;
  if (command == "B1") {
    if (!binary_) waiting_ += '\0';  // ends a message that a reader has begun
    binary_ = true;
  }
  if (command.size() > 1 && command[0] == 'R') {
    const double hz = std::atof(command.c_str() + 1);
    if (hz >= 1 && hz <= 2000) options_.rate_hz = hz;
  }
  if (command != "?" || binary_) return;
  const auto tell = [&](const char* key, const std::string& text) {
    Reading r;
    r.kind = Reading::kInfo;
    r.key = key, r.text = text;
    waiting_ += line(r);
  };
  tell("name", options_.name);
  tell("serial", options_.serial);
  tell("fw", "1");
  tell("rate", std::to_string(std::lround(options_.rate_hz)));
  tell("channels", options_.grip ? "JAW GRP" : "JAW");
}

void SimulatedSensor::say(const Reading& reading) {
  ++sent_;
  const SimulatedFaults& f = options_.faults;
  if (silent_ || (f.lose_each != 0 && sent_ % f.lose_each == 0)) return;
  std::string bytes = binary_ ? frame(reading) : line(reading);
  if (f.corrupt_each != 0 && sent_ % f.corrupt_each == 0) bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 4);
  waiting_ += bytes;
}

void SimulatedSensor::flush(double now) {
  if (now - flushed_s_ < options_.faults.burst_s) return;
  flushed_s_ = now;
  const ssize_t n = ::write(master_, waiting_.data(), waiting_.size());
  if (n > 0) waiting_.erase(0, static_cast<std::size_t>(n));
  // without a reader a port buffers no more than this
  constexpr std::size_t kMost = 4096;
  if (waiting_.size() > kMost) waiting_.clear();
}

void SimulatedSensor::tick(double now) {
  if (master_ < 0) return;
  if (begun_s_ < 0) begun_s_ = next_s_ = now;
  hear();
  const double period = 1 / options_.rate_hz;
  next_s_ = std::max(next_s_, now - 1);  // after a long pause it does not send a thousand messages at once
  for (; next_s_ <= now; next_s_ += period) {
    if (clock_zero_s_ < 0) clock_zero_s_ = next_s_;
    const Measured m = script_(next_s_ - begun_s_);
    Reading r;
    r.kind = Reading::kJaw;
    r.sequence = sequence_++;
    r.clock_us = static_cast<uint32_t>(std::llround(1e6 * (1 + options_.faults.drift) * (next_s_ - clock_zero_s_)));
    r.status = static_cast<uint8_t>(m.status | (std::exchange(restarted_, false) ? kRestarted : 0));
    r.value = static_cast<int32_t>(std::lround(1e6 * std::clamp(m.volts, -2000.0, 2000.0)));
    say(r);
    if (!options_.grip) continue;
    r.kind = Reading::kGrip;
    r.sequence = sequence_++;
    r.value = static_cast<int32_t>(std::lround(1e3 * std::clamp(m.newtons, -1e4, 1e4)));
    say(r);
  }
  flush(now);
}

}  // namespace swage::sensor
