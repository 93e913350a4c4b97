// SPDX-License-Identifier: Apache-2.0
//
// A torn place: what the section of the wire has swept of the plane of a hole, as a union of capsules of the wire's radius. Area and
// reach grow as it does.
//
// Plain doubles, part of a coupling's private state. Units m. Frames: O of the tissue; (1, 2) along the plane. [rt]
#pragma once

#include <cstdint>

#include "outline.hpp"

namespace swage::coupling_pierce {

struct Wound {
  static constexpr uint32_t kCapsules =
      Outline::kMost + 1;  // for one more, one that the others cover makes room

  double open;                            // 0: not there
  double origin[3], normal[3], first[3];  // O: centre of the first puncture, outward normal, axis 1
  double radius;                          // m, of the wire
  double count;                           // of capsules
  double area;                            // m2
  double reach;                           // m, greatest distance of the edge from the origin
  double wide;       // m, greatest distance of the edge from the wound's centre (thesis D4)
  double bend;       // m, by how much the last capsule cuts the corners of what it stands for
  double centre[2];  // where the section was last
  double inward[3];  // O, unit: the way into the tissue along the needle there
  double depth;      // m along the needle's track, as far as it is open from here
  double told;       // 1: pierce.torn was sent
  Capsule capsule[kCapsules];
};

/// A hole with its first section at p_O.
/// `settled` is what all of its capsules but the last enclose; any one will do, and one that it had before is the fastest.
void open_wound(Wound& wound, Outline& settled, const Vec3& p_O, const Vec3& normal_O, const Vec3& along_O,
                double radius) noexcept;
/// The section is now at p_O, cut by the plane at an angle whose cosine is `cosine`, leaning along `along_O`.
void sweep(Wound& wound, Outline& settled, const Vec3& p_O, double cosine, const Vec3& along_O) noexcept;

inline Vec3 axis(const Wound& w, int i) {
  const Vec3 n(w.normal[0], w.normal[1], w.normal[2]), e(w.first[0], w.first[1], w.first[2]);
  return i == 0 ? n : i == 1 ? e : n.cross(e);
}
inline Vec3 in_plane(const Wound& w, const double* at) {
  return Vec3(w.origin[0], w.origin[1], w.origin[2]) + at[0] * axis(w, 1) + at[1] * axis(w, 2);
}
inline Vec3 origin(const Wound& w) { return {w.origin[0], w.origin[1], w.origin[2]}; }

}  // namespace swage::coupling_pierce
