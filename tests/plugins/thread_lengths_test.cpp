// SPDX-License-Identifier: Apache-2.0
//
// A thread with shorter segments in a part of it: where its nodes are, what that is worth where it bends tightly, and that it weighs as much.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "plugins/thread/lengths.hpp"
#include "thread_bench.hpp"
#include "toolkit/rod.hpp"

namespace swage::thread {
namespace thread_lengths_test {

constexpr double kLine = 4.333e-7;  // kg/m, of 10-0 nylon

std::vector<double> lengths(double length, int n, const Finer& finer) {
  std::vector<double> s = node_places(length, n, finer), out;
  for (size_t i = 1; i < s.size(); ++i) out.push_back(s[i] - s[i - 1]);
  return out;
}

TEST(ThreadLengths, AreShortWhereTheLessonSaysAndGrowSlowly) {
  for (const int n : {16, 40, 100, 200})
    for (const double times : {2.0, 8.0, 20.0})
      for (const auto& [from, to] : {std::pair{0.0, 1e-3}, {8e-3, 11e-3}, {18e-3, 20e-3}}) {
        const auto s = node_places(20e-3, n, {from, to, times});
        const auto l = lengths(20e-3, n, {from, to, times});
        EXPECT_EQ(s.front(), 0);
        EXPECT_EQ(s.back(), 20e-3);
        EXPECT_NEAR(std::accumulate(l.begin(), l.end(), 0.0), 20e-3, 1e-15);
        const double least = *std::min_element(l.begin(), l.end()), most = *std::max_element(l.begin(), l.end());
        EXPECT_GT(least, 0);
        EXPECT_LT(most, times * least * 1.001);
        for (size_t j = 0; j < l.size(); ++j) {
          const double ratio = j > 0 ? l[j] / l[j - 1] : 1;
          EXPECT_LT(std::max(ratio, 1 / ratio), 1.3) << n << " " << times << " " << j;
          if (s[j] >= from && s[j + 1] <= to) {
            EXPECT_NEAR(l[j], least, 2e-3 * least);
          }
        }
      }
  const auto even = node_places(20e-3, 32, {0, 1e-3, 1});
  for (int i = 0; i <= 32; ++i) EXPECT_EQ(even[static_cast<size_t>(i)], i * (20e-3 / 32)) << "not finer: as ever";
}

/// Where a place of a soft, heavy rod of 20 mm is at rest, which is clamped along x and hangs: it bends within B/T = (0.6 mm)^2 of its clamp, and
/// is straight elsewhere. m.
Vec3 hangs(const std::vector<double>& rest, double place) {
  toolkit::Rod rod(toolkit::RodSection::round(22e-6, 0.05e9, 0.39, 25000), rest);
  const int n = rod.nodes();
  std::vector<double> numbers(toolkit::RodState::size(n), 0.0);
  toolkit::RodState s(n, numbers.data());
  double x = 0;
  for (int i = 0; i < n; ++i) s.x[3 * i] = x, x += i + 1 < n ? rest[static_cast<size_t>(i)] : 0;
  rod.hold(0);
  rod.clamp(0) = {true, Vec3::UnitX(), Vec3::UnitY()};
  rod.start(s);
  toolkit::RodLoad load;
  for (int k = 0; k <= 300; ++k) {
    load.gravity = {0, 0, -9.81 * std::pow(10.0, -4 + 4 * k / 300.0)};
    rod.step(s, load, 200, 1e-13);
  }
  double at = 0;
  for (int j = 0; j + 1 < n; ++j) {
    const double l = rest[static_cast<size_t>(j)];
    if (at + l >= place) return s.node(j) + (place - at) / l * s.edge(j);
    at += l;
  }
  return s.node(n - 1);
}

TEST(ThreadLengths, ATightBendIsAsRightAsWithFourTimesAsMany) {
  constexpr double kLength = 20e-3;
  const Vec3 right = hangs(lengths(kLength, 1600, {}), kLength);
  const auto error = [&](int n, const Finer& finer) { return (hangs(lengths(kLength, n, finer), kLength) - right).norm() / kLength; };
  const Finer fine{0, 1.5e-3, 8};

  EXPECT_LT(error(25, fine), error(100, {}));
  EXPECT_LT(error(50, fine), 0.35 * error(25, fine)) << "order 2";
}

/// A thread that hangs from its first end, with its middle finer.
TEST(ThreadLengths, WeighsAsMuchAndKnowsItsPlaces) {
  Bench b;
  b.bench.set("start", 1.0);
  b.bench.set("first", 1.0);
  b.bench.set("segments", 40);
  b.bench.set("finer", 8.0);
  b.bench.set("fine_from", 9e-3);
  b.bench.set("fine_to", 11e-3);
  b.start();
  for (int k = 0; k < 300; ++k) b.advance();
  const double weight = kLine * 20e-3 * 9.81, first = -b.node(1).z();
  EXPECT_NEAR(b.signal("thread.tension_first"), weight - 0.5 * kLine * first * 9.81, 0.02 * weight);
  EXPECT_NEAR(b.node(40).z(), -20e-3, 2e-6);
}

}  // namespace thread_lengths_test
}  // namespace swage::thread
