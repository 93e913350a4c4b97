// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A flexible thread, drawn as a smooth tube through the vertices of its chain. Free of Qt3D.
#pragma once

#include <QVector3D>
#include <optional>
#include <span>
#include <vector>

#include "console/view3d/mesh.hpp"
#include "console/view3d/vec.hpp"
#include "snapshot/scene_card.hpp"

namespace swage::console {

struct ThreadLine {
  uint32_t object = 0, body = 0;
  uint32_t first = 0;         // index of its first vertex among the snapshot's particles
  double radius = 0;          // m
  double longest = 0;         // m: a longer piece counts as broken
  std::vector<double> start;  // x y z [m, world] of its vertices at the start

  double length() const;  // m
  uint32_t vertices() const { return static_cast<uint32_t>(start.size() / 3); }
  /// The middle of the places at which it lies upon itself at the start, as in a knot. World, mm.
  std::optional<QVector3D> crossing() const;
  /// Triangles, world frame, mm. `least`: m, smallest visible radius.
  Mesh mesh(std::span<const double> p_W, double least) const;
  /// Triangles of its part [from, to] (0..1 by length), `grow` times as thick.
  Mesh part(std::span<const double> p_W, double least, double from, double to, double grow) const;
};

/// The threads of a scene that are drawn, in the order of the card.
std::vector<ThreadLine> find_threads(const snapshot::SceneCard& card);

/// The point nearest to `p` on a line of straight pieces through the points x y z; m, world.
Vec nearest_on(std::span<const double> line, const Vec& p);

/// Inserts points on a smooth curve through the points x y z of a line (Catmull and Rom), as many as keep the angle between
/// neighbouring segments small.
std::vector<double> smooth_line(std::span<const double> line);

}  // namespace swage::console
