// SPDX-License-Identifier: Apache-2.0
//
// Readers that speak a protocol of their own: a table says how a message ends, what its number is, and what it means. Such a
// message has no check and no clock. [any]
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace swage::sensor {

struct ForeignTable {
  enum Format : int32_t { kText, kU16BigEnd, kU16LittleEnd, kI16BigEnd, kI16LittleEnd, kI24BigEnd };
  Format format = kText;
  std::string poll;   // bytes that ask for one message, "" when it speaks unasked
  std::string end;    // bytes that end a message; "" where it is known by its length
  int length = 0;     // bytes of a message that is no text, with its end
  int at = 0;         // byte at which its number begins; of text: which number, counted from 0
  double scale = 1;   // V per unit
  double offset = 0;  // V
};

/// "" or what is wrong with a table, as a sentence.
std::string check_table(const ForeignTable& table);
/// "\r" "\n" "\t" "\0" "\\" "\x1b" as bytes.
std::string unescaped(const std::string& text);

class ForeignDecoder {
 public:
  void set(const ForeignTable& table) { table_ = table, restart(); }
  void restart() { buffer_.clear(); }  // a new message begins: it was asked for, or nothing came for long
  /// Takes one byte. True when it ended a message; `volts` then has its value.
  bool take(char byte, double& volts);
  uint64_t bad() const { return bad_; }

 private:
  bool value(double& volts) const;
  ForeignTable table_;
  std::string buffer_;
  uint64_t bad_ = 0;
};

}  // namespace swage::sensor
