// SPDX-License-Identifier: Apache-2.0
//
// A place where two bodies touch or may touch within this step, kept so that its gap can be found again at
// any trial pose for a few dozen flops. The solver of the contact dynamics calls `reevaluate` in its Newton
// iteration.
//
// Units: m. Frames: A and B the two bodies, W world. Threads: any; nothing allocates or throws.
#pragma once

#include <cstdint>

#include "toolkit/arc.hpp"
#include "toolkit/math.hpp"

namespace swage::contact {

using toolkit::Frame;
using toolkit::Mat3;
using toolkit::Pose;
using toolkit::Vec3;

/// The touching part of a surface: a carrier (point, segment, circle or plane) in the frame of its
/// body. The surface is at the distance `tube` from the carrier.
struct Feature {
  enum Kind : uint8_t { kPoint, kSegment, kCircle, kPlane };
  Kind kind = kPoint;
  double tube = 0;        // m, radius of the wire or ball around the carrier, 0 for a polyhedron
  Vec3 p = Vec3::Zero();  // kPoint: itself. kSegment: its start. kCircle: its centre. kPlane: a point on it
  Vec3 u = Vec3::Zero();  // kSegment: end - start. kCircle: first axis, unit. kPlane: outward normal, unit
  Vec3 v = Vec3::Zero();  // kCircle: second axis, unit
  double radius = 0;      // m, kCircle
  toolkit::Turn e;        // kCircle: the touching place when found
  toolkit::Turn from, upto;  // kCircle: the stretch, under half a turn, within which that place may move
};

/// What a solver needs to know about one contact at given poses.
struct Touch {
  double gap = 0;            // m, negative when overlapping
  Vec3 p_W = Vec3::Zero();   // m, midway between the surfaces
  Vec3 n_W = Vec3::UnitZ();  // unit, from b into a; d gap / d (p_a - p_b) = n
};

/// Two features close enough to matter in this step.
struct Candidate {
  Feature a, b;              // in the frames of body a and of body b
  Vec3 n_B = Vec3::UnitZ();  // unit, from b into a when found, in b: gives the gap its sign once carriers cross
  uint64_t feature = 0;      // which features and which point of a line; equal while the touch lasts
  double weight = 1;         // share of a line contact that this point stands for, 0..1
  Touch touch;               // at the poses of `detect`
};

/// The same contact with the bodies at X_WA and X_WB: closest points of the two carriers (segments end where
/// they end, the touching point of an arc stays within its stretch), no search over other features.
/// Continuous in the poses.
Touch reevaluate(const Candidate& candidate, const Frame& X_WA, const Frame& X_WB) noexcept;
inline Touch reevaluate(const Candidate& candidate, const Pose& X_WA, const Pose& X_WB) noexcept {
  return reevaluate(candidate, Frame(X_WA), Frame(X_WB));
}

}  // namespace swage::contact
