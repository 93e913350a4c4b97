// SPDX-License-Identifier: Apache-2.0
//
// The driver of the Inverse3 against a service that checks its caller: handshake, frames, axes, forces, absence and return.
#include "inverse3/inverse3.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <swage/testbed.hpp>
#include <time.h>

#include <cmath>
#include <limits>
#include <random>

#include "fake_inverse.hpp"
#include "inverse3/sentences.hpp"

namespace swage::inverse3 {
namespace {

using test::FakeInverse;
using test::nap;
using testing::HasSubstr;
using Bench = testbed::DeviceBench<Inverse3>;
using Manners = FakeInverse::Manners;

double now_s() {
  timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

std::string hex(const std::string& bytes) {
  std::string out;
  char text[3];
  for (const char c : bytes) out += (std::snprintf(text, sizeof text, "%02x", static_cast<unsigned char>(c)), text);
  return out;
}

// FIPS 180-4, examples; RFC 4648, 10; RFC 6455, 1.3
TEST(Handshake, IsThatOfTheStandards) {
  EXPECT_EQ(hex(sha1("")), "da39a3ee5e6b4b0d3255bfef95601890afd80709");
  EXPECT_EQ(hex(sha1("abc")), "a9993e364706816aba3e25717850c26c9cd0d89d");
  EXPECT_EQ(hex(sha1("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq")), "84983e441c3bd26ebaae4aa1f95129e5e54670f1");
  EXPECT_EQ(hex(sha1(std::string(1'000'000, 'a'))), "34aa973cd4c4daa4f61eeb2bdbad27316534016f");
  const char* const pairs[][2] = {{"", ""}, {"f", "Zg=="}, {"fo", "Zm8="}, {"foo", "Zm9v"}, {"foob", "Zm9vYg=="}, {"fooba", "Zm9vYmE="}, {"foobar", "Zm9vYmFy"}};
  for (const auto& [plain, coded] : pairs) EXPECT_EQ(base64(plain), coded);
  EXPECT_EQ(accept_for("dGhlIHNhbXBsZSBub25jZQ=="), "s3pPLMBiTxaQ9kYGzzhZRbK+xOo=");
}

TEST(Handshake, AnAnswerIsTakenWordForWord) {
  const std::string key = "dGhlIHNhbXBsZSBub25jZQ==", good = "Sec-WebSocket-Accept: s3pPLMBiTxaQ9kYGzzhZRbK+xOo=\r\n";
  const std::string head = "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n";
  EXPECT_EQ(check_answer(head + good, key), "");
  EXPECT_THAT(check_answer("HTTP/1.1 200 OK\r\n" + good, key), HasSubstr("200 OK"));
  EXPECT_NE(check_answer(head + "Sec-WebSocket-Accept: s3pPLMBiTxaQ9kYGzzhZRbK+xOo\r\n", key), "");
  EXPECT_NE(check_answer("HTTP/1.1 101 Switching Protocols\r\nConnection: Upgrade\r\n" + good, key), "");
  EXPECT_NE(check_answer(head + good + "Sec-WebSocket-Extensions: permessage-deflate\r\n", key), "");
  EXPECT_NE(check_answer("", key), "");
}

// Haply: x right, y forward, z up; the device frame: x right, y up, z towards the user
TEST(Messages, ComeInTheDeviceFrame) {
  const Message m = read_message(R"({"inverse3": [{"device_id": "A", "state": {"cursor_position": {"x": 0.01, "y": 0.02, "z": 0.03},
    "cursor_velocity": {"x": 0, "y": 0.5, "z": 0}}}], "verse_grip": [{"state": {"orientation": {"w": 1, "x": 0, "y": 0, "z": 0}, "buttons": {"b": true}}}]})",
                                 "", "");
  ASSERT_TRUE(m.arm && m.grip);
  EXPECT_EQ(m.arm->p_D, Vec3(0.01, 0.03, -0.02));
  EXPECT_EQ(m.arm->v_D, Vec3(0, 0, -0.5));
  EXPECT_EQ(m.grip->buttons, 2u);
  EXPECT_LT((m.grip->q_DG * Vec3::UnitY() - Vec3(0, 0, -1)).norm(), 1e-15) << "a stylus that points forward points away from the user";
  EXPECT_LT((m.grip->q_DG * Vec3::UnitZ() - Vec3(0, 1, 0)).norm(), 1e-15);
  const auto sent = nlohmann::json::parse(force_message("A", true, {1, 2, 3}));
  EXPECT_EQ(sent, nlohmann::json::parse(R"({"inverse3": [{"device_id": "A", "commands": {"set_cursor_force": {"vector": {"x": 1.0, "y": -3.0, "z": 2.0}}}}]})"));
  EXPECT_TRUE(nlohmann::json::parse(force_message("A", false, {1, 2, 3}))["inverse3"][0]["commands"]["set_cursor_force"].contains("values"));
}

TEST(Messages, RubbishIsNoMeasurement) {
  const char* const arms[] = {
      "", "nul", "[]", "{}", R"({"inverse3": 3})", R"({"inverse3": [3]})", R"({"inverse3": [{"state": []}]})",
      R"({"inverse3": [{"state": {"cursor_position": {"x": 1, "y": 2}}}]})", R"({"inverse3": [{"state": {"cursor_position": {"x": "1", "y": 2, "z": 3}}}]})",
      R"({"inverse3": [{"state": {"cursor_position": {"x": 1e300, "y": 0, "z": 0}}}]})", R"({"inverse3": [{"state": {"cursor_position": {"x": 1e999, "y": 0, "z": 0}}}]})"};
  for (const char* text : arms) EXPECT_FALSE(read_message(text, "", "").arm) << text;
  const char* const grips[] = {R"({"verse_grip": [{"state": {"orientation": {"w": 0, "x": 0, "y": 0, "z": 0}}}]})",
                               R"({"verse_grip": [{"state": {"orientation": {"w": null, "x": 0, "y": 0, "z": 0}}}]})", R"({"wireless_verse_grip": [null]})"};
  for (const char* text : grips) EXPECT_FALSE(read_message(text, "", "").grip) << text;
  std::mt19937 random(5);
  const std::string good = FakeInverse(Manners::kSilent).state(true).dump();
  for (int i = 0; i < 20000; ++i) {
    std::string bad = good;
    for (unsigned n = 1 + static_cast<unsigned>(random() % 4); n > 0; --n) bad[random() % bad.size()] = static_cast<char>(random());
    const Message m = read_message(bad, "", "");
    ASSERT_TRUE(!m.arm || (m.arm->p_D.norm() <= 1 && m.arm->v_D.allFinite())) << bad;
    ASSERT_TRUE(!m.grip || std::abs(m.grip->q_DG.norm() - 1) < 1e-9) << bad;
  }
}

class Haply : public testing::Test {
 protected:
  void prepare(Bench& bench, const FakeInverse& service) { bench.set("port", service.port()); }
  void start(Bench& bench, const FakeInverse& service) {
    prepare(bench, service);
    ASSERT_TRUE(bench.start()) << (bench.host.reports.empty() ? "" : bench.host.reports[0]);
  }
  static void stop(Bench& bench) {
    bench.host.role = SWAGE_THREAD_MAIN;
    bench.get<swage_device>(SWAGE_EXT_DEVICE)->close(bench.raw);
  }
  /// Asks until it is so; CTest's limit ends what never comes.
  template <class F>
  void until(Bench& bench, F done) {
    for (; !done(); nap(1e-3)) {
      bench.command.deadline_s = now_s() + deadline_;
      EXPECT_GE(bench.exchange(now_s()), 0);
    }
  }
  std::string refusal(const FakeInverse& service) {
    Bench bench;
    prepare(bench, service);
    EXPECT_FALSE(bench.start());
    return bench.host.reports.empty() ? "" : bench.host.reports[0];
  }
  double deadline_ = 10;  // s: a busy machine is no lost host
};

TEST_F(Haply, PosesAndButtonsArriveAndTheInstrumentGoesWhereTheStylusPoints) {
  FakeInverse service;
  Bench bench;
  start(bench, service);
  EXPECT_THAT(bench.host.reports.at(0), HasSubstr(say::kArm("049D", say::kHanded("right"), say::kWithGrip(say::kBattery(50)))));
  service.x = 0.012, service.y = 0.02, service.z = 0.03, service.vx = 0.1;
  service.buttons = 1;
  until(bench, [&] { return std::abs(bench.sample.pose.p.x - 0.012) < 1e-12 && bench.sample.closure > 0.05; });
  EXPECT_NEAR(bench.sample.pose.p.y, 0.03, 1e-12);
  EXPECT_NEAR(bench.sample.pose.p.z, -0.02, 1e-12);
  EXPECT_NEAR(bench.sample.twist.v.x, 0.1, 1e-12);
  const Quat q = toolkit::quat(bench.sample.pose.q);
  EXPECT_LT((q * Vec3::UnitX() - Vec3(0, 0, -1)).norm(), 1e-9) << "forward";
  EXPECT_LT((q * Vec3::UnitZ() - Vec3(-1, 0, 0)).norm(), 1e-9) << "the jaws close to the left and right";
  EXPECT_EQ(bench.sample.valid, SWAGE_VALID_POSE | SWAGE_VALID_TWIST | SWAGE_VALID_BUTTONS | SWAGE_VALID_CLOSURE);
  EXPECT_NEAR(bench.sample.time_s, now_s(), 1);
  service.buttons = 2;
  until(bench, [&] { return bench.sample.closure < 0.02; });
  stop(bench);
  EXPECT_EQ(service.wrong(), "");
}

TEST_F(Haply, AForceIsGivenInItsAxesAndNeverAboveTheLimit) {
  for (const bool newer : {true, false}) {
    FakeInverse service;
    service.newer = newer;
    Bench bench;
    start(bench, service);
    bench.command.force = {0.1, 0.2, 0.3};
    until(bench, [&] { return service.fx == 0.1; });
    EXPECT_EQ(service.fy, -0.3);
    EXPECT_EQ(service.fz, 0.2);
    bench.command.force = {0, 100, 0};
    until(bench, [&] { return std::abs(service.fz - 3) < 1e-12; });
    bench.command.force = {std::numeric_limits<double>::quiet_NaN(), 0, 0};
    until(bench, [&] { return service.fz == 0; });
    bench.command.force = {0, 1, 0};
    until(bench, [&] { return service.fz == 1; });
    deadline_ = -1;
    until(bench, [&] { return service.fz == 0; });
    deadline_ = 10;
    until(bench, [&] { return service.fz == 1; });
    stop(bench);
    for (int i = 0; i < 2000 && service.byes == 0; ++i) nap(1e-3);
    EXPECT_EQ(service.fz, 0) << "the last word is no force";
    EXPECT_EQ(service.byes, 1u);
    EXPECT_EQ(service.wrong(), "");
  }
}

TEST_F(Haply, WhatIsMissingIsToldWithTheRemedy) {
  FakeInverse service;
  service.stop();
  EXPECT_THAT(refusal(service), HasSubstr(say::kNoService.words(0) + "127.0.0.1:"));
  EXPECT_THAT(refusal(service), HasSubstr(say::kNoService.words(2)));
  service.arm = false;
  service.start();
  EXPECT_THAT(refusal(service), HasSubstr(say::kNoArm()));
  service.arm = true;
  Bench other;
  prepare(other, service);
  other.set_text("arm", "FFFF");
  EXPECT_FALSE(other.start());
  EXPECT_THAT(other.host.reports.at(0), HasSubstr(say::kNoSuchArm("FFFF", "049D")));
  Bench nowhere;
  nowhere.set_text("host", "no.such.host.invalid");
  EXPECT_FALSE(nowhere.start());
  EXPECT_THAT(nowhere.host.reports.at(0), HasSubstr(say::kHostUnknown.words(0) + "no.such.host.invalid" + say::kHostUnknown.words(1)));
}

TEST_F(Haply, AServiceOfAnotherKindIsToldApart) {
  EXPECT_THAT(refusal(FakeInverse(Manners::kNoWebSocket)), HasSubstr("404 Not Found"));
  EXPECT_THAT(refusal(FakeInverse(Manners::kWrongKey)), HasSubstr(say::kOtherAnswer()));
  EXPECT_THAT(refusal(FakeInverse(Manners::kHuge)), HasSubstr(say::kHuge()));
  EXPECT_THAT(refusal(FakeInverse(Manners::kSilent)), HasSubstr(say::kOtherService.words(1)));
  EXPECT_THAT(refusal(FakeInverse(Manners::kRubbish)), HasSubstr(say::kOtherService.words(1)));
}

TEST_F(Haply, MessagesInFragmentsWithPingsBetweenThemAreWhole) {
  FakeInverse service(Manners::kFragments);
  Bench bench;
  start(bench, service);
  service.x = 0.1;
  until(bench, [&] { return std::abs(bench.sample.pose.p.x - 0.1) < 1e-12; });
  stop(bench);
  EXPECT_EQ(service.wrong(), "");
}

TEST_F(Haply, AStylusThatFallsSilentTakesThePoseWithIt) {
  FakeInverse service;
  Bench bench;
  start(bench, service);
  until(bench, [&] { return bench.sample.sequence > 5; });
  service.grip = false;
  until(bench, [&] { return bench.sample.valid == 0; });
  service.grip = true;
  until(bench, [&] { return (bench.sample.valid & SWAGE_VALID_POSE) != 0; });
  stop(bench);
  // without one from the start, the instrument has the direction of the parameters
  service.grip = false;
  Bench bare;
  prepare(bare, service);
  bare.set("axis", 1, 0, 0);
  bare.set("closing", 0, 1, 0);
  ASSERT_TRUE(bare.start());
  EXPECT_THAT(bare.host.reports.at(0), HasSubstr(say::kWithoutGrip()));
  until(bare, [&] { return bare.sample.sequence > 2; });
  EXPECT_EQ(bare.sample.valid, SWAGE_VALID_POSE | SWAGE_VALID_TWIST);
  EXPECT_LT((toolkit::quat(bare.sample.pose.q) * Vec3::UnitX() - Vec3::UnitX()).norm(), 1e-12);
  stop(bare);
}

TEST_F(Haply, TheBatteryOfTheStylusIsToldAndALowOneIsSaidOnce) {
  FakeInverse service;
  Bench bench;
  start(bench, service);
  const auto* signals = bench.get<swage_device_signals>(SWAGE_EXT_DEVICE_SIGNALS);
  ASSERT_NE(signals, nullptr);
  ASSERT_EQ(signals->count, 1u);
  EXPECT_STREQ(signals->signal[0].id, "stylus.battery");
  double told = 0;
  const auto tells = [&](double wanted) {
    until(bench, [&] { return signals->read(bench.raw, &told) == SWAGE_OK && (std::isnan(wanted) ? std::isnan(told) : told == wanted); });
  };
  tells(0.5);
  EXPECT_EQ(bench.host.reports.size(), 1u) << "the note at its start";
  service.battery = 0.15;
  tells(0.15);
  service.battery = 0.14;
  tells(0.14);
  ASSERT_EQ(bench.host.reports.size(), 2u);
  EXPECT_THAT(bench.host.reports[1], HasSubstr(say::kLowBattery()));
  service.grip = false;
  tells(std::nan(""));
  stop(bench);
}

TEST_F(Haply, AnAnswerThatNeverCameIsAskedForAgain) {
  FakeInverse service;
  Bench bench;
  start(bench, service);
  until(bench, [&] { return bench.sample.sequence > 5; });
  service.answers = false;
  const unsigned long heard = service.forces;
  until(bench, [&] { return service.forces >= heard + 3; });
  service.answers = true;
  const uint64_t last = bench.sample.sequence;
  until(bench, [&] { return bench.sample.sequence > last + 5; });
  stop(bench);
}

TEST_F(Haply, AHundredRestartsAndPulledArmsAreSilenceAndReturn) {
  FakeInverse service;
  Bench bench;
  start(bench, service);
  std::mt19937 random(3);
  for (int round = 0; round < 100; ++round) {
    service.x = 1e-3 * round;
    until(bench, [&] { return std::abs(bench.sample.pose.p.x - 1e-3 * round) < 1e-12; });
    const bool all = random() % 4 == 0;
    if (all)
      service.stop();
    else
      service.arm = false;
    uint64_t last = 0;
    for (int same = 0; same < 15; same = bench.sample.sequence == last ? same + 1 : 0) {
      last = bench.sample.sequence;
      bench.exchange(now_s());
      nap(1e-3);
    }
    if (all)
      service.start();
    else
      service.arm = true;
  }
  stop(bench);
  EXPECT_EQ(service.wrong(), "");
  EXPECT_EQ(service.most, 0) << "no force was ever asked for";
}

}  // namespace
}  // namespace swage::inverse3
