// SPDX-License-Identifier: Apache-2.0
//
// Stray touches (M52) of needle or jaws: on tissue outside the region of the task. Frames: W. Units m, s. [rt]
#pragma once

#include <swage/peer.hpp>

#include <algorithm>

#include "toolkit/math.hpp"

namespace swage::lesson_insertion {

using toolkit::Vec3;

/// Doubles only.
struct StrayTouch {
  double on = 0, clear_s = 0;  // 0 or 1: a touch is being counted; s, since the last contact
};
struct StrayState {
  double count = 0;
  StrayTouch needle, jaws;
};

/// Counts touches; contact again within kPause belongs to the same touch.
inline void follow_touch(StrayState& s, StrayTouch& touch, bool now, double dt) noexcept {
  constexpr double kPause = 0.15;  // s
  touch.clear_s = now ? 0 : touch.clear_s + dt;
  if (now && touch.on == 0) s.count += 1;
  if (now) touch.on = 1;
  if (touch.clear_s >= kPause) touch.on = 0;
}
inline void follow_stray(StrayState& s, bool needle, bool jaws, double dt) noexcept {
  follow_touch(s, s.needle, needle, dt);
  follow_touch(s, s.jaws, jaws, dt);
}

/// Depth of a place in a tissue, m, negative outside: the least of those under its surface, before its far side and within its rim.
inline double depth_in(const swage_pierceable_place& p) { return std::min({p.depth, -p.beyond, p.edge}); }

/// Number of places after this one, `apart` [m] from each other on a line, that are outside the tissue too, by half of its distance from
/// the tissue: on a curved surface the nearest place that was found may be farther than the true one.
inline int as_far_outside(const swage_pierceable_place& p, double apart) {
  const double away = 0.5 * std::max(-p.depth, p.beyond);
  return away > apart ? static_cast<int>(std::min(away / apart, 1e3)) : 0;
}

/// Region in which the needle may touch the tissue.
struct Region {
  Vec3 middle[2] = {Vec3::Zero(), Vec3::Zero()};  // m, the mark, or the entry and the exit
  int count = 1;
  Vec3 normal = Vec3::UnitZ();  // unit
  double radius = 0;            // m, along the surface
  double s_out = 0, s_in = -1;  // part of the needle in its track, 0..1; none while s_in < s_out

  bool has(const Vec3& p) const {
    for (int i = 0; i < count; ++i) {
      const Vec3 off = p - middle[i];
      if ((off - off.dot(normal) * normal).norm() <= radius) return true;
    }
    return false;
  }
};

/// Whether the needle touches the tissue outside the region, tested at kPlaces + 1 places along it.
inline bool needle_astray(const Peer& needle, const Step& needle_step, const Peer& tissue,
                          const Step& tissue_step, const Region& region) noexcept {
  constexpr int kPlaces =
      16;  // 0.4 mm apart on a 6 mm needle: the arc between two is at most 10 um deeper
  for (int i = 0; i <= kPlaces; ++i) {
    const double s = static_cast<double>(i) / kPlaces;
    if (s >= region.s_out && s <= region.s_in) continue;
    const auto at = needle.place(needle_step, s);
    if (!at || region.has(toolkit::vec(at->p_W))) continue;
    const auto in = tissue.inside(tissue_step, at->p_W);
    if (!in) continue;
    if (depth_in(*in) > -at->radius) return true;
    i += as_far_outside(*in, at->length / kPlaces + 2 * at->radius);
  }
  return false;
}

/// Whether one of the jaws, the line from its hinge to its tip, is in the tissue. `hinge`: the origins of the two bodies, m.
inline bool jaws_astray(const swage_gripper_state& jaws, const Vec3 (&hinge)[2], const Peer& tissue,
                        const Step& step) noexcept {
  constexpr int kPlaces = 8;
  const Vec3 tips = toolkit::vec(jaws.tip_W), closing = toolkit::vec(jaws.closing_W);
  for (int jaw = 0; jaw < 2; ++jaw) {
    const double apart = (tips - hinge[jaw]).norm() * std::tan(0.5 * jaws.opening);
    const Vec3 tip = tips + (jaw == 0 ? apart : -apart) * closing, way = (hinge[jaw] - tip) / kPlaces;
    const double apart_m = way.norm();
    for (int i = 0; i < kPlaces; ++i) {
      const auto in = tissue.inside(step, toolkit::raw(Vec3(tip + i * way)));
      if (!in) continue;
      if (depth_in(*in) > 0) return true;
      i += as_far_outside(*in, apart_m);
    }
  }
  return false;
}

}  // namespace swage::lesson_insertion
