// SPDX-License-Identifier: Apache-2.0
//
// A surface over a grid: heights at the vertices, two triangles a cell. Header-only, allocation-free.
//
// Frame H: vertex (i, j) is at (i dx, j dy, z), i < nx along x, j < ny along y; outside is +z. Cell (i, j) has its
// corner of least x and y at vertex (i, j) and is cut from there to the opposite corner. Triangle 2 (j nx + i) is the
// half below that diagonal (towards +x), 2 (j nx + i) + 1 the half above it. Units: m.
#pragma once

#include <algorithm>
#include <cstdint>

#include "toolkit/math.hpp"

namespace swage::toolkit {

/// A view of heights that the caller owns.
struct HeightField {
  uint32_t nx = 0, ny = 0;    // vertices
  double dx = 0, dy = 0;      // m, sides of a cell
  const double* z = nullptr;  // m, nx ny heights, row by row along x

  uint32_t vertices() const { return nx * ny; }
  double height(uint32_t i, uint32_t j) const { return z[size_t{j} * nx + i]; }
  Vec3 vertex(uint32_t i, uint32_t j) const { return {i * dx, j * dy, height(i, j)}; }
  double width() const { return (nx - 1) * dx; }
  double depth() const { return (ny - 1) * dy; }

  /// Corners of a triangle, counter-clockwise from above.
  struct Corners {
    Vec3 a, b, c;
    /// Normal, not of unit length; its z is positive.
    Vec3 normal() const { return (b - a).cross(c - a); }
  };
  Corners corners(uint32_t triangle) const {
    const uint32_t i = triangle / 2 % nx, j = triangle / 2 / nx;
    if (triangle % 2 == 0) return {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)};
    return {vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)};
  }
  /// The triangle over (x, y); beyond the border that of the nearest cell.
  uint32_t triangle_at(double x, double y) const {
    const auto cell = [](double t, uint32_t n) {
      return static_cast<uint32_t>(std::clamp(t, 0.0, static_cast<double>(n) - 2));
    };
    const uint32_t i = cell(x / dx, nx), j = cell(y / dy, ny);
    return 2 * (j * nx + i) + (y / dy - j > x / dx - i ? 1 : 0);
  }
  /// Height of the surface over (x, y); beyond the border that of the nearest triangle's plane.
  double height_at(double x, double y) const {
    const Corners t = corners(triangle_at(x, y));
    const Vec3 n = t.normal();
    return t.a.z() - (n.x() * (x - t.a.x()) + n.y() * (y - t.a.y())) / n.z();
  }
};

}  // namespace swage::toolkit
