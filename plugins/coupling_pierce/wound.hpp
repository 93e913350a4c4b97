// SPDX-License-Identifier: Apache-2.0
//
// A torn place: the area that the section of the wire has swept in the plane of a hole, as a union of capsules of the wire's radius. Area
// and reach grow with each swept capsule.
//
// Plain doubles, part of a coupling's private state. Units m. Frames: O of the tissue; (1, 2) along the plane. [rt]
#pragma once

#include <cstdint>

#include "outline.hpp"

namespace swage::coupling_pierce {

struct Wound {
  static constexpr uint32_t kCapsules =
      Outline::kMost + 1;  // when full, a capsule that the others cover is dropped

  double open;                            // 0: there is no wound
  double origin[3], normal[3], first[3];  // O: centre of the first puncture, outward normal, axis 1
  double radius;                          // m, of the wire
  double count;                           // of capsules
  double area;                            // m2
  double reach;                           // m, greatest distance of the edge from the origin
  double wide;       // m, greatest distance of the edge from the wound's centre (thesis D4)
  double bend;       // m, by how much the last capsule cuts the corners of the path that it represents
  double centre[2];  // m, (1, 2): last position of the section
  double inward[3];  // O, unit: direction into the tissue along the needle there
  double depth;      // m along the needle's track, open from this wound on
  double told;       // 1: pierce.torn was sent
  Capsule capsule[kCapsules];
};

/// Opens a hole with its first section at p_O.
/// `settled`: outline of all capsules of the wound but the last; any outline is valid here, and the wound's former one is the fastest.
void open_wound(Wound& wound, Outline& settled, const Vec3& p_O, const Vec3& normal_O, const Vec3& along_O,
                double radius) noexcept;
/// Moves the section to p_O: the plane cuts the wire at an angle whose cosine is `cosine`, elongated along `along_O`.
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
