// SPDX-License-Identifier: Apache-2.0
//
// A simulated jaw sensor: speaks JAW1 over a pseudo terminal, with all faults of a real one. [main], one thread at a time
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "sensor/jaw1.hpp"

namespace swage::sensor {

struct SimulatedFaults {
  double drift = 0;           // relative, of its clock: a ceramic resonator is off by up to 0.005
  double burst_s = 0;         // s for which an adapter buffers bytes: 0.016 is usual for FTDI
  uint32_t corrupt_each = 0;  // every n-th message gets one wrong bit, 0: none
  uint32_t lose_each = 0;     // every n-th message is not sent
};

class SimulatedSensor {
 public:
  struct Options {
    double rate_hz = 200;
    std::string serial = "SIM1", name = "Simulated jaw sensor";
    bool grip = false;  // also sends $GRP
    SimulatedFaults faults;
  };
  /// Measured values at a time since the start [s]: V of the jaw sensor, N of the strain gauge.
  struct Measured {
    double volts = 0, newtons = 0;
    uint8_t status = 0;
  };
  using Script = std::function<Measured(double)>;

  SimulatedSensor(Options options, Script script);
  ~SimulatedSensor() { unplug(); }
  SimulatedSensor(const SimulatedSensor&) = delete;
  SimulatedSensor& operator=(const SimulatedSensor&) = delete;

  /// Opens a port from which it can be read; under the name `link` where given, else that of the terminal. "" when there is none.
  std::string plug(const std::string& link = "");
  void unplug();          // the port hangs up for its reader
  bool plugged() const { return master_ >= 0; }
  void restart();         // sequence number and clock start anew, as after a power cut
  void silent(bool on) { silent_ = on; }
  SimulatedFaults& faults() { return options_.faults; }
  void raw(const std::string& bytes);  // sends these bytes unchanged

  /// Answers requests, and sends the messages that are due by `now_s`.
  void tick(double now_s);
  uint64_t sent() const { return sent_; }

 private:
  void hear();
  void obey(const std::string& command);
  void say(const Reading& reading);
  void flush(double now_s);

  Options options_;
  Script script_;
  int master_ = -1;
  std::string link_, heard_, waiting_;
  bool binary_ = false, silent_ = false;
  double begun_s_ = -1, next_s_ = 0, clock_zero_s_ = 0, flushed_s_ = 0;
  uint32_t sequence_ = 0;
  uint64_t sent_ = 0;
  bool restarted_ = false;
};

}  // namespace swage::sensor
