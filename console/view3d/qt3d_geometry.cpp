// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/qt3d_geometry.hpp"

#include <Qt3DCore/QAttribute>
#include <Qt3DCore/QGeometry>
#include <cstddef>

namespace swage::console {
namespace {

template <class T>
QByteArray bytes(const std::vector<T>& v) {
  return {reinterpret_cast<const char*>(v.data()), static_cast<qsizetype>(v.size() * sizeof(T))};
}

Qt3DCore::QAttribute* add(Qt3DCore::QGeometry* geometry, Qt3DCore::QBuffer* buffer, const QString& name,
                          size_t offset) {
  auto* a = new Qt3DCore::QAttribute(geometry);
  a->setAttributeType(Qt3DCore::QAttribute::VertexAttribute);
  a->setVertexBaseType(Qt3DCore::QAttribute::Float);
  a->setVertexSize(3);
  a->setByteStride(sizeof(Vertex));
  a->setByteOffset(static_cast<uint>(offset));
  a->setBuffer(buffer);
  a->setName(name);
  geometry->addAttribute(a);
  return a;
}

}  // namespace

MeshGeometry::MeshGeometry(Qt3DCore::QNode* parent) : QGeometryRenderer(parent) {
  using Qt3DCore::QAttribute;
  auto* geometry = new Qt3DCore::QGeometry(this);
  vertices_ = new Qt3DCore::QBuffer(geometry);
  indices_ = new Qt3DCore::QBuffer(geometry);
  position_ = add(geometry, vertices_, QAttribute::defaultPositionAttributeName(), offsetof(Vertex, p));
  normal_ = add(geometry, vertices_, QAttribute::defaultNormalAttributeName(), offsetof(Vertex, n));
  index_ = new QAttribute(geometry);
  index_->setAttributeType(QAttribute::IndexAttribute);
  index_->setVertexBaseType(QAttribute::UnsignedInt);
  index_->setBuffer(indices_);
  geometry->addAttribute(index_);
  setGeometry(geometry);
  setPrimitiveType(Triangles);
}

void MeshGeometry::set(const Mesh& mesh) {
  vertices_->setData(bytes(mesh.vertex));
  indices_->setData(bytes(mesh.index));
  const auto n_vertex = static_cast<uint>(mesh.vertex.size()), n_index = static_cast<uint>(mesh.index.size());
  position_->setCount(n_vertex);
  normal_->setCount(n_vertex);
  index_->setCount(n_index);
  setVertexCount(static_cast<int>(n_index));
}

}  // namespace swage::console
