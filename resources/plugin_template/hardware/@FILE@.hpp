// SPDX-License-Identifier: Apache-2.0
//
// @ID@: a tracker on a serial port, which writes a line "x y z closure" for each measurement: millimetres, and 0 open to 1 closed.
#pragma once

#include <swage/device.hpp>

#include <array>
#include <cstddef>
#include <string>

struct @NAME@Params {
  std::string port = "/dev/ttyUSB0";
};

class @NAME@ final : public swage::Device<@NAME@Params> {
 public:
  static constexpr auto id = "@ID@";
  static constexpr auto version = "0.1.0";
  static constexpr auto name = "@TITLE@";
  static constexpr auto summary = "A tracker on a serial port.";
  static constexpr auto author = "Somebody";
  static constexpr auto licence = "Apache-2.0";

  // not LOCKSTEP: exchange() is called 500 times a second on a thread of its own
  static constexpr swage::DeviceCard card = {.rate_hz = 500};

  static constexpr std::array fields = {
      swage::text<&@NAME@Params::port>("port", "Port", "Serial port of the tracker."),
  };

  void open() override;
  void close() override;
  void exchange(const swage_command& command, swage_sample& sample) override;

 private:
  bool connect();
  bool hear(swage_sample& sample);
  bool take(const char* begin, const char* end, swage_sample& sample) const;

  int file_ = -1;
  double tried_s_ = 0;             // monotonic clock at the last attempt to open the port
  std::array<char, 256> heard_{};  // characters of a line whose end has not arrived
  std::size_t n_heard_ = 0;
};
