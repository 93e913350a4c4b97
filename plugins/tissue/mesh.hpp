// SPDX-License-Identifier: Apache-2.0
//
// Displacement of a wall of finite elements at one place of its surface due to a force at another: a coarse mesh of the whole
// wall with its rim, and a fine one around each contact. Derivation, which part of its positive definiteness is proved
// and which only tested, and limits: tissue.md, level mesh.
//
// Units: m, N. Places are (x, y) on the patch laid flat, origin in its middle. Rows and columns of a compliance: n (out
// of the tissue), x, y.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "toolkit/math.hpp"

namespace swage::tissue {

using toolkit::Mat3;
using toolkit::Vec3;

enum class Underside : int { kFree, kHeld };

struct MeshSpec {
  std::array<double, 2> size{12e-3, 10e-3};  // m
  double thickness = 1e-3;                   // m
  double slit = 0;                           // m
  double young = 1e6;                        // Pa, instantaneous
  double spread = 50e-6;                     // m, as for the half space
  double skin = 0;                           // m, on top of the wall
  double skin_young = 0;                     // Pa
  Underside underside = Underside::kFree;
  int cells = 16;      // coarse cells along the longer side
  int refinement = 4;  // number of times that cells around a contact are halved
};

/// A layer of bricks.
struct Sheet {
  double thickness, young;  // m, Pa
};

/// Coarse mesh: bricks over the whole wall, its rim clamped. Even numbers of cells, the same on both sides of the
/// middle.
struct CoarseGrid {
  explicit CoarseGrid(const MeshSpec& spec);
  /// "", or one sentence: why the mesh cannot be computed with such cells.
  std::string unfit(const MeshSpec& spec) const;
  int nx, ny;                // cells
  double hx, hy;             // m
  std::vector<Sheet> sheet;  // from below
};

/// A surface node: columns from rim to rim, nx + 1 of them, with a slit nx + 2, where both edges have one; ny + 1 rows.
/// Compliance [m/N] of the coarse mesh between its surface's nodes, row by row: 3x3 blocks, rows n, x, y; node =
/// column (ny + 1) + row. [main]
std::vector<double> wall_compliance(const MeshSpec& spec, const CoarseGrid& grid);

/// A layered plate of bricks without a rim.
class Plate {
 public:
  /// Bricks of hx x hy [m], layers from below. [main]
  Plate(const std::vector<Sheet>& sheet, double hx, double hy, Underside underside);
  /// Displacement [m/N] of waves with phases (tx, ty) [rad] from node to node, not both 0, per force on each node: x,
  /// y, z; displacements along the surface lead those across it by a quarter of a wave.
  Mat3 answer(double tx, double ty) const;

 private:
  /// Stiffness between lower (0..2) and upper (3..5) nodes that are (d % 3 - 1, d / 3 - 1) apart.
  using Stencil = std::array<std::array<std::array<double, 6>, 6>, 9>;
  std::vector<Stencil> kind_;
  std::vector<size_t> layer_;  // kind of each layer, from below
  Underside underside_;
};
/// Layers of the mesh around a contact: halved `refinement` times at the surface, growing with the depth.
std::vector<Sheet> fine_sheets(const MeshSpec& spec, const CoarseGrid& grid);

/// The coarse mesh without a rim: compliance between nodes that are i columns and j rows apart, at i
/// (ny + 1) + j; without the share of long waves. [main]
std::vector<Mat3> rimless_compliance(const MeshSpec& spec, const CoarseGrid& grid);

/// The same for the mesh around a contact: mean over all places and directions, so that it moves with the
/// contact. Tabulated over the distance. [main] to build, [rt] to query.
class TouchTable {
 public:
  TouchTable() = default;
  TouchTable(const MeshSpec& spec, const CoarseGrid& grid);
  /// Compliance at (x, y) from the force.
  Mat3 at(double x, double y) const noexcept;
  double reach() const { return reach_; }  // m, beyond which it is 0

 private:
  struct Entry {
    double nn = 0, nl = 0, along = 0, across = 0;  // m/N
  };
  double reach_ = 0, scale_ = 1, per_u_ = 0;
  std::vector<Entry> entry_;  // equally spaced in r / (r + scale)
};

class Mesh {
 public:
  /// A place of the surface, and the nodes that interpolate it.
  struct Place {
    static constexpr size_t kNodes = 4;
    double x = 0, y = 0;
    int side = 0;  // of a slit: -1, 1
    std::array<uint32_t, kNodes> node{};
    std::array<double, kNodes> weight{};
  };
  struct Load {
    Place at;
    Vec3 f;  // N, along n, x, y
  };

  Mesh() = default;
  explicit Mesh(const MeshSpec& spec);  // [main]

  /// For a place beyond the rim: the nearest place on the rim.
  Place place(double x, double y) const noexcept;
  Mat3 between(const Place& p, const Place& q) const noexcept;
  /// Compliances between each pair of n places: n x n row by row, complete. The cost is one product per node near them; work
  /// space is the mesh's own.
  void responses(std::span<const Place> places, Mat3* out) noexcept;
  /// Displacement of places under loads.
  void displace(std::span<const Place> places, std::span<const Load> loads, Vec3* u) noexcept;

  size_t bytes() const { return coarse_.size() * sizeof(double); }
  double cell() const { return hx_; }  // m, of the coarse mesh

 private:
  const double* block(uint32_t a, uint32_t b) const { return coarse_.data() + 9 * (size_t{a} * nodes_ + b); }
  void take_away(const std::vector<Mat3>& rimless);
  /// Nodes of places, each once, into used_.
  void gather(std::span<const Place> places) noexcept;

  double half_slit_ = 0, width_ = 1, depth_ = 1, hx_ = 1, hy_ = 1;
  int nx_ = 2, ny_ = 2;
  uint32_t columns_ = 0, rows_ = 0;
  size_t nodes_ = 0;
  std::vector<double> coarse_;
  TouchTable touch_;
  std::vector<uint32_t> used_, loaded_, stamp_;
  uint32_t now_ = 0;
  std::vector<Mat3> column_;
  std::vector<Vec3> load_, moved_;
};

}  // namespace swage::tissue
