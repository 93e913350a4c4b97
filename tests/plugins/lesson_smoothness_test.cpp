// SPDX-License-Identifier: Apache-2.0
//
// Smoothness of movements against the golden values of its authors, a closed form, and the transform written out.
//
// Golden: the example of the authors' program (github.com/siva82kb/smoothness), v = exp(-5 t^2) from t = -1 s to 1 s at 100 Hz: SPARC
// -1.41403, LDLJ -5.81636.
// Closed form: the reach of least jerk has v = 30 D/T u^2 (1 - u)^2, u = t/T, so v_peak = 15/8 D/T, d2v/dt2 = 30 D/T^3 (2 - 12 u + 12 u^2)
// and the integral of its square is 900 * 0.8 D^2/T^5: LDLJ = - ln(720 / (15/8)^2) = - ln 204.8.
#include <gtest/gtest.h>

#include <complex>
#include <functional>
#include <numbers>
#include <vector>

#include "lessons/common/watches.hpp"

namespace swage::lessons {
namespace {

constexpr double kH = 0.01;  // s

std::vector<double> authors_example() {
  std::vector<double> v;
  for (int i = 0; i < 200; ++i) v.push_back(std::exp(-5 * std::pow(-1 + kH * i, 2)));
  return v;
}
/// Speed of the reach of least jerk over `way` [m] in `time` [s].
double least_jerk(double way, double time, double t) {
  const double u = std::clamp(t / time, 0.0, 1.0);
  return 30 * way / time * u * u * (1 - u) * (1 - u);
}

/// LDLJ of that reach where it is quicker than `slow` [m/s] only, from u0 to 1 - u0: the integral of (2 - 12 u + 12 u^2)^2 is G(1 - u0) - G(u0).
double cut_short(double slow, double way, double time) {
  const double x = std::sqrt(slow * time / (30 * way)), u0 = 0.5 - std::sqrt(0.25 - x);  // u (1 - u) = x
  const auto G = [](double u) { return u * (4 + u * (-24 + u * (64 + u * (-72 + 28.8 * u)))); };
  return -std::log(900 * (G(1 - u0) - G(u0)) * std::pow(1 - 2 * u0, 3) / std::pow(15.0 / 8, 2));
}

/// SPARC as its authors compute it: a transform padded to 2^4 times the next power of two, up to 10 Hz.
double written_out(const std::vector<double>& v) {
  size_t n = 1;
  while (n < v.size()) n *= 2;
  n *= 16;
  const auto last = static_cast<size_t>(10 * static_cast<double>(n) * kH);
  std::vector<double> M;
  for (size_t k = 0; k <= last; ++k) {
    std::complex<double> sum = 0;
    for (size_t i = 0; i < v.size(); ++i)
      sum += v[i] * std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(k * i) / static_cast<double>(n));
    M.push_back(std::abs(sum));
  }
  const double most = *std::max_element(M.begin(), M.end());
  size_t to = M.size() - 1;
  while (M[to] < 0.05 * most) --to;
  double sum = 0;
  for (size_t k = 0; k < to; ++k) sum += std::hypot(1.0 / static_cast<double>(to), (M[k + 1] - M[k]) / most);
  return -sum;
}

double sparc(const std::vector<double>& v) {
  const Spectrum spectrum(kH);
  SpectrumState s;
  for (const double x : v) spectrum.add(s, x);
  return Spectrum::arc_length(s);
}
double ldlj(const std::vector<double>& v, double h) {
  JerkState s;
  for (const double x : v) add_jerk(s, x, h);
  return log_jerk(s, h);
}

TEST(Smoothness, HasTheGoldenValuesOfItsAuthors) {
  const std::vector<double> v = authors_example();
  EXPECT_NEAR(written_out(v), -1.41403, 5e-6) << "the test's own transform";
  // on a grid of 0.025 instead of 0.0244 Hz the cut-off is another one
  EXPECT_NEAR(sparc(v), -1.41403, 1.5e-3);
  EXPECT_NEAR(ldlj(v, kH), -5.81636, 5e-6);
}

TEST(Smoothness, OfTheReachOfLeastJerk) {
  double before = 1;
  for (const double h : {0.01, 0.005, 0.0025}) {
    std::vector<double> v;
    for (double t = 0; t < 1.5 + 0.5 * h; t += h) v.push_back(least_jerk(40e-3, 1.5, t));
    const double error = std::abs(ldlj(v, h) + std::log(204.8));
    EXPECT_LT(error, 0.6 * before) << h;
    before = error;
  }
  EXPECT_LT(before, 0.005);
  for (const double time : {0.3, 1.5, 5.0}) {
    std::vector<double> v;
    for (double t = 0; t < time; t += kH) v.push_back(least_jerk(4e-3, time, t));
    EXPECT_NEAR(sparc(v), written_out(v), 0.012) << time;
  }
}

// a reach with two stops halfway is less smooth, however large it is
TEST(Smoothness, FallsWithTheStops) {
  const auto reach = [](double size, double dip) {
    std::vector<double> v;
    for (double t = 0; t < 1.5; t += kH) v.push_back(size * least_jerk(1, 1.5, t) * (1 - dip * std::pow(std::sin(3 * std::numbers::pi * t / 1.5), 2)));
    return v;
  };
  EXPECT_GT(sparc(reach(1, 0)), -1.45);
  EXPECT_LT(sparc(reach(1, 0.5)), sparc(reach(1, 0)) - 0.1);
  EXPECT_LT(sparc(reach(1, 0.9)), sparc(reach(1, 0.5)) - 0.1);
  EXPECT_NEAR(sparc(reach(1e-3, 0.9)), sparc(reach(1, 0.9)), 1e-9);
  EXPECT_EQ(sparc(std::vector<double>(50, 0.0)), 0);
  EXPECT_EQ(ldlj(std::vector<double>(50, 0.0), kH), 0);
}

/// The tips along x, with a speed [m/s] at a time.
PathState walked(double seconds, const std::function<double(double)>& speed, double tremor = 0) {
  const PathWatch watch(1e-3);
  PathState state;
  double x = 0;
  for (int i = 0; i < static_cast<int>(1000 * seconds); ++i) {
    const double t = 1e-3 * i;
    x += 1e-3 * speed(t);
    watch.look(state, Vec3(x, tremor * std::numbers::sqrt2 * std::sin(2 * std::numbers::pi * 10 * t), 0), t);
  }
  return state;
}

TEST(Smoothness, OfEachMovementOfAHand) {
  // 5 mm, a rest of a second, 40 mm, and 0.2 mm that is no movement
  const auto speed = [](double t) {
    return least_jerk(5e-3, 1, t - 0.5) + least_jerk(40e-3, 1.5, t - 2.5) + least_jerk(0.2e-3, 0.3, t - 5);
  };
  for (const double tremor : {0.0, 38e-6}) {
    const PathState s = walked(6, speed, tremor);
    ASSERT_EQ(s.moves.sparc.n, 2) << tremor;
    for (int k = 0; k < 2; ++k) EXPECT_NEAR(s.moves.sparc.value[k], -1.41, 0.03) << tremor;
    ASSERT_EQ(s.moves.ldlj.n, 1) << "only the long one";
    EXPECT_NEAR(s.moves.ldlj.value[0], cut_short(0.5e-3, 40e-3, 1.5), tremor > 0 ? 0.2 : 0.05) << "what is left of the tremor jerks";
  }
  EXPECT_FALSE(smoothness({}, &MovesState::sparc).has_value());
}

TEST(Smoothness, IsTheMedianOfAllHands) {
  MedianState s;
  for (const double x : {-2.0, -1.4, -3.0}) add_value(s, x);
  EXPECT_EQ(median(s), -2);
  add_value(s, -1.5);
  EXPECT_EQ(median(s), -1.75);
  for (int i = 0; i < 300; ++i) add_value(s, -1);
  EXPECT_EQ(s.n, MedianState::kMost);

  PathState hands[2];
  add_value(hands[0].moves.sparc, -1.4), add_value(hands[0].moves.sparc, -1.6), add_value(hands[1].moves.sparc, -2.8);
  EXPECT_EQ(smoothness(hands, &MovesState::sparc), -1.6);
  EXPECT_FALSE(smoothness(hands, &MovesState::ldlj).has_value());
}

}  // namespace
}  // namespace swage::lessons
