// SPDX-License-Identifier: Apache-2.0
#include "sensor/sensor_link.hpp"

#include <time.h>

#include <algorithm>
#include <cmath>

namespace swage::sensor {

namespace {

// s between two attempts to reopen a port: short for a person, and long enough for a hub to settle
constexpr double kRetry = 0.25;
// s between two queries of the identity, and s after which a sensor counts as one that does not report it: a board that restarts when its
// port is opened needs two
constexpr double kAskAgain = 0.5, kSilentType = 3;
// s of silence after which an incomplete message is dropped
constexpr double kGap = 0.05;
constexpr std::size_t kMostInfo = 16;  // largest number of stored info keys of a sensor

}  // namespace

double now_s() {
  timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

std::string SensorLink::open(const LinkSettings& settings) {
  settings_ = settings;
  foreign_.set(settings.table);
  std::string why = port_.open(settings_.port, settings_.bits_per_s);
  if (why.empty()) greet();
  return why;
}

void SensorLink::greet() {
  ++connections_;
  decoder_.set_binary(false);
  decoder_.restart();
  foreign_.restart();
  clock_.reset();
  info_.clear();
  counting_ = false;
  have_ = at_ = 0;
  opened_s_ = heard_s_ = now_s();
  asked_s_ = -1e300;
}

const std::string& SensorLink::info(const std::string& key) const {
  static const std::string none;
  const auto it = info_.find(key);
  return it != info_.end() ? it->second : none;
}

// Queries identity and rate, and requests frames if wanted. A sensor that still sends frames from before is switched back to lines.
void SensorLink::ask(double now) {
  const double wait = settings_.foreign ? 1 / std::max(1.0, settings_.rate_hz > 0 ? settings_.rate_hz : 100.0) : kAskAgain;
  if (now - asked_s_ < wait) return;
  if (settings_.foreign) {
    asked_s_ = now;
    if (!settings_.table.poll.empty()) port_.write(settings_.table.poll);
    return;
  }
  if (decoder_.binary()) return;
  const bool known = !info("serial").empty(), silent = now - opened_s_ > kSilentType;
  if (known || silent) {
    if (!settings_.binary) return;
    if (port_.write("B1\n")) decoder_.set_binary(true), decoder_.restart(), counting_ = false, clock_.reset();
    return;
  }
  asked_s_ = now;
  std::string words = "B0\n?\n";
  if (settings_.rate_hz > 0) words += "R" + std::to_string(std::lround(settings_.rate_hz)) + "\n";
  port_.write(words);
}

bool SensorLink::next(double now, Measurement& out) {
  if (!port_.is_open()) {
    if (now - tried_s_ < kRetry) return false;
    tried_s_ = now;
    if (!port_.open(settings_.port, settings_.bits_per_s).empty()) return false;
    greet();
  }
  ask(now);
  for (;;) {
    if (at_ == have_) {
      at_ = have_ = 0;
      const int n = port_.read(buffer_, sizeof buffer_);
      if (n <= 0) return false;
      if (now - heard_s_ > kGap) foreign_.restart();
      heard_s_ = now;
      have_ = n;
    }
    while (at_ < have_)
      if (take(buffer_[at_++], now, out)) return true;
  }
}

bool SensorLink::take(char byte, double now, Measurement& out) {
  if (!settings_.foreign) {
    const Reading reading = decoder_.take(byte);
    return reading.kind != Reading::kNone && take_jaw1(reading, now, out);
  }
  out = {Reading::kJaw, 0, now, 0};
  return foreign_.take(byte, out.value);
}

bool SensorLink::take_jaw1(const Reading& r, double now, Measurement& out) {
  if (r.kind == Reading::kInfo) {
    if (info_.size() < kMostInfo || info_.contains(r.key)) info_[r.key] = r.text;
    return false;
  }
  const bool frames = decoder_.binary();
  if ((r.status & kRestarted) != 0 && counting_) ++restarts_, counting_ = false, clock_.reset();
  const uint32_t mask = frames ? 0xFFu : 0xFFFFFFFFu, ahead = (r.sequence - sequence_) & mask;
  // a jump back is a restart, not a loss of four thousand million messages
  if (counting_ && ahead > 1 && ahead < 1000) missed_ += ahead - 1;
  counting_ = true;
  sequence_ = r.sequence;
  out.kind = r.kind;
  out.value = (r.kind == Reading::kJaw ? 1e-6 : 1e-3) * static_cast<double>(r.value);
  out.status = r.status;
  out.time_s = clock_.stamp(r.clock_us, frames ? 16 : 32, now);
  return true;
}

}  // namespace swage::sensor
