// SPDX-License-Identifier: Apache-2.0
//
// The shape of a patch of wall in the object's frame O: an entry surface z = height(x, y), a far surface one
// thickness below, a rim, a slit; and the convex pieces that represent it in contact detection.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "toolkit/math.hpp"

namespace swage::tissue {

using toolkit::Vec3;

enum class Form : int { kFlat, kLeftSlope, kRightSlope, kWaves, kCylinder, kTable };

/// Numbers on a regular grid over the patch; row by row, x rising in a row.
struct HeightTable {
  uint32_t nx = 0, ny = 0;
  std::vector<double> z;  // m
};
/// Reads a table: "nx ny", then ny rows of nx numbers [m]. Throws std::runtime_error with one sentence. [main]
HeightTable read_heights(const std::string& path);

struct WallShape {
  Form form = Form::kFlat;
  std::array<double, 2> size{12e-3, 10e-3};  // m, over x and y
  double thickness = 1e-3;                   // m
  double slope = 0;                          // rad, kLeftSlope falls with x, kRightSlope rises
  double wave_height = 0, wave_length = 1;   // m
  double radius = 1;                         // m, of the cylinder
  double slit = 0;                           // m, gap along y through x = 0
  HeightTable table;
};

/// Position of a point relative to the wall.
struct WallPlace {
  double depth = 0;             // m below the entry surface
  double edge = 0;              // m inside rim and slit
  Vec3 foot = Vec3::Zero();     // nearest place of the entry surface, in O
  Vec3 normal = Vec3::UnitZ();  // there, unit, out of the tissue
};

class Wall {
 public:
  Wall() = default;
  explicit Wall(WallShape shape) : shape_(std::move(shape)) {}

  const WallShape& shape() const { return shape_; }
  double height(double x, double y) const noexcept;  // m
  Vec3 normal(double x, double y) const noexcept;    // unit
  double laid_flat(double x) const noexcept;  // m along the surface from x = 0; of waves and tables x itself
  WallPlace locate(const Vec3& p_O) const noexcept;  // [rt]

  /// One convex piece: eight corners, the upper four first, each counter-clockwise seen from above.
  using Piece = std::array<Vec3, 8>;
  /// Pieces from the entry surface down to `depth` below it. [main]
  std::vector<Piece> pieces(double depth) const;

  /// A curved surface as wires touch it smoothly: a grid over all but a band along the rim, and pieces for the band and for a floor.
  struct Grid {
    uint32_t nx = 0, ny = 0;     // vertices
    double x0 = 0, y0 = 0;       // m, first vertex
    double dx = 0, dy = 0;       // m, sides of a cell
    std::vector<double> height;  // m, row by row
    double below = 0;            // m, from the grid down to the floor
    std::vector<Piece> frame;    // band and floor, down to `depth`
  };
  /// `floor`: thickness of the floor, less than `depth`. [main]
  Grid grid(double depth, double floor) const;

 private:
  std::vector<double> stations() const;
  std::vector<double> rows() const;
  Piece piece(double x0, double x1, double y0, double y1, double from, double depth) const;
  double interpolated(double x, double y) const noexcept;

  WallShape shape_;
};

}  // namespace swage::tissue
