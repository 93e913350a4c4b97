// SPDX-License-Identifier: Apache-2.0
//
// Stray touches (M52): needle or jaws on the tissue where the task does not want them. Frames: W. Units m, s. [rt]
#pragma once

#include <swage/peer.hpp>

#include <algorithm>

#include "toolkit/math.hpp"

namespace swage::lesson_insertion {

using toolkit::Vec3;

/// Doubles only.
struct StrayTouch {
  double on = 0, clear_s = 0;  // 0 or 1: it touches; s, since it did
};
struct StrayState {
  double count = 0;
  StrayTouch needle, jaws;
};

/// Counts a touch that begins; what touches again within kPause is still the same touch.
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

/// How deep a place is in a tissue, negative outside: under its surface, before its far side, within its rim.
inline double depth_in(const swage_pierceable_place& p) { return std::min({p.depth, -p.beyond, p.edge}); }

/// Of places on a line, `apart` from each other, how many after one are as surely outside as that. Half of what its distance from
/// the tissue says: where a surface bends, the nearest place of it that was found need not be the nearest.
inline int as_far_outside(const swage_pierceable_place& p, double apart) {
  const double away = 0.5 * std::max(-p.depth, p.beyond);
  return away > apart ? static_cast<int>(std::min(away / apart, 1e3)) : 0;
}

/// Where the task has the needle touch the tissue.
struct Region {
  Vec3 middle[2] = {Vec3::Zero(), Vec3::Zero()};  // the mark, or where the needle went in and came out
  int count = 1;
  Vec3 normal = Vec3::UnitZ();  // unit
  double radius = 0;            // along the surface
  double s_out = 0, s_in = -1;  // what is in its track; none while s_in < s_out

  bool has(const Vec3& p) const {
    for (int i = 0; i < count; ++i) {
      const Vec3 off = p - middle[i];
      if ((off - off.dot(normal) * normal).norm() <= radius) return true;
    }
    return false;
  }
};

/// Whether the needle touches the tissue anywhere else, by kPlaces places along it.
inline bool needle_astray(const Peer& needle, const Step& needle_step, const Peer& tissue,
                          const Step& tissue_step, const Region& region) noexcept {
  constexpr int kPlaces =
      16;  // 0.4 mm apart on a 6 mm needle: what lies between two lies 10 um deeper at most
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

/// Whether one of the jaws is in the tissue: the line from its hinge to its tip. `hinge`: the origins of the two bodies.
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
