// SPDX-License-Identifier: Apache-2.0
#include "wall.hpp"

#include <algorithm>
#include <cmath>
#include <locale>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "toolkit/read_file.hpp"

namespace swage::tissue {
namespace {

constexpr uint32_t kMostNodes =
    64;  // of a table along one side: more would give more convex pieces than a step can test
constexpr int kStrips = 24;  // convex strips that approximate a curved surface
constexpr uint32_t kGridCells = 128;  // of a smooth surface along one side: the most that a height field has
constexpr double kBand = 0.3e-3;  // m, along the rim of a smooth surface: pieces, whose sides stop what comes from beside the wall
constexpr int kFeet = 3;  // iterations for the nearest place on a curved surface; exact on planes after the first

}  // namespace

HeightTable read_heights(const std::string& path) {
  std::string text, why;
  if (!toolkit::read_file(path, toolkit::kMostFileBytes, text, why))
    throw std::runtime_error("cannot read the table of heights \"" + path + "\": " + why);
  std::istringstream file(text);
  file.imbue(std::locale::classic());  // the decimal point is a point in every language
  HeightTable table;
  if (!(file >> table.nx >> table.ny) || table.nx < 2 || table.ny < 2 || table.nx > kMostNodes ||
      table.ny > kMostNodes)
    throw std::runtime_error("a table of heights begins with two whole numbers from 2 to 64: nx ny.");
  table.z.resize(size_t{table.nx} * table.ny);
  for (double& z : table.z)
    if (!(file >> z) || !std::isfinite(z))
      throw std::runtime_error(
          "a table of heights needs nx times ny numbers in metres after its first line.");
  return table;
}

double Wall::interpolated(double x, double y) const noexcept {
  const HeightTable& t = shape_.table;
  const auto along = [](double at, double size, uint32_t n, uint32_t& i) {
    const double u = std::clamp(at / size + 0.5, 0.0, 1.0) * (n - 1);
    i = std::min(static_cast<uint32_t>(u), n - 2);
    return u - i;
  };
  uint32_t i = 0, j = 0;
  const double u = along(x, shape_.size[0], t.nx, i), v = along(y, shape_.size[1], t.ny, j);
  const double* row = t.z.data() + size_t{j} * t.nx + i;
  const double* next = row + t.nx;
  return (1 - v) * ((1 - u) * row[0] + u * row[1]) + v * ((1 - u) * next[0] + u * next[1]);
}

double Wall::height(double x, double y) const noexcept {
  switch (shape_.form) {
    case Form::kFlat:
      return 0;
    case Form::kLeftSlope:
      return -x * std::tan(shape_.slope);
    case Form::kRightSlope:
      return x * std::tan(shape_.slope);
    case Form::kWaves:
      return 0.5 * shape_.wave_height * (std::cos(2 * std::numbers::pi * x / shape_.wave_length) - 1);
    case Form::kCylinder: {
      const double r = shape_.radius, c = std::clamp(x, -0.999 * r, 0.999 * r);
      return std::sqrt(r * r - c * c) - r;
    }
    case Form::kTable:
      return interpolated(x, y);
  }
  return 0;
}

Vec3 Wall::normal(double x, double y) const noexcept {
  if (shape_.form == Form::kFlat) return Vec3::UnitZ();
  const double h = 1e-4 * shape_.size[0];
  const double dx = (height(x + h, y) - height(x - h, y)) / (2 * h);
  const double dy = shape_.form == Form::kTable ? (height(x, y + h) - height(x, y - h)) / (2 * h) : 0;
  return Vec3(-dx, -dy, 1).normalized();
}

double Wall::laid_flat(double x) const noexcept {
  switch (shape_.form) {
    case Form::kLeftSlope:
    case Form::kRightSlope:
      return x / std::cos(shape_.slope);
    case Form::kCylinder:
      return shape_.radius * std::asin(std::clamp(x / shape_.radius, -1.0, 1.0));
    default:
      return x;
  }
}

WallPlace Wall::locate(const Vec3& p_O) const noexcept {
  WallPlace place;
  double x = p_O.x(), y = p_O.y();
  if (shape_.form == Form::kCylinder) {
    const Vec3 radial(p_O.x(), 0, p_O.z() + shape_.radius);
    const double far = radial.norm();
    place.normal = far > 0 ? Vec3(radial / far) : Vec3::UnitZ();
    place.foot = p_O + (shape_.radius - far) * place.normal;
    place.depth = shape_.radius - far;
  } else {
    for (int i = 0; i < kFeet; ++i) {
      place.normal = normal(x, y);
      place.depth = (Vec3(x, y, height(x, y)) - p_O).dot(place.normal);
      place.foot = p_O + place.depth * place.normal;
      x = place.foot.x(), y = place.foot.y();
      if (shape_.form <= Form::kRightSlope) break;
    }
  }
  const double rim_x = 0.5 * shape_.size[0] - std::abs(place.foot.x());
  const double rim_y = 0.5 * shape_.size[1] - std::abs(place.foot.y());
  place.edge = std::min(rim_x, rim_y);
  if (shape_.slit > 0) place.edge = std::min(place.edge, std::abs(place.foot.x()) - 0.5 * shape_.slit);
  return place;
}

/// Borders of the pieces, along x.
std::vector<double> Wall::stations() const {
  const bool bent = shape_.form > Form::kRightSlope;
  const int n = shape_.form == Form::kTable ? static_cast<int>(shape_.table.nx) - 1 : bent ? kStrips : 1;
  std::vector<double> x;
  for (int i = 0; i <= n; ++i) x.push_back(shape_.size[0] * (static_cast<double>(i) / n - 0.5));
  if (shape_.slit <= 0) return x;
  const double half = 0.5 * shape_.slit;
  std::erase_if(x, [half](double at) { return std::abs(at) < 2 * half; });
  x.insert(std::upper_bound(x.begin(), x.end(), 0.0), {-half, half});
  return x;
}

/// Borders of the pieces, along y.
std::vector<double> Wall::rows() const {
  const int n = shape_.form == Form::kTable ? static_cast<int>(shape_.table.ny) - 1 : 1;
  std::vector<double> y;
  for (int j = 0; j <= n; ++j) y.push_back(shape_.size[1] * (static_cast<double>(j) / n - 0.5));
  return y;
}

/// The piece over a rectangle, from `from` to `depth` below the surface. Its upper face is planar: tangent in the middle.
Wall::Piece Wall::piece(double x0, double x1, double y0, double y1, double from, double depth) const {
  const double at[4][2] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  const double mx = 0.5 * (x0 + x1), my = 0.5 * (y0 + y1);
  const Vec3 n = normal(mx, my);
  const double mz = 0.25 * (height(at[0][0], y0) + height(at[1][0], y0) + height(at[2][0], y1) + height(at[3][0], y1));
  Piece piece;
  for (size_t k = 0; k < 4; ++k) {
    const double z = mz - (n.x() * (at[k][0] - mx) + n.y() * (at[k][1] - my)) / n.z();
    piece[k] = Vec3(at[k][0], at[k][1], z);
    piece[4 + k] = piece[k] - depth * n;
    if (from > 0) piece[k] -= from * n;
  }
  return piece;
}

std::vector<Wall::Piece> Wall::pieces(double depth) const {
  const std::vector<double> x = stations(), y = rows();
  std::vector<Piece> pieces;
  for (size_t i = 0; i + 1 < x.size(); ++i) {
    if (shape_.slit > 0 && x[i] < 0 && x[i + 1] > 0) continue;
    for (size_t j = 0; j + 1 < y.size(); ++j) pieces.push_back(piece(x[i], x[i + 1], y[j], y[j + 1], 0, depth));
  }
  return pieces;
}

Wall::Grid Wall::grid(double depth, double floor) const {
  Grid grid;
  const double band = std::min(kBand, 0.1 * std::min(shape_.size[0], shape_.size[1]));
  const auto cells = [&](uint32_t nodes) { return shape_.form == Form::kTable ? std::min(kGridCells, 4 * (nodes - 1)) : kGridCells; };
  grid.nx = cells(shape_.table.nx) + 1;
  grid.ny = shape_.form == Form::kTable ? cells(shape_.table.ny) + 1 : 2;  // the other forms are straight along y
  grid.x0 = band - 0.5 * shape_.size[0], grid.y0 = band - 0.5 * shape_.size[1];
  grid.dx = -2 * grid.x0 / (grid.nx - 1), grid.dy = -2 * grid.y0 / (grid.ny - 1);
  for (uint32_t j = 0; j < grid.ny; ++j)
    for (uint32_t i = 0; i < grid.nx; ++i) grid.height.push_back(height(grid.x0 + i * grid.dx, grid.y0 + j * grid.dy));
  grid.below = depth - floor;

  // borders of the pieces, with those of the band and none close to them
  const auto banded = [band](std::vector<double> at) {
    const double rim = at.back(), inner = rim - band;
    std::erase_if(at, [&](double x) { return std::abs(x) > inner - 0.5 * band && std::abs(x) < rim; });
    at.insert(at.begin() + 1, -inner);
    at.insert(at.end() - 1, inner);
    return at;
  };
  const std::vector<double> x = banded(stations()), y = banded(rows());
  for (size_t i = 0; i + 1 < x.size(); ++i)
    for (size_t j = 0; j + 1 < y.size(); ++j) {
      const bool in_band = i == 0 || j == 0 || i + 2 == x.size() || j + 2 == y.size();
      grid.frame.push_back(piece(x[i], x[i + 1], y[j], y[j + 1], in_band ? 0 : depth - floor, depth));
    }
  return grid;
}

}  // namespace swage::tissue
