// SPDX-License-Identifier: Apache-2.0
//
// Whether a chain of straight pieces has passed through itself in a step, each node on a straight line: two pieces pass where the volume
//
//     f(t) = (u x w) . d,    u, w: the pieces; d: from one to the other; all linear in t, f of the third degree
//
// that they span changes sign while they cross. A passage and its return within one step cancel. Header-only, pure, [rt].
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "toolkit/math.hpp"

namespace swage::toolkit {

/// Two pieces: from p to p + u, and from p + d to p + d + w.
struct TwoPieces {
  Vec3 u, w, d;
};

/// True when the two pieces pass an odd number of times between the two states.
inline bool pieces_pass(const TwoPieces& from, const TwoPieces& to) {
  const Vec3 du = to.u - from.u, dw = to.w - from.w, dd = to.d - from.d;
  const auto det = [](const Vec3& a, const Vec3& b, const Vec3& c) { return a.cross(b).dot(c); };
  const double c0 = det(from.u, from.w, from.d);
  const double c1 = det(du, from.w, from.d) + det(from.u, dw, from.d) + det(from.u, from.w, dd);
  const double c2 = det(du, dw, from.d) + det(du, from.w, dd) + det(from.u, dw, dd), c3 = det(du, dw, dd);
  const auto f = [&](double t) { return c0 + t * (c1 + t * (c2 + t * c3)); };
  // extrema of f, between which it is monotone
  double at[4] = {0, 1, 1, 1};
  int n = 1;
  const double square = c2 * c2 - 3 * c1 * c3;
  if (square > 0) {
    const double q = -(c2 + std::copysign(std::sqrt(square), c2));
    double t0 = q / (3 * c3), t1 = c1 / q;
    if (!(t0 <= t1)) std::swap(t0, t1);
    for (const double t : {t0, t1})
      if (t > 0 && t < 1) at[n++] = t;
  }
  at[n] = 1;
  bool passed = false;
  for (int k = 0; k < n; ++k) {
    double low = at[k], high = at[k + 1];
    const bool rises = f(high) >= 0;
    if ((f(low) >= 0) == rises) continue;
    for (int i = 0; i < 60 && low < high; ++i) {
      const double middle = 0.5 * (low + high);
      ((f(middle) >= 0) == rises ? high : low) = middle;
    }
    const Vec3 u = from.u + high * du, w = from.w + high * dw, d = from.d + high * dd, normal = u.cross(w);
    const double s = d.cross(w).dot(normal), r = d.cross(u).dot(normal), all = normal.squaredNorm();
    if (s >= 0 && s < all && r >= 0 && r < all) passed = !passed;
  }
  return passed;
}

/// Number of passages of a chain of n nodes through itself between x0 and x1 (3 n numbers each). `boxes`: room, 6 numbers per piece and
/// per eight pieces: room_for_passages(n). `there(j)`: whether piece j exists.
inline size_t room_for_passages(int n) { return 6 * static_cast<size_t>(n + n / 8 + 2); }
template <class There>
int passages(int n, const double* x0, const double* x1, const There& there, std::span<double> boxes) {
  constexpr int kGroup = 8;
  const int edges = n - 1, groups = (edges + kGroup - 1) / kGroup;
  const auto box = [&](int k) { return boxes.data() + 6 * k; };
  const auto grow = [](double* to, const double* low, const double* high) {
    for (int r = 0; r < 3; ++r) to[r] = std::min(to[r], low[r]), to[3 + r] = std::max(to[3 + r], high[r]);
  };
  const auto clear = [](double* b) { std::fill_n(b, 3, HUGE_VAL), std::fill_n(b + 3, 3, -HUGE_VAL); };
  const auto meet = [](const double* a, const double* b) {
    for (int r = 0; r < 3; ++r)
      if (a[r] > b[3 + r] || b[r] > a[3 + r]) return false;
    return true;
  };
  for (int j = 0; j < edges; ++j) {
    clear(box(j));
    for (const double* x : {x0 + 3 * j, x0 + 3 * j + 3, x1 + 3 * j, x1 + 3 * j + 3}) grow(box(j), x, x);
    double* group = box(edges + j / kGroup);
    if (j % kGroup == 0) clear(group);
    grow(group, box(j), box(j) + 3);
  }
  const auto pieces = [](const double* x, int i, int j) {
    const auto at = [x](int k) { return Vec3(x[3 * k], x[3 * k + 1], x[3 * k + 2]); };
    return TwoPieces{at(i + 1) - at(i), at(j + 1) - at(j), at(j) - at(i)};
  };
  int count = 0;
  for (int a = 0; a < groups; ++a)
    for (int b = a; b < groups; ++b) {
      if (!meet(box(edges + a), box(edges + b))) continue;
      for (int i = kGroup * a; i < std::min(edges, kGroup * (a + 1)); ++i)
        for (int j = std::max(i + 2, kGroup * b); j < std::min(edges, kGroup * (b + 1)); ++j)
          if (meet(box(i), box(j)) && there(i) && there(j)) count += pieces_pass(pieces(x0, i, j), pieces(x1, i, j));
    }
  return count;
}

/// Whether all pieces point the same way, at both ends of the step and so within it: then none of them comes back to another.
inline bool runs_one_way(int n, const double* x0, const double* x1) {
  const auto at = [](const double* x, int i) { return Vec3(x[3 * i], x[3 * i + 1], x[3 * i + 2]); };
  const Vec3 way = at(x1, n - 1) - at(x1, 0);
  for (const double* x : {x0, x1}) {
    double before = way.dot(at(x, 0));
    for (int i = 1; i < n; ++i) {
      const double now = way.dot(at(x, i));
      if (!(now > before)) return false;
      before = now;
    }
  }
  return true;
}

/// Whether the chain turns back somewhere, and some node moves farther than a quarter of the radius relative to the mean motion of the
/// chain: less passes through nothing, and a search for passages costs 20 us of 200 pieces.
inline bool may_have_passed(int n, const double* x0, const double* x1, double radius) {
  constexpr double kFar = 0.25;
  if (runs_one_way(n, x0, x1)) return false;
  const auto gone = [=](int i) { return Vec3(x1[3 * i] - x0[3 * i], x1[3 * i + 1] - x0[3 * i + 1], x1[3 * i + 2] - x0[3 * i + 2]); };
  Vec3 mean = Vec3::Zero();
  for (int i = 0; i < n; ++i) mean += gone(i) / n;
  double most = 0;
  for (int i = 0; i < n; ++i) most = std::max(most, (gone(i) - mean).squaredNorm());
  return most >= kFar * radius * kFar * radius;
}

}  // namespace swage::toolkit
