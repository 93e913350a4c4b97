// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The deformed surface of a soft object: dents that displace it, and tears. Free of Qt3D.
#pragma once

#include <QMatrix4x4>
#include <QVector3D>
#include <vector>

#include "console/view3d/mesh.hpp"

namespace swage::console {

/// A point at the distance r from `p` is displaced by u / sqrt(1 + (r/radius)^2); dents add up. World frame, mm.
struct Dent {
  QVector3D p, u;
  float radius = 1;
};

/// A flat capsule in the surface. World frame, mm.
struct Tear {
  QVector3D a, b, normal;
  float radius = 0;
  uint32_t wound = 0;  // tears with the same number form one region
};

/// The same surface in smaller triangles near the dents: no edge is longer than `share` of its distance from the nearest dent, except
/// edges shorter than `share` of its radius. The mesh stays conforming. `X_WB`: from the mesh to the world.
Mesh refined(const Mesh& mesh, const QMatrix4x4& X_WB, const std::vector<Dent>& dents, float share = 0.4F);

/// Displacement of the point `p`, mm.
QVector3D displacement(const std::vector<Dent>& dents, const QVector3D& p);

/// `rest` displaced, with the normals of the displaced surface. `X_WB`: from the mesh to the world, a rigid transform.
void displace(const Mesh& rest, const QMatrix4x4& X_WB, const std::vector<Dent>& dents, Mesh& out);

}  // namespace swage::console
