// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Wounds as a surgeon sees them: an opening whose raw edges lie bare, within a lip of swollen tissue. Free of Qt3D.
#pragma once

#include "console/view3d/soft_surface.hpp"

namespace swage::console {

/// Triangles in three colours, world, mm.
struct WoundMeshes {
  Mesh lip;    // around the wound: swollen, higher than the surface
  Mesh flesh;  // the torn region, to scale
  Mesh depth;  // the opening in it: as wide as the needle where it is, closing up away from it
};

/// Where a needle went in, where it came out, or not known which.
enum class WoundKind { kUnknown, kEntry, kExit };

/// What of a wound is framed when it is looked at. World, mm.
struct WoundPlace {
  QVector3D middle, normal{0, 0, 1};
  QVector3D puncture;  // its first place
  float radius = 0;    // of a sphere that holds it
  double ratio = 0;    // its edge's greatest distance from the first puncture over the wire's radius: 1 is perfect
  int of = 0;          // how many wounds there are
  WoundKind kind = WoundKind::kUnknown;
  bool there() const { return radius > 0; }
};

/// Where a place that is told as it is along the surface lies while nothing is displaced. World, mm.
QVector3D at_rest(const std::vector<Dent>& dents, const QVector3D& p, const QVector3D& normal);

/// Adds the wounds that `tears` make, on the dented surface. All capsules of one wound are one region.
void append_wounds(const std::vector<Tear>& tears, const std::vector<Dent>& dents, WoundMeshes& out);

/// Where the needle last went into each tissue, and came out. World, mm.
struct Punctures {
  std::vector<QVector3D> entries, exits;
};
/// By the nearest of them. Wounds of earlier bites are near none.
WoundKind kind_of_wound(const QVector3D& puncture, const Punctures& last);

/// The one whose edge is furthest from its first puncture; none when there are no tears. Those of the last bite come first: a hole that was
/// given up is shown only while there is no other.
WoundPlace greatest_wound(const std::vector<Tear>& tears, const std::vector<Dent>& dents, const Punctures& last = {});

}  // namespace swage::console
