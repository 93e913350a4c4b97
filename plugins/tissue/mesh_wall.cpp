// SPDX-License-Identifier: Apache-2.0
//
// The coarse mesh of the whole wall, eliminated layer by layer from below until only its surface remains.
#include <algorithm>
#include <cmath>

#include "brick.hpp"
#include "elimination.hpp"
#include "mesh.hpp"

namespace swage::tissue {
namespace {

constexpr int kMostLayers = 8, kLeastLayers = 2;
// Within these limits responses are positive (tissue_mesh_test). Flatter cells of a free wall would not bend beside the
// rim; a wider contact has no waves as short as the coarse nodes resolve, whose share would then be subtracted without a replacement.
constexpr double kFlattest = 1.7;    // coarse cell over the wall's thickness
constexpr double kWidest = 1 / 6.0;  // spread of a touch over a coarse cell

/// Condition at a plane through the middle: mirror images move alike, or against each other, or there is a free edge.
enum class Middle { kEven, kOdd, kFree };

/// A quarter of the wall (or, beside a slit, half of one side): nodes from the middle planes to the clamped rim.
class Quarter {
 public:
  Quarter(const MeshSpec& spec, const CoarseGrid& grid, Middle at_x, Middle at_y)
      : nx_(static_cast<size_t>(grid.nx / 2)),
        ny_(static_cast<size_t>(grid.ny / 2)),
        at_x_(at_x),
        at_y_(at_y) {
    const size_t n = unknowns();
    Symmetric below(n);
    for (size_t layer = 0; layer < grid.sheet.size(); ++layer) {
      const bool held = layer == 0 && spec.underside == Underside::kHeld;
      const Sheet& s = grid.sheet[layer];
      Symmetric both = assembled(brick({grid.hx, grid.hy, s.thickness}, s.young), held);
      if (layer > 0)
        for (size_t i = 0; i < n; ++i)
          for (size_t j = 0; j <= i; ++j) both.row(i)[j] += below.row(i)[j];
      eliminate(both, n);
      below = rest(both, n);
    }
    for (size_t i = 0; i < n; ++i)
      if (pinned(i)) below.row(i)[i] = 1;
    compliance_ = inverse(below);
    for (size_t i = 0; i < n; ++i)
      for (size_t j = 0; j < n; ++j)
        if (pinned(i) || pinned(j)) compliance_.row(i)[j] = 0;
  }
  size_t unknowns() const { return 3 * nx_ * ny_; }
  const Symmetric& compliance() const { return compliance_; }

 private:
  static bool stopped(Middle m, bool across) {
    return m == Middle::kEven ? across : m == Middle::kOdd && !across;
  }
  bool pinned(size_t i) const {
    const size_t node = i / 3, component = i % 3;
    return (node / ny_ == 0 && stopped(at_x_, component == 0)) ||
           (node % ny_ == 0 && stopped(at_y_, component == 1));
  }
  /// Stiffness of a layer between its lower and its upper nodes; `held`: the lower nodes are fixed.
  Symmetric assembled(const BrickStiffness& K, bool held) const {
    const size_t n = unknowns();
    Symmetric m(2 * n);
    for (size_t ix = 0; ix < nx_; ++ix)
      for (size_t iy = 0; iy < ny_; ++iy)
        for (size_t a = 0; a < 24; ++a)
          for (size_t b = 0; b < 24; ++b) {
            const size_t i = unknown(ix, iy, a), j = unknown(ix, iy, b);
            if (i < j || i == kRim || j == kRim || pinned(i % n) || pinned(j % n)) continue;
            if (held && j < n) continue;
            m.row(i)[j] += K[a][b];
          }
    for (size_t i = 0; i < n; ++i)
      if (held || pinned(i)) m.row(i)[i] = 1;
    return m;
  }
  static constexpr size_t kRim = static_cast<size_t>(-1);
  size_t unknown(size_t ix, size_t iy, size_t a) const {
    const size_t corner = a / 3, x = ix + (corner & 1), y = iy + (corner >> 1 & 1);
    if (x == nx_ || y == ny_) return kRim;
    return (corner >> 2) * unknowns() + 3 * (x * ny_ + y) + a % 3;
  }

  size_t nx_, ny_;
  Middle at_x_, at_y_;
  Symmetric compliance_{0};
};

/// A node of the whole surface mapped to one of the quarter, and its mirror signs.
struct Image {
  size_t node;
  bool rim, left, near;  // at the rim; x < 0; y < 0
};
Image image(const CoarseGrid& grid, bool slit, int column, int row) {
  const int hx = grid.nx / 2, hy = grid.ny / 2;
  const int x = slit && column > hx ? column - 1 - hx : column - hx, y = row - hy;
  const bool rim = std::abs(x) == hx || std::abs(y) == hy;
  return {rim ? 0 : static_cast<size_t>(std::abs(x) * hy + std::abs(y)), rim, slit ? column <= hx : x < 0,
          y < 0};
}

/// Sign of a component (x, y, z) of the mirror image.
double sign(const Image& at, Middle at_x, Middle at_y, size_t component) {
  const bool flip_x = at.left && ((at_x == Middle::kOdd) != (component == 0));
  const bool flip_y = at.near && ((at_y == Middle::kOdd) != (component == 1));
  return flip_x != flip_y ? -1 : 1;
}

}  // namespace

CoarseGrid::CoarseGrid(const MeshSpec& spec) {
  const double h = std::max(spec.size[0], spec.size[1]) / spec.cells;
  const auto even = [h](double length) {
    return 2 * std::max(2, static_cast<int>(std::lround(0.5 * length / h)));
  };
  nx = even(spec.size[0]), ny = even(spec.size[1]);
  hx = (spec.size[0] - spec.slit) / nx, hy = spec.size[1] / ny;
  const int n = std::clamp(static_cast<int>(std::ceil(spec.thickness / h)), kLeastLayers, kMostLayers);
  sheet.assign(static_cast<size_t>(n), {spec.thickness / n, spec.young});
  if (spec.skin > 0) sheet.push_back({spec.skin, spec.skin_young});
}

std::string CoarseGrid::unfit(const MeshSpec& spec) const {
  if (spec.underside == Underside::kFree && std::max(hx, hy) > kFlattest * spec.thickness)
    return "a wall with a free underside needs cells of at most 1.7 times its thickness";
  if (spec.spread > kWidest * std::min(hx, hy))
    return "cells must be at least six times as large as the spread of a touch";
  return "";
}

std::vector<double> wall_compliance(const MeshSpec& spec, const CoarseGrid& grid) {
  const bool slit = spec.slit > 0;
  const int columns = slit ? grid.nx + 2 : grid.nx + 1, rows = grid.ny + 1;
  const size_t nodes = static_cast<size_t>(columns) * static_cast<size_t>(rows);
  std::vector<double> C(9 * nodes * nodes, 0.0);
  std::vector<Middle> ways_x{Middle::kEven, Middle::kOdd};
  if (slit) ways_x = {Middle::kFree};
  // a force is the sum of its parts of each parity; a quarter of the wall bears a quarter of each, beside a slit half
  const double share = slit ? 0.5 : 0.25;
  for (const Middle at_x : ways_x)
    for (const Middle at_y : {Middle::kEven, Middle::kOdd}) {
      const Quarter quarter(spec, grid, at_x, at_y);
      for (size_t a = 0; a < nodes; ++a) {
        const Image p = image(grid, slit, static_cast<int>(a) / rows, static_cast<int>(a) % rows);
        for (size_t b = 0; b < nodes; ++b) {
          const Image q = image(grid, slit, static_cast<int>(b) / rows, static_cast<int>(b) % rows);
          if (p.rim || q.rim || (slit && p.left != q.left)) continue;
          for (size_t i = 0; i < 3; ++i)
            for (size_t j = 0; j < 3; ++j)
              C[9 * (a * nodes + b) + 3 * ((i + 1) % 3) + (j + 1) % 3] +=
                  share * sign(p, at_x, at_y, i) * sign(q, at_x, at_y, j) *
                  quarter.compliance().row(3 * p.node + i)[3 * q.node + j];
        }
      }
    }
  return C;
}

}  // namespace swage::tissue
