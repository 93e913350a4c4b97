// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Qt3DCore/QBuffer>
#include <Qt3DCore/QNode>
#include <Qt3DRender/QGeometryRenderer>

#include "console/view3d/mesh.hpp"

namespace swage::console {

/// A mesh as a Qt3D geometry; its triangles may be replaced at any time.
class MeshGeometry : public Qt3DRender::QGeometryRenderer {
 public:
  explicit MeshGeometry(Qt3DCore::QNode* parent);
  void set(const Mesh& mesh);

 private:
  Qt3DCore::QBuffer *vertices_, *indices_;
  Qt3DCore::QAttribute *position_, *normal_, *index_;
};

}  // namespace swage::console
