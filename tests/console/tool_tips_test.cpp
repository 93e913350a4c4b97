// SPDX-License-Identifier: Apache-2.0
#include "console/view3d/tool_tips.hpp"

#include <gtest/gtest.h>

#include <QVector3D>

namespace swage::console {

TEST(ToolTips, ACutKeepsOneSide) {
  Mesh mesh;
  mesh.vertex = {{{0, 0, 0}, {0, 0, 1}}, {{4, 0, 0}, {0, 0, 1}}, {{0, 2, 0}, {0, 0, 1}}};
  mesh.index = {0, 1, 2};
  const auto area = [](const Mesh& m) {
    float sum = 0;
    for (size_t i = 0; i + 2 < m.index.size(); i += 3) {
      const auto at = [&](size_t k) { const float* p = m.vertex[m.index[i + k]].p; return QVector3D(p[0], p[1], p[2]); };
      sum += 0.5F * QVector3D::crossProduct(at(1) - at(0), at(2) - at(0)).length();
    }
    return sum;
  };
  EXPECT_FLOAT_EQ(area(cut(mesh, {2, 0, 0}, {1, 0, 0})), 3) << "of 4 mm2 a quarter is beyond";
  EXPECT_FLOAT_EQ(area(cut(mesh, {2, 0, 0}, {-1, 0, 0})), 1);
  EXPECT_FLOAT_EQ(area(cut(mesh, {5, 0, 0}, {1, 0, 0})), 4);
  EXPECT_FLOAT_EQ(area(cut(mesh, {-1, 0, 0}, {1, 0, 0})), 0);
}

}  // namespace swage::console
