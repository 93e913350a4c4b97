// SPDX-License-Identifier: Apache-2.0
//
// A serial port that never makes its caller wait. [main or io], one thread at a time
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace swage::sensor {

class SerialPort {
 public:
  SerialPort() = default;
  ~SerialPort() { close(); }
  SerialPort(const SerialPort&) = delete;
  SerialPort& operator=(const SerialPort&) = delete;

  /// "" or why not, with what to do, as a sentence. `bits_per_s`: one of rates().
  std::string open(const std::string& path, int bits_per_s);
  void close();
  bool is_open() const { return file_ >= 0; }

  /// What is there now, at most `size` bytes; 0 when there is nothing. -1: it was unplugged, and is closed.
  int read(char* buffer, std::size_t size);
  /// As much as goes at once. False: it was unplugged, and is closed.
  bool write(std::string_view bytes);

  static const std::vector<int>& rates();

 private:
  int file_ = -1;
};

/// Serial adapters of this machine by their lasting names: /dev/serial/by-id/...
std::vector<std::string> serial_adapters();

}  // namespace swage::sensor
