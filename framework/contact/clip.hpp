// SPDX-License-Identifier: Apache-2.0
//
// Parts of a curve: those below planes and those near a polyhedron. Room-internal.
#pragma once

#include "contact/curve.hpp"
#include "contact/narrow_phase.hpp"
#include "toolkit/fixed_vector.hpp"

namespace swage::contact {

template <class Curve>
using Stretches = toolkit::FixedVector<Stretch<typename Curve::Place>, 16>;

/// Makes `list` the whole curve.
template <class Curve>
void fill(Stretches<Curve>& list, const Curve& curve) {
  list.clear();
  for (int i = 0; i < curve.stretches(); ++i) list.add(curve.stretch(i));
}

/// Keeps the parts of all stretches where h <= 0 and marks their new ends `border`. A height has one peak per turn:
/// at most one stretch is split.
template <class Curve>
void clip(Stretches<Curve>& list, const typename Curve::Height& h, Border border = Border::kClipped) {
  int kept = 0;
  for (int i = 0; i < list.size(); ++i) {
    const auto from = list[i].from, to = list[i].to;
    const bool from_dead = h.at(from) > 0, to_dead = h.at(to) > 0;
    if (from_dead && to_dead && !Curve::has_valley(h, from, to)) continue;
    // without room for two parts the whole is kept: more work, no loss
    if (!from_dead && !to_dead && Curve::has_peak(h, from, to) && list.insert(i, list[i])) {
      list[i].to = Curve::rising(h, from, to), list[i].at_to = border;
      list[i + 1].from = Curve::falling(h, from, to), list[i + 1].at_from = border;
      list[kept++] = list[i++];
    }
    if (from_dead) list[i].from = Curve::falling(h, from, to), list[i].at_from = border;
    if (to_dead) list[i].to = Curve::rising(h, from, to), list[i].at_to = border;
    if (kept != i) list[kept] = list[i];
    ++kept;
  }
  list.shrink(kept);
}

/// Makes `list` the parts of the curve within reach(n) + `slack` of the plane of every face, n its normal, and marks the new ends
/// `border`. False: there are none; `memory` then takes a separating normal, if a face gives one.
template <class Curve, class Reach>
bool clip_to_reach(Stretches<Curve>& list, const Curve& curve, const toolkit::Convex& convex,
                   const Reach& reach, double slack, Border border, Separation& memory) {
  const auto apart = [&](const Vec3& n, double support) {
    return curve.lowest(curve.height(n, support)) > reach(n);
  };
  if (!memory.n_B.isZero() && apart(memory.n_B, convex.support(memory.n_B))) return false;
  fill(list, curve);
  for (const toolkit::Convex::Face& f : convex.face) {
    clip<Curve>(list, curve.height(f.n, f.d + reach(f.n) + slack), border);
    if (!list.empty()) continue;
    if (apart(f.n, f.d)) memory.n_B = f.n;
    return false;
  }
  return true;
}

/// The lowest of h over all stretches.
template <class Curve>
double lowest(const Stretches<Curve>& list, const typename Curve::Height& h) {
  double least = 1e300;
  for (const auto& s : list) least = std::min(least, Curve::lowest(h, s.from, s.to));
  return least;
}

}  // namespace swage::contact
