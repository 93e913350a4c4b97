// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What becomes of a soft object's surface: dents that displace it, and places where it is torn. Free of Qt3D.
#pragma once

#include <QMatrix4x4>
#include <QVector3D>
#include <vector>

#include "console/view3d/mesh.hpp"

namespace swage::console {

/// A place of the surface at a distance r from `p` is displaced by u / sqrt(1 + (r/radius)^2); dents add up. World, mm.
struct Dent {
  QVector3D p, u;
  float radius = 1;
};

/// A flat capsule in the surface. World, mm.
struct Tear {
  QVector3D a, b, normal;
  float radius = 0;
  uint32_t wound = 0;  // those of one wound are one region
};

/// The same surface in smaller triangles near the dents: no edge is longer than `share` of its distance from the nearest dent, but
/// for those shorter than `share` of its radius. Neighbours that shared an edge still do. `X_WB`: from the mesh to the world.
Mesh refined(const Mesh& mesh, const QMatrix4x4& X_WB, const std::vector<Dent>& dents, float share = 0.4F);

/// Displacement of a place, mm.
QVector3D displacement(const std::vector<Dent>& dents, const QVector3D& p);

/// `rest` displaced, with the normals of the displaced surface. `X_WB`: from the mesh to the world, rigid.
void displace(const Mesh& rest, const QMatrix4x4& X_WB, const std::vector<Dent>& dents, Mesh& out);

}  // namespace swage::console
