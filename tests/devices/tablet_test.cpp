// SPDX-License-Identifier: Apache-2.0
//
// The pen tablet's driver: its decoder over a stream of the kernel's events, and the whole driver with a pen at the other end of a socket.
#include "tablet/tablet.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/input.h>
#include <swage/testbed.hpp>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tablet/sentences.hpp"

namespace swage::tablet {
namespace {

using testing::HasSubstr;
using toolkit::Vec3;

double now_s() {
  timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

void nap(double seconds) {
  const timespec pause{0, static_cast<long>(1e9 * seconds)};
  nanosleep(&pause, nullptr);
}

// as of a middle-sized tablet: 200 units per mm, 216 x 135 mm, 8192 steps of pressure, 64 degrees of tilt
const PenRanges kRanges = {{0, 43200, 200}, {0, 27000, 200}, {0, 8191, 0}, {0, 63, 0}, {-64, 63, 57}, {-64, 63, 57}};

std::string event(int type, int code, int value, double time = 0) {
  input_event e{};
  e.input_event_sec = static_cast<decltype(e.input_event_sec)>(time);
  e.input_event_usec = static_cast<decltype(e.input_event_usec)>(1e6 * (time - std::floor(time)));
  e.type = static_cast<uint16_t>(type), e.code = static_cast<uint16_t>(code), e.value = value;
  return {reinterpret_cast<const char*>(&e), sizeof e};
}
std::string end() { return event(EV_SYN, SYN_REPORT, 0, 12.25); }

std::string pen_at(int x, int y, int pressure) {
  return event(EV_KEY, BTN_TOOL_PEN, 1) + event(EV_KEY, BTN_TOUCH, pressure > 0) + event(EV_ABS, ABS_X, x) + event(EV_ABS, ABS_Y, y) +
         event(EV_ABS, ABS_PRESSURE, pressure) + event(EV_ABS, ABS_DISTANCE, pressure > 0 ? 0 : 32) + end();
}

PenDecoder decoder() {
  PenDecoder out;
  out.begin(kRanges, 0.2, 0.12);
  return out;
}

TEST(PenDecoder, UnitsAreThoseOfTheKernelAndTheMiddleIsZero) {
  PenDecoder d = decoder();
  const std::string bytes = pen_at(43200, 0, 8191) + event(EV_ABS, ABS_TILT_X, 57) + event(EV_ABS, ABS_TILT_Y, 57) + end();
  EXPECT_TRUE(d.take(bytes.data(), bytes.size()));
  const PenState& s = d.state();
  EXPECT_TRUE(s.near && s.touches);
  EXPECT_NEAR(s.x, 0.108, 1e-12);
  EXPECT_NEAR(s.y, 0.0675, 1e-12) << "the kernel's y goes down";
  EXPECT_EQ(s.pressure, 1);
  EXPECT_EQ(s.height, 0);
  EXPECT_NEAR(s.tilt_x, 1, 0.02);
  EXPECT_NEAR(s.tilt_y, -1, 0.02);
  EXPECT_NEAR(s.time_s, 12.25, 1e-9);
  // one unit is 5 um
  const std::string next = event(EV_ABS, ABS_X, 43199) + end();
  const double x = s.x;
  d.take(next.data(), next.size());
  EXPECT_NEAR(x - d.state().x, 5e-6, 1e-12);
}

TEST(PenDecoder, StreamsMayBeCutAnywhere) {
  std::mt19937 random(2);
  std::string bytes;
  for (int i = 0; i < 500; ++i) bytes += pen_at(static_cast<int>(random() % 43201), static_cast<int>(random() % 27001), static_cast<int>(random() % 8192));
  PenDecoder whole = decoder(), cut = decoder();
  whole.take(bytes.data(), bytes.size());
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t n = std::min<std::size_t>(1 + random() % 70, bytes.size() - at);
    cut.take(bytes.data() + at, n);
    at += n;
  }
  EXPECT_EQ(whole.state().x, cut.state().x);
  EXPECT_EQ(whole.state().y, cut.state().y);
  EXPECT_EQ(whole.state().pressure, cut.state().pressure);
}

TEST(PenDecoder, AReportIsWholeOrNoneAndALossIsCounted) {
  PenDecoder d = decoder();
  std::string bytes = pen_at(21600, 13500, 100);
  d.take(bytes.data(), bytes.size());
  bytes = event(EV_ABS, ABS_X, 0);
  EXPECT_FALSE(d.take(bytes.data(), bytes.size()));
  EXPECT_EQ(d.state().x, 0) << "half a report is none";
  bytes = event(EV_SYN, SYN_DROPPED, 0) + event(EV_ABS, ABS_Y, 0) + end();
  EXPECT_FALSE(d.take(bytes.data(), bytes.size())) << "nor is what follows a loss";
  EXPECT_EQ(d.lost(), 1u);
  bytes = end();
  EXPECT_TRUE(d.take(bytes.data(), bytes.size()));
}

TEST(PenDecoder, RubbishStaysWithinTheSurface) {
  std::mt19937 random(7);
  PenDecoder d = decoder();
  for (int i = 0; i < 100000; ++i) {
    const int types[] = {EV_KEY, EV_ABS, EV_ABS, EV_ABS, EV_SYN, 77};
    const std::string bytes = event(types[random() % 6], static_cast<int>(random() % 64), static_cast<int>(random()));
    d.take(bytes.data(), bytes.size());
    const PenState& s = d.state();
    ASSERT_LE(std::abs(s.x), 0.108 + 1e-9);
    ASSERT_LE(std::abs(s.y), 0.0675 + 1e-9);
    ASSERT_TRUE(s.pressure >= 0 && s.pressure <= 1 && s.height >= 0 && s.height <= 1);
    ASSERT_LE(std::abs(s.tilt_x), 1.4);
  }
}

/// A tablet at the other end of a socket, which can be pulled out.
struct Fake {
  int ours = -1;
  bool plugged = true;
  std::string open(OpenPen& out) {
    if (!plugged) return say::kNoTablet("");
    int pair[2];
    EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, pair), 0);
    if (ours >= 0) ::close(ours);
    ours = pair[0];
    out = {pair[1], "Fake pen", kRanges};
    return "";
  }
  void pull() {
    plugged = false;
    ::close(ours);
    ours = -1;
  }
  void tell(const std::string& bytes) const { EXPECT_EQ(::send(ours, bytes.data(), bytes.size(), MSG_NOSIGNAL), static_cast<ssize_t>(bytes.size())); }
  ~Fake() {
    if (ours >= 0) ::close(ours);
  }
};

Fake* fake = nullptr;

class FakeTablet final : public Tablet {
 public:
  FakeTablet() {
    set_opener([](const std::string&, const std::string&, OpenPen& out) { return fake->open(out); });
  }
};
using Bench = testbed::DeviceBench<FakeTablet>;

class Driver : public testing::Test {
 protected:
  void SetUp() override { fake = &fake_; }
  static int ask(Bench& bench, double seconds) {
    int came = 0;
    int asked = 0;  // a busy machine asks as often as a quick one
    for (const double until = now_s() + seconds; now_s() < until || asked < 200 * seconds; nap(2e-3), ++asked) {
      const uint64_t last = bench.sample.sequence;
      EXPECT_GE(bench.exchange(now_s()), 0);
      came += bench.sample.sequence != last;
      EXPECT_TRUE(toolkit::vec(bench.sample.pose.p).allFinite());
    }
    return came;
  }
  static Vec3 p(const Bench& bench) { return toolkit::vec(bench.sample.pose.p); }
  static bool held(const Bench& bench) { return (bench.sample.valid & SWAGE_VALID_POSE) != 0; }
  Fake fake_;
};

TEST_F(Driver, AbsenceIsToldWithTheRemedy) {
  fake_.plugged = false;
  Bench bench;
  EXPECT_FALSE(bench.start());
  EXPECT_THAT(bench.host.reports.at(0), HasSubstr(say::kNoTablet("")));
  // and by the real opener
  OpenPen pen;
  EXPECT_THAT(open_pen("/dev/null", "", pen), HasSubstr(say::kNoPen("/dev/null")));
  EXPECT_THAT(open_pen("/dev/input/none", "", pen), HasSubstr("/dev/input/none" + say::kNotOpened.words(1)));
}

TEST_F(Driver, ThePenLeadsAndPressureClosesTheJaws) {
  Bench bench;
  bench.set("smoothing", 0);
  ASSERT_TRUE(bench.start());
  EXPECT_THAT(bench.host.reports.at(0), HasSubstr(say::kTablet("Fake pen", "")));
  ask(bench, 0.02);
  EXPECT_FALSE(held(bench)) << "no pen is near";
  fake_.tell(pen_at(21600 + 2000, 13500 - 1000, 4300));
  ask(bench, 0.3);
  ASSERT_TRUE(held(bench));
  EXPECT_LT((p(bench) - Vec3(10e-3, 5e-3, 0)).norm(), 1e-9);
  EXPECT_NEAR(bench.sample.closure, (4300.0 / 8191 - 0.05) / 0.95, 1e-9);
  const toolkit::Quat q = toolkit::quat(bench.sample.pose.q);
  EXPECT_LT((q * Vec3::UnitX() - Vec3(0, 0, -1)).norm(), 1e-9) << "an upright pen: the tips point down";
  EXPECT_LT((q * Vec3::UnitZ() - Vec3(1, 0, 0)).norm(), 1e-9);
  // the top of the pen leans to the right: the tips point down and to the left
  fake_.tell(event(EV_ABS, ABS_TILT_X, 28) + end());
  ask(bench, 0.02);
  EXPECT_LT((toolkit::quat(bench.sample.pose.q) * Vec3::UnitX()).x(), -0.4);
  // the second button lifts
  fake_.tell(event(EV_KEY, BTN_STYLUS2, 1) + end());
  ask(bench, 0.2);
  EXPECT_GT(p(bench).z(), 0.5e-3);
  EXPECT_EQ(bench.sample.buttons, 2u);
}

TEST_F(Driver, PressureMayBeDepth) {
  Bench bench;
  bench.set("pressure", 1);
  bench.set("smoothing", 0);
  ASSERT_TRUE(bench.start());
  fake_.tell(pen_at(21600, 13500, 8191));
  ask(bench, 0.3);
  EXPECT_NEAR(p(bench).z(), -5e-3, 1e-9);
  EXPECT_EQ(bench.sample.closure, 0);
  fake_.tell(event(EV_KEY, BTN_STYLUS, 1) + end());
  ask(bench, 0.02);
  EXPECT_EQ(bench.sample.closure, 1);
}

TEST_F(Driver, APenThatIsLiftedIsLostForLongEnoughToBeMetAgain) {
  Bench bench;
  ASSERT_TRUE(bench.start());
  fake_.tell(pen_at(21600, 13500, 100));
  ask(bench, 0.3);
  ASSERT_TRUE(held(bench));
  // lifted and put down elsewhere within 20 ms
  fake_.tell(event(EV_KEY, BTN_TOOL_PEN, 0) + end());
  ask(bench, 0.02);
  EXPECT_FALSE(held(bench));
  fake_.tell(pen_at(0, 0, 100));
  const double begun = now_s();
  while (!held(bench) && now_s() < begun + 60) ask(bench, 2e-3);
  EXPECT_GT(now_s() - begun, 0.1) << "shorter gaps the host takes for drop-outs, and would draw the tool along";
  EXPECT_NEAR(p(bench).x(), -0.108, 1e-9) << "where it is, at once: the host keeps the way between";
}

TEST_F(Driver, APulledTabletIsSilenceAndFoundAgain) {
  Bench bench;
  ASSERT_TRUE(bench.start());
  std::mt19937 random(3);
  std::uniform_real_distribution<double> moment(0.002, 0.05);
  for (int round = 0; round < 100; ++round) {
    fake_.tell(pen_at(static_cast<int>(random() % 43201), static_cast<int>(random() % 27001), 100));
    ask(bench, moment(random));
    fake_.pull();
    ask(bench, 3e-3);
    const swage_sample last = bench.sample;
    EXPECT_EQ(ask(bench, moment(random)), 0);
    EXPECT_EQ(bench.sample.pose.p.x, last.pose.p.x);
    fake_.plugged = true;
    const double until = now_s() + 60;
    while (bench.sample.sequence == last.sequence && now_s() < until) ask(bench, 2e-3);
    ASSERT_LT(now_s(), until) << "round " << round;
    EXPECT_FALSE(held(bench)) << "until a pen is near";
  }
}

}  // namespace
}  // namespace swage::tablet
