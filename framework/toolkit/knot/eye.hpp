// SPDX-License-Identifier: Apache-2.0
//
// Projection of a straightened thread along one direction: which sticks cross, which is nearer to the eye, and their order along the
// thread. All of it is exact; a degenerate view (three lines through a point, a corner on a line) is reported and not used.
// Header-only.
//
// Threads: [rt], nothing allocates.
#pragma once

#include "toolkit/knot/diagram.hpp"
#include "toolkit/knot/thread.hpp"

namespace swage::toolkit {

/// View along (a, b, 7) of the axes x y z, cyclically permuted by `axis`: directions in general position.
struct KnotView {
  int axis, a, b;
};

enum class KnotSight { kSound, kDegenerate, kEndsInside, kFull };

class KnotEye {
 public:
  KnotSight look(const KnotThread& thread, const KnotView& view, KnotDiagram& out);

 private:
  struct Flat {
    int64_t u, v;
  };
  struct Hit {
    int stick, crossing;
    bool over;
    Wide share, whole;  // of the stick
    double s;
  };
  static size_t at(int i) { return static_cast<size_t>(i); }
  static Flat flat(const GridPoint& p, const KnotView& view);
  static Wide turn(const Flat& a, const Flat& b, const Flat& c) {
    return Wide(b.u - a.u) * (c.v - a.v) - Wide(b.v - a.v) * (c.u - a.u);
  }
  /// True when two successive sticks lie on one another in a line; not when the second continues the first.
  static bool folds_back(const Flat& a, const Flat& b, const Flat& c) {
    return turn(a, b, c) == 0 && Wide(b.u - a.u) * (c.u - b.u) + Wide(b.v - a.v) * (c.v - b.v) <= 0;
  }
  static bool earlier(const Hit& a, const Hit& b) {
    return a.stick != b.stick ? a.stick < b.stick : a.share * b.whole < b.share * a.whole;
  }
  static Hit hit(const KnotThread& thread, int stick, Wide from, Wide to, bool over, int crossing);
  bool ends_outside(int vertices) const;
  KnotSight cross(const KnotThread& thread, int i, int j);
  KnotSight order();

  std::array<Flat, KnotThread::kVertices> flat_;
  std::array<Hit, 2 * KnotDiagram::kCrossings> hit_;
  std::array<KnotVisit, 2 * KnotDiagram::kCrossings> code_;
  std::array<int8_t, KnotDiagram::kCrossings> sign_;
  int n_ = 0;
};

inline KnotEye::Flat KnotEye::flat(const GridPoint& p, const KnotView& view) {
  const int64_t c[3] = {p.x, p.y, p.z};
  const int64_t x = c[view.axis], y = c[(view.axis + 1) % 3], z = c[(view.axis + 2) % 3];
  return {7 * x - view.a * z, 7 * y - view.b * z};
}

/// True when both far ends are outside everything else, so that they can be joined around it.
inline bool KnotEye::ends_outside(int n) const {
  Flat lo{INT64_MAX, INT64_MAX}, hi{INT64_MIN, INT64_MIN};
  for (int i = 1; i < n - 1; ++i) {
    lo = {std::min(lo.u, flat_[at(i)].u), std::min(lo.v, flat_[at(i)].v)};
    hi = {std::max(hi.u, flat_[at(i)].u), std::max(hi.v, flat_[at(i)].v)};
  }
  const auto out = [&](const Flat& f) { return f.u < lo.u || f.u > hi.u || f.v < lo.v || f.v > hi.v; };
  return n == 2 || (out(flat_[0]) && out(flat_[at(n - 1)]));
}

inline KnotEye::Hit KnotEye::hit(const KnotThread& thread, int stick, Wide from, Wide to, bool over,
                                         int crossing) {
  const Wide share = from < 0 ? -from : from, whole = share + (to < 0 ? -to : to);
  const double s = thread.vertex[at(stick)].s, next = thread.vertex[at(stick + 1)].s;
  return {stick, crossing, over, share, whole,
          s + (next - s) * (static_cast<double>(share) / static_cast<double>(whole))};
}

/// Adds the crossing of the sticks i < j - 1 if they cross, with the stick that is nearer to the eye.
inline KnotSight KnotEye::cross(const KnotThread& thread, int i, int j) {
  const Flat &a = flat_[at(i)], &b = flat_[at(i + 1)], &c = flat_[at(j)], &d = flat_[at(j + 1)];
  if (std::max(a.u, b.u) < std::min(c.u, d.u) || std::max(c.u, d.u) < std::min(a.u, b.u)) return KnotSight::kSound;
  if (std::max(a.v, b.v) < std::min(c.v, d.v) || std::max(c.v, d.v) < std::min(a.v, b.v)) return KnotSight::kSound;
  const Wide tc = turn(a, b, c), td = turn(a, b, d), ta = turn(c, d, a), tb = turn(c, d, b);
  if (sign_of(tc) * sign_of(td) > 0 || sign_of(ta) * sign_of(tb) > 0) return KnotSight::kSound;
  const int above = orientation(thread.vertex[at(i)].grid(), thread.vertex[at(i + 1)].grid(),
                                thread.vertex[at(j)].grid(), thread.vertex[at(j + 1)].grid());
  if (tc == 0 || td == 0 || ta == 0 || tb == 0 || above == 0) return KnotSight::kDegenerate;
  if (n_ + 2 > 2 * KnotDiagram::kCrossings) return KnotSight::kFull;
  // tc < 0 < td: the second crosses the first from its right to its left
  const bool first_over = above == (tc < 0 ? 1 : -1);
  const int k = n_ / 2;
  sign_[at(k)] = static_cast<int8_t>(above);
  hit_[at(n_++)] = hit(thread, i, ta, tb, first_over, k);
  hit_[at(n_++)] = hit(thread, j, tc, td, !first_over, k);
  return KnotSight::kSound;
}

inline KnotSight KnotEye::order() {
  std::sort(hit_.begin(), hit_.begin() + n_, earlier);
  for (int i = 0; i + 1 < n_; ++i)
    if (!earlier(hit_[at(i)], hit_[at(i + 1)])) return KnotSight::kDegenerate;
  return KnotSight::kSound;
}

inline KnotSight KnotEye::look(const KnotThread& thread, const KnotView& view, KnotDiagram& out) {
  n_ = 0;
  const int n = thread.vertices();
  for (int i = 0; i < n; ++i) flat_[at(i)] = flat(thread.vertex[at(i)].grid(), view);
  if (!ends_outside(n)) return KnotSight::kEndsInside;
  for (int i = 0; i + 2 < n; ++i)
    if (folds_back(flat_[at(i)], flat_[at(i + 1)], flat_[at(i + 2)])) return KnotSight::kDegenerate;
  for (int i = 0; i < n - 1; ++i)
    for (int j = i + 2; j < n - 1; ++j)
      if (const KnotSight seen = cross(thread, i, j); seen != KnotSight::kSound) return seen;
  if (const KnotSight seen = order(); seen != KnotSight::kSound) return seen;
  for (int i = 0; i < n_; ++i)
    code_[at(i)] = {static_cast<int16_t>(hit_[at(i)].crossing), hit_[at(i)].over, hit_[at(i)].s};
  out.set(code_.data(), n_, sign_.data(), n_ / 2);
  return KnotSight::kSound;
}

}  // namespace swage::toolkit
