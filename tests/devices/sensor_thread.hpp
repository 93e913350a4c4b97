// SPDX-License-Identifier: Apache-2.0
//
// A simulated jaw sensor that runs beside a test, plugged into a port of its own.
#pragma once

#include <time.h>

#include <atomic>
#include <mutex>
#include <string>
#include <thread>

#include "sensor/sensor_link.hpp"
#include "sensor/simulated_sensor.hpp"

namespace swage::test {

inline void nap(double seconds) {
  const timespec pause{static_cast<time_t>(seconds), static_cast<long>(1e9 * (seconds - static_cast<double>(static_cast<time_t>(seconds))))};
  nanosleep(&pause, nullptr);
}

class SensorThread {
 public:
  SensorThread(const sensor::SimulatedSensor::Options& options, sensor::SimulatedSensor::Script script, std::string link)
      : sensor_(options, std::move(script)), link_(std::move(link)) {
    sensor_.plug(link_);
    thread_ = std::thread([this] {
      while (!stop_) {
        with([](sensor::SimulatedSensor& s) { s.tick(sensor::now_s()); });
        nap(0.5e-3);
      }
    });
  }
  ~SensorThread() {
    stop_ = true;
    thread_.join();
  }
  const std::string& port() const { return link_; }
  /// Does something to the sensor between two of its ticks.
  template <class F>
  void with(F change) {
    const std::lock_guard lock(mutex_);
    change(sensor_);
  }
  void plug() {
    with([&](sensor::SimulatedSensor& s) { s.plug(link_); });
  }
  void unplug() {
    with([](sensor::SimulatedSensor& s) { s.unplug(); });
  }

 private:
  std::mutex mutex_;
  sensor::SimulatedSensor sensor_;
  const std::string link_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace swage::test
