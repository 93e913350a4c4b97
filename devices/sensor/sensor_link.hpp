// SPDX-License-Identifier: Apache-2.0
//
// A jaw sensor on a port: queries its identity, reads it, and reopens it after it was unplugged. Never blocks. One thread at a
// time, [main] or [io].
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "sensor/clock_map.hpp"
#include "sensor/foreign.hpp"
#include "sensor/jaw1.hpp"
#include "sensor/serial_port.hpp"

namespace swage::sensor {

struct LinkSettings {
  std::string port;
  int bits_per_s = 115200;
  bool binary = false;   // JAW1 frames instead of lines
  double rate_hz = 0;    // requested of the sensor; 0: its own rate
  bool foreign = false;  // uses `table` instead of JAW1
  ForeignTable table;
};

/// One measurement.
struct Measurement {
  Reading::Kind kind = Reading::kNone;
  double value = 0;   // V of kJaw, N of kGrip
  double time_s = 0;  // time of the measurement, on CLOCK_MONOTONIC
  uint8_t status = 0;
};

class SensorLink {
 public:
  /// Opens the port. "" or the reason, as a sentence.
  std::string open(const LinkSettings& settings);
  void close() { port_.close(); }

  /// The next measurement that has arrived by `now_s`; false when there is none. Tries to reopen a lost port.
  bool next(double now_s, Measurement& out);

  bool plugged() const { return port_.is_open(); }
  uint32_t connections() const { return connections_; }  // number of times that the port was opened
  uint32_t restarts() const { return clock_.restarts() + restarts_; }
  uint64_t bad() const { return decoder_.bad() + foreign_.bad(); }  // number of invalid messages
  uint64_t missed() const { return missed_; }                       // sequence numbers skipped between messages
  double drift() const { return clock_.drift(); }
  /// Value that the sensor has reported since it was last plugged in: "serial", "name", "fw", "rate". "" where it has not.
  const std::string& info(const std::string& key) const;

 private:
  void greet();
  void ask(double now_s);
  bool take(char byte, double now_s, Measurement& out);
  bool take_jaw1(const Reading& reading, double now_s, Measurement& out);

  LinkSettings settings_;
  SerialPort port_;
  Decoder decoder_;
  ForeignDecoder foreign_;
  ClockMap clock_;
  std::map<std::string, std::string> info_;
  char buffer_[512]{};
  int have_ = 0, at_ = 0;
  double opened_s_ = 0, asked_s_ = -1e300, tried_s_ = -1e300, heard_s_ = 0;
  uint32_t connections_ = 0, restarts_ = 0, sequence_ = 0;
  bool counting_ = false;
  uint64_t missed_ = 0;
};

/// Present time of CLOCK_MONOTONIC, s.
double now_s();

}  // namespace swage::sensor
