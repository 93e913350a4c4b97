// SPDX-License-Identifier: Apache-2.0
//
// JAW1, the protocol of a jaw sensor on a serial port: lines that a person can read, or frames of 12 bytes for 1 kHz. Its table is
// in jaw_sensor.md. Pure arithmetic, no port. [any]
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace swage::sensor {

/// Bits of Reading::status.
inline constexpr uint8_t kOverRange = 1, kUnderRange = 2, kUnplugged = 4, kSupplyLow = 8, kRestarted = 16;
/// With one of these the value is not a measurement.
inline constexpr uint8_t kNoMeasurement = kOverRange | kUnderRange | kUnplugged;

/// One message of a sensor.
struct Reading {
  enum Kind : uint8_t { kNone, kJaw, kGrip, kInfo };
  Kind kind = kNone;
  uint8_t status = 0;
  uint32_t sequence = 0;  // counts to 2^32 in lines, to 2^8 in frames
  uint32_t clock_us = 0;  // the sensor's own; wraps at 2^32 in lines, at 2^16 in frames
  int32_t value = 0;      // uV for kJaw, mN for kGrip
  std::string key, text;  // kInfo: "serial", "A1"
};

/// Polynomial 0x07, start 0, over the characters between $ and *.
uint8_t crc8(std::string_view bytes);
/// CCITT: polynomial 0x1021, start 0xFFFF.
uint16_t crc16(std::string_view bytes);

/// "$JAW,7,1000,-512,00*5A\n"
std::string line(const Reading&);
/// 11 bytes of COBS and a zero at the end; value clipped to 24 bits.
std::string frame(const Reading&);

/// A line without its end, kNone when it is no whole message.
Reading parse_line(std::string_view line);
/// A frame without its zero, kNone when it is no whole message.
Reading parse_frame(std::string_view frame);

/// Cuts a stream of bytes into messages. No more than one message is kept, so a stream of rubbish costs no memory.
class Decoder {
 public:
  /// Frames end with a zero, lines with a line feed.
  void set_binary(bool binary) { binary_ = binary; }
  bool binary() const { return binary_; }
  void restart() { length_ = 0, overlong_ = true; }  // what has begun is not whole

  /// Takes one byte; a kind other than kNone when it ended a message.
  Reading take(char byte);
  uint64_t bad() const { return bad_; }  // messages that were not whole

 private:
  static constexpr std::size_t kLongest = 120;  // characters; the longest message has 64
  char buffer_[kLongest]{};
  std::size_t length_ = 0;
  uint64_t bad_ = 0;
  bool binary_ = false;
  bool overlong_ = true;  // the first message of a stream may be the end of one: it is not counted when it is bad
};

}  // namespace swage::sensor
