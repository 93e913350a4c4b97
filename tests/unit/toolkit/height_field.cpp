// SPDX-License-Identifier: Apache-2.0
#include "toolkit/height_field.hpp"

#include <gtest/gtest.h>

namespace swage::toolkit {
namespace {

struct Hill {
  double z[12] = {0, 1, 0, 2, 1, 3, 1, 0, 0, 1, 2, 1};
  HeightField field{4, 3, 0.5, 2, z};
};

TEST(HeightField, VerticesStandOnTheGrid) {
  const Hill hill;
  EXPECT_EQ(hill.field.vertex(3, 1), Vec3(1.5, 2, 0));
  EXPECT_EQ(hill.field.vertices(), 12u);
  EXPECT_EQ(hill.field.width(), 1.5);
  EXPECT_EQ(hill.field.depth(), 4);
}

TEST(HeightField, TrianglesShareTheDiagonalAndLookUp) {
  const Hill hill;
  const auto lower = hill.field.corners(0), upper = hill.field.corners(1);
  EXPECT_EQ(lower.a, upper.a);
  EXPECT_EQ(lower.c, upper.b);
  for (uint32_t j = 0; j < 2; ++j)
    for (uint32_t i = 0; i < 3; ++i)
      for (uint32_t half = 0; half < 2; ++half)
        EXPECT_DOUBLE_EQ(hill.field.corners(2 * (4 * j + i) + half).normal().z(), 1);  // dx dy
}

TEST(HeightField, TheHeightBetweenIsLinearOnEachTriangle) {
  const Hill hill;
  for (uint32_t j = 0; j < 3; ++j)
    for (uint32_t i = 0; i < 4; ++i)
      EXPECT_NEAR(hill.field.height_at(0.5 * i, 2.0 * j), hill.z[4 * j + i], 1e-14);
  // the middle of the diagonal, and of the halves
  EXPECT_NEAR(hill.field.height_at(0.25, 1), 0.5 * (0 + 3), 1e-14);
  EXPECT_EQ(hill.field.triangle_at(0.3, 0.5), 0u);
  EXPECT_EQ(hill.field.triangle_at(0.1, 1.5), 1u);
  // beyond the border, a triangle of the nearest cell
  EXPECT_EQ(hill.field.triangle_at(-5, 100), 2u * 4 + 1);
  EXPECT_EQ(hill.field.triangle_at(100, -5), 2u * 2);
}

}  // namespace
}  // namespace swage::toolkit
