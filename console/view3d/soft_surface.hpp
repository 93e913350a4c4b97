// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What is drawn on top of a soft object's shapes: dents that displace its surface, and wounds in it. Free of Qt3D.
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
};

/// The same surface in smaller triangles near the dents: no edge is longer than `share` of its distance from the nearest dent, but
/// for those shorter than `share` of its radius. Neighbours that shared an edge still do. `X_WB`: from the mesh to the world.
Mesh refined(const Mesh& mesh, const QMatrix4x4& X_WB, const std::vector<Dent>& dents, float share = 0.4F);

/// Displacement of a place, mm.
QVector3D displacement(const std::vector<Dent>& dents, const QVector3D& p);

/// `rest` displaced, with the normals of the displaced surface. `X_WB`: from the mesh to the world, rigid.
void displace(const Mesh& rest, const QMatrix4x4& X_WB, const std::vector<Dent>& dents, Mesh& out);

/// The wounds as flat patches on the dented surface, `grow` wider than they are and `lift` above it. World, mm. Patches that
/// overlap look like one, as they are of one colour.
void append_tears(const std::vector<Tear>& tears, const std::vector<Dent>& dents, float grow, float lift,
                  Mesh& out);

}  // namespace swage::console
