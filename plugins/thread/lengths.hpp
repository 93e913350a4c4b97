// SPDX-License-Identifier: Apache-2.0
//
// How long each segment of a thread is: the same all along, or shorter in a part of it where it is bent tightly, as in a swage or a knot.
//
// There they are l0 long; away from it each is longer than the one before by kGrows at most, up to `finer` times l0:
//   l(s) = min(finer l0, l0 + kGrows d(s)),   d: the way from s to that part.
// n segments are n equal parts of the integral of ds / l(s), which falls as l0 rises: l0 is found by halving an interval.
// Header-only. Units: m. Threads: [main].
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace swage::thread {

/// Where a thread has shorter segments, and how many times shorter. 1: nowhere.
struct Finer {
  double from = 0, to = 0;  // m, arc lengths
  double times = 1;
};

/// Growth from segment to segment, to first order. 0.25: the error of second order at the change of two lengths stays below that of the longer
/// one. Larger: the rod is stiffer on one side of a node than on the other; smaller: more segments between fine and coarse.
inline constexpr double kGrows = 0.25;

/// Arc lengths of the n + 1 nodes of a thread, from 0 to `length`.
inline std::vector<double> node_places(double length, int n, const Finer& finer) {
  std::vector<double> s(static_cast<size_t>(n) + 1);
  if (!(finer.times > 1)) {
    for (int i = 0; i <= n; ++i) s[static_cast<size_t>(i)] = i * (length / n);
    return s;
  }
  constexpr int kParts = 20000;  // of the integral: a segment of 1/200 of a thread has 100, and is right to 1e-4
  const double part = length / kParts;
  const auto segment = [&](int k, double l0) {
    const double at = (k + 0.5) * part, away = std::max({0.0, finer.from - at, at - finer.to});
    return std::min(finer.times * l0, l0 + kGrows * away);
  };
  const auto count = [&](double l0) {
    double sum = 0;
    for (int k = 0; k < kParts; ++k) sum += part / segment(k, l0);
    return sum;
  };
  double low = length / n / finer.times, high = length / n;
  for (int i = 0; i < 60; ++i) {
    const double l0 = 0.5 * (low + high);
    (count(l0) > n ? low : high) = l0;
  }
  const double each = count(low) / n;
  double sum = 0;
  size_t next = 1;
  for (int k = 0; k < kParts && next < s.size(); ++k) {
    const double more = part / segment(k, low);
    for (; next < s.size() && static_cast<double>(next) * each <= sum + more; ++next)
      s[next] = part * (k + (static_cast<double>(next) * each - sum) / more);
    sum += more;
  }
  s.back() = length;
  return s;
}

}  // namespace swage::thread
