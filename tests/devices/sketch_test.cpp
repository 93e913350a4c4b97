// SPDX-License-Identifier: Apache-2.0
//
// The sketch for Arduino, compiled here with a board of a few lines: what it sends is JAW1, and it obeys.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>

#include "sensor/clock_map.hpp"
#include "sensor/jaw1.hpp"

namespace board {

using byte = uint8_t;
constexpr int A0 = 0, A1 = 1;
std::string to_host, to_board;
unsigned long now_us = 0;
int pin = 512;

struct Port {
  void begin(long) {}
  void print(char c) { to_host += c; }
  void print(const char* s) { to_host += s; }
  void write(int b) { to_host += static_cast<char>(b); }
  void write(const byte* p, int n) { to_host.append(reinterpret_cast<const char*>(p), static_cast<std::size_t>(n)); }
  int available() { return static_cast<int>(to_board.size()); }
  int read() {
    const char c = to_board[0];
    to_board.erase(0, 1);
    return c;
  }
} Serial;
unsigned long micros() { return now_us; }
int analogRead(int) { return pin; }
unsigned long max(unsigned long a, unsigned long b) { return a > b ? a : b; }

// compilers of boards do not warn of this
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wnarrowing"
#pragma GCC diagnostic ignored "-Wunused-value"
#pragma GCC diagnostic ignored "-Wfloat-conversion"
#include "resources/jaw_sensor/jaw_sensor.ino"
#pragma GCC diagnostic pop

void run(double seconds) {
  for (const unsigned long end = now_us + static_cast<unsigned long>(1e6 * seconds); now_us < end; now_us += 100) loop();
}

}  // namespace board

namespace swage::sensor {
namespace {

struct Heard {
  int jaw = 0, restarted = 0, over = 0;
  uint32_t gaps = 0;
  int32_t value = 0;
  std::string serial;
  uint64_t bad = 0;
};

Heard hear(bool binary) {
  Decoder decoder;
  decoder.set_binary(binary);
  Heard out;
  uint32_t last = 0;
  for (const char c : board::to_host) {
    const Reading r = decoder.take(c);
    if (r.kind == Reading::kInfo && r.key == "serial") out.serial = r.text;
    if (r.kind != Reading::kJaw) continue;
    if (out.jaw++ > 0) out.gaps += ((r.sequence - last) & 0xFF) != 1;
    last = r.sequence;
    out.restarted += (r.status & kRestarted) != 0;
    out.over += (r.status & kOverRange) != 0;
    out.value = r.value;
  }
  out.bad = decoder.bad();
  board::to_host.clear();
  return out;
}

TEST(Sketch, SpeaksLinesThenFramesAndObeys) {
  board::setup();
  board::run(1);
  Heard h = hear(false);
  EXPECT_NEAR(h.jaw, 200, 2);
  EXPECT_EQ(h.gaps + h.bad, 0u);
  EXPECT_EQ(h.restarted, 1) << "the first one says that it has restarted";
  EXPECT_NEAR(h.value, 2.5e6, 1);
  board::to_board = "?\nR100\n";
  board::run(1);
  h = hear(false);
  EXPECT_EQ(h.serial, "JAW-001");
  EXPECT_NEAR(h.jaw, 100, 2);
  EXPECT_EQ(h.bad, 0u);
  board::pin = 1023;
  board::to_board = "R1000\nB1\n";
  board::run(0.01);  // the change from lines to frames
  board::to_host.clear();
  board::run(1);
  h = hear(true);
  EXPECT_NEAR(h.jaw, 1000, 2);
  EXPECT_EQ(h.gaps + h.bad, 0u) << "values with zeros in them as well";
  EXPECT_EQ(h.over, h.jaw);
  EXPECT_EQ(h.value, static_cast<int32_t>(1023 * 5.0e6f / 1024));
  board::to_board = "B0\n";
  board::run(0.01);
  board::to_host.clear();
  board::run(0.1);
  h = hear(false);
  EXPECT_NEAR(h.jaw, 100, 2);
}

}  // namespace
}  // namespace swage::sensor
