// SPDX-License-Identifier: Apache-2.0
//
// The jaw sensor's parts: JAW1 in lines and frames against rubbish, foreign readers, the map of clocks, and the mean of a sensor at rest.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sensor/bench.hpp"
#include "sensor/clock_map.hpp"
#include "sensor/foreign.hpp"
#include "sensor/jaw1.hpp"
#include "sensor/sentences.hpp"
#include "sensor_thread.hpp"
#include "temp_folder.hpp"

namespace swage::sensor {
namespace {

Reading jaw(uint32_t sequence, uint32_t clock_us, int32_t value, uint8_t status = 0) {
  Reading r;
  r.kind = Reading::kJaw;
  r.sequence = sequence, r.clock_us = clock_us, r.value = value, r.status = status;
  return r;
}

TEST(Jaw1, ChecksAreTheStandardOnes) {
  EXPECT_EQ(crc8("123456789"), 0xF4);     // CRC-8/SMBUS
  EXPECT_EQ(crc16("123456789"), 0x29B1);  // CRC-16/CCITT-FALSE
}

TEST(Jaw1, LinesGoThereAndBack) {
  const std::string text = line(jaw(4294967295u, 123456, -512345, 0x11));
  EXPECT_EQ(text.substr(0, text.find('*')), "$JAW,4294967295,123456,-512345,11");
  const Reading back = parse_line(text.substr(0, text.size() - 1));
  EXPECT_EQ(back.kind, Reading::kJaw);
  EXPECT_EQ(back.sequence, 4294967295u);
  EXPECT_EQ(back.clock_us, 123456u);
  EXPECT_EQ(back.value, -512345);
  EXPECT_EQ(back.status, 0x11);
  const Reading info = parse_line("$INF,serial,A-7*" + [] {
    char check[3];
    std::snprintf(check, 3, "%02X", crc8("INF,serial,A-7"));
    return std::string(check);
  }());
  EXPECT_EQ(info.kind, Reading::kInfo);
  EXPECT_EQ(info.key, "serial");
  EXPECT_EQ(info.text, "A-7");
}

TEST(Jaw1, FramesHaveTwelveBytesAndKeepTheSign) {
  for (const int32_t value : {0, 1, -1, 8388607, -8388608, 256, 65536, -512345}) {
    const std::string bytes = frame(jaw(7, 0x10000 + 300, value, 2));
    ASSERT_EQ(bytes.size(), 12u);
    EXPECT_EQ(bytes.find('\0'), 11u) << "only the end is zero";
    const Reading back = parse_frame(std::string_view(bytes).substr(0, 11));
    EXPECT_EQ(back.kind, Reading::kJaw);
    EXPECT_EQ(back.value, value);
    EXPECT_EQ(back.clock_us, 300u);
    EXPECT_EQ(back.sequence, 7u);
    EXPECT_EQ(back.status, 2u);
  }
}

TEST(Jaw1, EveryWrongBitIsSeen) {
  const std::string text = line(jaw(71, 5000, 1234567)), bytes = frame(jaw(71, 5000, 1234567));
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string wrong = text.substr(0, text.size() - 1);
      wrong[i] = static_cast<char>(wrong[i] ^ (1 << bit));
      // the check is written in hexadecimal, of either case: that bit means nothing
      if (i + 3 >= text.size() && std::isalpha(text[i]) && bit == 5) continue;
      EXPECT_EQ(parse_line(wrong).kind, Reading::kNone) << wrong;
    }
  }
  for (std::size_t i = 0; i < 11; ++i) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string wrong = bytes.substr(0, 11);
      wrong[i] = static_cast<char>(wrong[i] ^ (1 << bit));
      EXPECT_EQ(parse_frame(wrong).kind, Reading::kNone) << i << " " << bit;
    }
  }
}

TEST(Jaw1, ADecoderFindsItsWayThroughRubbish) {
  for (const bool binary : {false, true}) {
    std::mt19937 random(4);
    Decoder decoder;
    decoder.set_binary(binary);
    int found = 0;
    for (uint32_t n = 0; n < 500; ++n) {
      // rubbish of any length, now and then longer than any message, then its end and a whole message
      std::string bytes;
      for (std::size_t i = random() % (n % 50 == 0 ? 5000 : 40); i > 0; --i) bytes += static_cast<char>(random());
      bytes += binary ? '\0' : '\n';
      bytes += binary ? frame(jaw(n, 1000 * n, 42)) : line(jaw(n, 1000 * n, 42));
      for (const char c : bytes) {
        const Reading r = decoder.take(c);
        found += r.kind == Reading::kJaw;
        EXPECT_TRUE(r.kind == Reading::kNone || r.value == 42);
      }
    }
    EXPECT_EQ(found, 500) << "no message is lost, none is made of rubbish";
    EXPECT_GT(decoder.bad(), 400u);
  }
}

TEST(Foreign, TextAndNumbersOfBytes) {
  ForeignDecoder decoder;
  ForeignTable table;
  table.end = "\r";
  table.scale = 2, table.offset = 1;
  ASSERT_EQ(check_table(table), "");
  decoder.set(table);
  const auto all = [&](const std::string& bytes) {
    std::vector<double> out;
    for (const char c : bytes) {
      double volts = 0;
      if (decoder.take(c, volts)) out.push_back(volts);
    }
    return out;
  };
  EXPECT_EQ(all("CH1 +1.25 mm\r-0.5\rrubbish\rnan\r7e999\r3\r"), (std::vector<double>{3.5, 0, 7}));
  EXPECT_EQ(decoder.bad(), 3u) << "words, nan, and what is too large";

  table.at = 1;
  decoder.set(table);
  EXPECT_EQ(all("CH1 +1.25 mm 3e-1 V\r2\r"), (std::vector<double>{1.6})) << "the second number";

  table = {ForeignTable::kI24BigEnd, "", "\n", 5, 1, 1, 0};
  ASSERT_EQ(check_table(table), "");
  decoder.set(table);
  const std::string one{'\x02', '\xFF', '\xFF', '\xFE', '\n'};
  EXPECT_EQ(all(one + one), (std::vector<double>{-2, -2}));
  EXPECT_EQ(all("x" + one + one), (std::vector<double>{-2, -2})) << "a byte too many costs no message";
  table.format = ForeignTable::kU16LittleEnd;
  decoder.set(table);
  EXPECT_EQ(all({'\x02', '\x34', '\x12', '\x00', '\n'}), (std::vector<double>{0x1234}));
}

TEST(Foreign, ATableThatCannotWorkIsRefused) {
  EXPECT_NE(check_table({ForeignTable::kText, "", "", 0, 0, 1, 0}), "");
  EXPECT_NE(check_table({ForeignTable::kU16BigEnd, "", "", 2, 0, 1, 0}), "") << "its beginning could not be known";
  EXPECT_NE(check_table({ForeignTable::kU16BigEnd, "?", "", 2, 1, 1, 0}), "") << "too short";
  EXPECT_NE(check_table({ForeignTable::kText, "", "\r", 0, 0, 0, 0}), "");
  EXPECT_EQ(check_table({ForeignTable::kU16BigEnd, "?", "", 2, 0, 1, 0}), "");
  EXPECT_EQ(unescaped("a\\r\\n\\x1b\\\\\\0"), std::string("a\r\n\x1b\\\0", 6));
}

// messages of a sensor with a wrong clock, late by what a bus and a busy machine make of it
struct Bus {
  double drift = 0, burst = 0;
  int bits = 32;
  std::mt19937 random{1};
  double worst = 0;  // s, after the first ten seconds

  void run(ClockMap& map, double seconds, double zero = 0) {
    std::exponential_distribution<double> late(1 / 0.3e-3);
    double last = -1e9, before = -1e9;
    for (double t = 0; t < seconds; t += 5e-3) {
      const double truth = 1000 + zero + t;
      double arrival = truth + 1e-3 + late(random);
      if (burst > 0) arrival = std::max(arrival, std::ceil(arrival / burst) * burst);
      arrival = std::max(arrival, last);
      last = arrival;
      const auto clock = static_cast<uint64_t>(std::llround(1e6 * (1 + drift) * t)) & (bits == 32 ? 0xFFFFFFFFu : 0xFFFFu);
      const double stamp = map.stamp(static_cast<uint32_t>(clock), bits, arrival);
      EXPECT_GE(stamp, before) << "time goes on";
      EXPECT_LE(stamp, arrival) << "nothing arrives before it was measured";
      before = stamp;
      if (t > 10) worst = std::max(worst, std::abs(stamp - truth - 1e-3));
    }
  }
};

TEST(ClockMap, FindsOffsetAndDriftBelowTheScatterOfABus) {
  for (const double drift : {0.0, 0.005, -0.005}) {
    for (const int bits : {32, 16}) {
      ClockMap map;
      Bus bus;
      bus.drift = drift, bus.bits = bits;
      bus.run(map, 60);
      EXPECT_LT(bus.worst, 0.15e-3) << drift << " with " << bits << " bits; the scatter is 0.3 ms in the mean";
      EXPECT_NEAR(map.drift(), 1 / (1 + drift) - 1, 2e-5);
    }
  }
}

TEST(ClockMap, BurstsOfAnAdapterAreSmoothedAway) {
  ClockMap map;
  Bus bus;
  bus.burst = 16e-3, bus.drift = 1e-4;
  bus.run(map, 60);
  EXPECT_LT(bus.worst, 2e-3) << "of 16 ms";
}

TEST(ClockMap, ARestartBeginsAnewAndARunOverSeventyMinutesDoesNot) {
  ClockMap map;
  Bus bus;
  bus.run(map, 20);
  bus.run(map, 20, 25);  // its clock is at zero again
  EXPECT_EQ(map.restarts(), 1u);
  // the 32 bits wrap
  ClockMap wraps;
  double t = 0;
  for (uint32_t clock = 0xFFFFFFFFu - 500000; t < 1; t += 0.01, clock += 10000)
    EXPECT_NEAR(wraps.stamp(clock, 32, 50 + t), 50 + t, 1e-9);
  EXPECT_EQ(wraps.restarts(), 0u);
}

// A sensor and its reader, with a clock that the test turns.
class RestingSensor : public testing::Test {
 protected:
  RestingSensor() {
    sensor_.plug(folder_ / "port");
    EXPECT_EQ(bench_.open(folder_ / "port", 115200), "");
    deliver(0);
  }
  /// What the sensor has measured up to the time t [s] reaches the reader, at that time.
  void deliver(double t) {
    volts_ += 1e-6;  // tells the newest measurement from those before
    sensor_.tick(begin_ + t);
    for (int i = 0; i < 5000; ++i, test::nap(1e-3)) {  // a port hands bytes over when the kernel comes to it
      bench_.listen(begin_ + t);
      if (bench_.volts() && std::abs(*bench_.volts() - volts_) < 0.5e-6) return;
    }
    FAIL() << "nothing arrived";
  }
  double volts_ = 1;
  double begin_ = now_s();
  test::TempFolder folder_;
  SimulatedSensor sensor_{{}, [this](double) { return SimulatedSensor::Measured{volts_, 0, 0}; }};
  Bench bench_;
};

TEST_F(RestingSensor, OnABusyMachineIsReadLateAndLongEnough) {
  deliver(0.1);
  bench_.begin(begin_ + 0.1, 0.1);
  bench_.listen(begin_ + 0.6);  // neither side had the processor
  EXPECT_TRUE(bench_.measuring()) << "what was measured is on its way";
  deliver(0.6);
  EXPECT_FALSE(bench_.measuring());
  double volts = 0;
  ASSERT_EQ(bench_.mean(volts), "");
  EXPECT_NEAR(volts, 1, 1e-5);
}

TEST_F(RestingSensor, ThatSaysNothingEndsTheMean) {
  bench_.begin(begin_ + 0.1, 0.1);
  bench_.listen(begin_ + 2);
  EXPECT_TRUE(bench_.measuring());
  bench_.listen(begin_ + 3.3);
  EXPECT_FALSE(bench_.measuring());
  double volts = 0;
  EXPECT_EQ(bench_.mean(volts), say::kFewMeasurements(0));
}

}  // namespace
}  // namespace swage::sensor
