// SPDX-License-Identifier: Apache-2.0
//
// Sensors with a protocol of their own: a table gives the end of a message, the place of its number, and its unit. Such a
// message has neither checksum nor clock. [any]
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace swage::sensor {

struct ForeignTable {
  enum Format : int32_t { kText, kU16BigEnd, kU16LittleEnd, kI16BigEnd, kI16LittleEnd, kI24BigEnd };
  Format format = kText;
  std::string poll;   // bytes that request one message, "" where it is sent unasked
  std::string end;    // bytes that end a message; "" where its length is fixed
  int length = 0;     // bytes of a binary message, with its end
  int at = 0;         // first byte of the number; in text: index of the number, from 0
  double scale = 1;   // V per unit
  double offset = 0;  // V
};

/// "" or the fault of a table, as a sentence.
std::string check_table(const ForeignTable& table);
/// Replaces the escapes "\r" "\n" "\t" "\0" "\\" "\x1b" by bytes.
std::string unescaped(const std::string& text);

class ForeignDecoder {
 public:
  void set(const ForeignTable& table) { table_ = table, restart(); }
  void restart() { buffer_.clear(); }  // a new message begins: after a request, or after a long silence
  /// Takes one byte. True when it ended a message, whose value is then in `volts`.
  bool take(char byte, double& volts);
  uint64_t bad() const { return bad_; }

 private:
  bool value(double& volts) const;
  ForeignTable table_;
  std::string buffer_;
  uint64_t bad_ = 0;
};

}  // namespace swage::sensor
