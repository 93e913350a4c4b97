// SPDX-License-Identifier: Apache-2.0
//
// A serial port that never blocks its caller. [main or io], one thread at a time
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

  /// Opens a port. "" or the reason, with the remedy, as a sentence. `bits_per_s`: one of rates().
  std::string open(const std::string& path, int bits_per_s);
  void close();
  bool is_open() const { return file_ >= 0; }

  /// Reads the available bytes, at most `size`; 0 when there are none. -1: it was unplugged, and is now closed.
  int read(char* buffer, std::size_t size);
  /// Writes as much as possible without blocking. False: it was unplugged, and is now closed.
  bool write(std::string_view bytes);

  static const std::vector<int>& rates();

 private:
  int file_ = -1;
};

/// Serial adapters of this machine by their persistent names: /dev/serial/by-id/...
std::vector<std::string> serial_adapters();

}  // namespace swage::sensor
