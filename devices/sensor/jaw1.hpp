// SPDX-License-Identifier: Apache-2.0
//
// JAW1, the protocol of a jaw sensor on a serial port: human-readable lines, or frames of 12 bytes for 1 kHz. Its table is
// in jaw_sensor.md. Pure arithmetic, no port. [any]
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace swage::sensor {

/// Bits of Reading::status.
inline constexpr uint8_t kOverRange = 1, kUnderRange = 2, kUnplugged = 4, kSupplyLow = 8, kRestarted = 16;
/// With one of these bits the value is not a measurement.
inline constexpr uint8_t kNoMeasurement = kOverRange | kUnderRange | kUnplugged;

/// One message of a sensor.
struct Reading {
  enum Kind : uint8_t { kNone, kJaw, kGrip, kInfo };
  Kind kind = kNone;
  uint8_t status = 0;
  uint32_t sequence = 0;  // counts to 2^32 in lines, to 2^8 in frames
  uint32_t clock_us = 0;  // us, the sensor's own clock; wraps at 2^32 in lines, at 2^16 in frames
  int32_t value = 0;      // uV for kJaw, mN for kGrip
  std::string key, text;  // kInfo: "serial", "A1"
};

/// CRC-8, polynomial 0x07, start 0, over the characters between $ and *.
uint8_t crc8(std::string_view bytes);
/// CRC-16 CCITT: polynomial 0x1021, start 0xFFFF.
uint16_t crc16(std::string_view bytes);

/// A message as a line: "$JAW,7,1000,-512,00*5A\n"
std::string line(const Reading&);
/// A message as a frame: 11 bytes of COBS and a final zero; value clipped to 24 bits.
std::string frame(const Reading&);

/// Parses a line without its end; kNone when it is not a valid message.
Reading parse_line(std::string_view line);
/// Parses a frame without its zero; kNone when it is not a valid message.
Reading parse_frame(std::string_view frame);

/// Splits a stream of bytes into messages. At most one message is buffered, so an invalid stream needs no memory.
class Decoder {
 public:
  /// Frames end with a zero, lines with a line feed.
  void set_binary(bool binary) { binary_ = binary; }
  bool binary() const { return binary_; }
  void restart() { length_ = 0, overlong_ = true; }  // the message in progress is incomplete

  /// Takes one byte; returns a kind other than kNone when it ended a message.
  Reading take(char byte);
  uint64_t bad() const { return bad_; }  // number of invalid messages

 private:
  static constexpr std::size_t kLongest = 120;  // characters; the longest message has 64
  char buffer_[kLongest]{};
  std::size_t length_ = 0;
  uint64_t bad_ = 0;
  bool binary_ = false;
  bool overlong_ = true;  // the first message of a stream may be incomplete: it is not counted as bad
};

}  // namespace swage::sensor
