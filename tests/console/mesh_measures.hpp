// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <QVector3D>

#include "console/view3d/mesh.hpp"

namespace swage::console {

inline QVector3D at(const Mesh& m, uint32_t i) {
  return {m.vertex[i].p[0], m.vertex[i].p[1], m.vertex[i].p[2]};
}

/// Area of a mesh whose faces all point upwards; `of` maps twice a face's area vector to a number.
template <class Of>
double area(const Mesh& m, Of of) {
  constexpr float kRounding = 1e-7F;  // mm2
  double sum = 0;
  for (size_t i = 0; i < m.index.size(); i += 3) {
    const QVector3D n = QVector3D::crossProduct(at(m, m.index[i + 1]) - at(m, m.index[i]),
                                                at(m, m.index[i + 2]) - at(m, m.index[i]));
    EXPECT_GE(n.z(), -kRounding) << "turned over";
    sum += 0.5 * static_cast<double>(of(n));
  }
  return sum;
}

}  // namespace swage::console
