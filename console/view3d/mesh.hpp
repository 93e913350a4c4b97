// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Triangles of the shapes on a scene card. No Qt3D here, so that they are tested without a window.
#pragma once

#include <cstdint>
#include <vector>

#include "snapshot/scene_card.hpp"

namespace swage::console {

/// Millimetres per metre. The view works in mm: a needle is 6 units long, well scaled for floats and depth buffers.
inline constexpr double kMmPerM = 1000.0;

struct Vertex {
  float p[3];  // mm, in the body's frame
  float n[3];  // unit, outward
};

/// Triangles counter-clockwise seen from outside.
struct Mesh {
  std::vector<Vertex> vertex;
  std::vector<uint32_t> index;
};

/// Adds the surface of `shape`, placed by X_BS, in mm. Round things get smooth normals, convex ones flat
/// normals.
/// `taper`: m, length of the drawn point of a bent wire at its start, 0 for none.
void append_shape(const snapshot::CardShape& shape, Mesh& mesh, double taper = 0);

/// Adds the part [from, to] (0..1 along it) of a wire (arc, capsule, cylinder) as a sleeve that is `grow`
/// times as thick: a marked region, drawn over the wire itself.
void append_range(const snapshot::CardShape& wire, double from, double to, double grow, Mesh& mesh);

/// A tube through `n` points (3 n values, m, in the frame of the mesh), with round ends.
/// `taper`: m, length of the drawn point at its start, 0 for none.
void append_thread(const double* points, uint32_t n, double radius, Mesh& mesh, double taper = 0);

}  // namespace swage::console
