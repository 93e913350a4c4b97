// SPDX-License-Identifier: Apache-2.0
//
// The fine mesh around a contact. Far from rims it is the same wherever the contact is, and for each wave a layer of
// bricks has six unknowns: no larger system of equations is solved, however fine the mesh is.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "brick.hpp"
#include "mesh.hpp"

namespace swage::tissue {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kReach = 12;  // coarse cells: beyond, the coarse mesh is accurate by itself
constexpr double kLongest =
    2.5;  // coarse cells: waves longer than 2 pi times this are left to the coarse mesh, which has the rim
constexpr double kSteepest = 14;   // in exp(-k spread): shorter waves carry less than 1e-6 of a contact's force
constexpr int kDirections = 4;     // directions of waves in a quarter turn; the response is even about its middle
constexpr double kPerReach = 0.4;  // rad, phase between two wave numbers at the reach
constexpr int kPeriod =
    64;  // coarse cells, period of the mesh without a rim: more than five reaches
constexpr size_t kEntries = 320;
constexpr size_t kWaves = 240;  // number of wave numbers with a computed response, from the longest wave to the shortest
constexpr double kGrow = 1.5;   // the last layer may be thicker than specified by this factor

/// Share of a wave that comes from the meshes without a rim; the rest, of long waves, is left to the coarse mesh.
double short_share(double k, double cell) {
  const double x = k * kLongest * cell, x4 = x * x * x * x;
  return x4 / (1 + x4);
}

/// Share of a wave, t radians from node to node, that the fine nodes interpolate. Quadratic B-splines of nodes
/// that were sharpened by 1 - (second difference) / 8, which makes them exact to third order.
double carried(double t) {
  const double s = std::abs(t) < 1e-9 ? 1 : std::sin(0.5 * t) / (0.5 * t);
  return s * s * s * (1 + 0.25 * (1 - std::cos(t)));
}

}  // namespace

Plate::Plate(const std::vector<Sheet>& sheet, double hx, double hy, Underside underside)
    : underside_(underside) {
  const Sheet* before = nullptr;
  for (const Sheet& s : sheet) {
    const bool same = before && before->thickness == s.thickness && before->young == s.young;
    before = &s;
    if (same) {
      layer_.push_back(layer_.back());
      continue;
    }
    const BrickStiffness K = brick({hx, hy, s.thickness}, s.young);
    Stencil stencil{};
    for (size_t a = 0; a < 8; ++a)
      for (size_t b = 0; b < 8; ++b) {
        const size_t d = (b & 1) + 1 - (a & 1) + 3 * ((b >> 1 & 1) + 1 - (a >> 1 & 1));
        for (size_t i = 0; i < 3; ++i)
          for (size_t j = 0; j < 3; ++j)
            stencil[d][3 * (a >> 2) + i][3 * (b >> 2) + j] += K[3 * a + i][3 * b + j];
      }
    layer_.push_back(kind_.size());
    kind_.push_back(stencil);
  }
}

Mat3 Plate::answer(double tx, double ty) const {
  // displacements along the surface lead those across it by a quarter of a wave: then all coefficients are real
  std::vector<Eigen::Matrix<double, 6, 6>> kind(kind_.size());
  for (size_t k = 0; k < kind_.size(); ++k) {
    kind[k].setZero();
    for (size_t d = 0; d < 9; ++d) {
      const double phase = tx * (static_cast<double>(d % 3) - 1) + ty * (static_cast<double>(d / 3) - 1);
      const double c = std::cos(phase), s = std::sin(phase);
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) {
          const bool up_i = i % 3 == 2, up_j = j % 3 == 2;
          kind[k](i, j) += (up_i == up_j ? c
                            : up_j       ? s
                                         : -s) *
                           kind_[k][d][static_cast<size_t>(i)][static_cast<size_t>(j)];
        }
    }
  }
  Mat3 S = Mat3::Zero();  // stiffness of the layers below
  for (size_t k = 0; k < layer_.size(); ++k) {
    const auto& A = kind[layer_[k]];
    const Mat3 upper = A.bottomRightCorner<3, 3>(), across = A.topRightCorner<3, 3>();
    if (k == 0 && underside_ == Underside::kHeld) {
      S = upper;
      continue;
    }
    const Mat3 lower = S + A.topLeftCorner<3, 3>();
    S = upper - across.transpose() * lower.inverse() * across;
    S = 0.5 * (S + S.transpose()).eval();
  }
  return S.inverse();
}

std::vector<Sheet> fine_sheets(const MeshSpec& spec, const CoarseGrid& grid) {
  if (spec.refinement == 0) return grid.sheet;
  const double h = std::min(grid.hx, grid.hy) * std::ldexp(1, -spec.refinement),
               grow = std::ldexp(1, 1 - spec.refinement);
  std::vector<Sheet> sheet;  // from above
  if (spec.skin > 0) {
    const int n = std::max(1, static_cast<int>(std::ceil(std::min(spec.skin / h, 8.0))));
    sheet.assign(static_cast<size_t>(n), {spec.skin / n, spec.skin_young});
  }
  for (double z = 0; z < spec.thickness;) {
    const double next = std::max(h, grow * (z + spec.skin)), left = spec.thickness - z;
    sheet.push_back({left < kGrow * next ? left : next, spec.young});
    z = left < kGrow * next ? spec.thickness : z + next;
  }
  std::reverse(sheet.begin(), sheet.end());
  return sheet;
}

namespace {

/// Responses of a plate to waves of length 2 pi / k, mean over their directions, times k; as interpolated by the nodes.
struct Waves {
  double nn = 0, nl = 0, ll = 0, tt = 0;  // m2/N; n: out of the wall, l: along the wave, t: across it

  Waves() = default;
  Waves(const Plate& plate, double hx, double hy, double k) {
    for (int m = 0; m < kDirections; ++m) {
      const double angle = 0.5 * kPi * (m + 0.5) / kDirections, c = std::cos(angle), s = std::sin(angle);
      const double tx = k * c * hx, ty = k * s * hy;
      if (std::max(tx, ty) > kPi) continue;  // shorter than two cells
      const double share = carried(tx) * carried(ty);
      const Mat3 u = k * share * share * hx * hy / kDirections * plate.answer(tx, ty);
      nn += u(2, 2), nl += c * u(2, 0) + s * u(2, 1);
      ll += c * c * u(0, 0) + 2 * c * s * u(0, 1) + s * s * u(1, 1);
      tt += s * s * u(0, 0) - 2 * c * s * u(0, 1) + c * c * u(1, 1);
    }
  }
  /// Linear interpolation to `to` at `share`, times a weight.
  Waves towards(const Waves& to, double share, double weight) const {
    Waves out;
    out.nn = weight * (nn + share * (to.nn - nn)), out.nl = weight * (nl + share * (to.nl - nl));
    out.ll = weight * (ll + share * (to.ll - ll)), out.tt = weight * (tt + share * (to.tt - tt));
    return out;
  }
};

/// Simpson's weight of sample i of n, times 3 over the step; the first sample is 0 here.
double simpson(int i, int n) { return i == n ? 1 : i % 2 == 1 ? 4 : 2; }

}  // namespace

TouchTable::TouchTable(const MeshSpec& spec, const CoarseGrid& grid) {
  const double e = 2 * spec.spread / kPi, halved = std::ldexp(1, -spec.refinement);
  const double hx = halved * grid.hx, hy = halved * grid.hy, cell = std::max(grid.hx, grid.hy);
  const Plate plate(fine_sheets(spec, grid), hx, hy, spec.underside);
  reach_ = kReach * cell, scale_ = std::max(e, halved * cell);
  per_u_ = (kEntries - 1) * (reach_ + scale_) / reach_;

  // responses at wave numbers in geometric steps; linear interpolation keeps positive responses positive
  const double steepest = std::min(kSteepest / e, std::numbers::sqrt2 * kPi / std::min(hx, hy));
  const int n = 2 * static_cast<int>(std::ceil(0.5 * steepest * reach_ / kPerReach));
  const double dk = steepest / n, ratio = std::exp(std::log(static_cast<double>(n)) / (kWaves - 1));
  std::vector<double> at_k{dk};
  std::vector<Waves> answer{Waves(plate, hx, hy, dk)};
  while (at_k.size() < kWaves) {
    at_k.push_back(at_k.size() + 1 == kWaves ? steepest : at_k.back() * ratio);
    answer.push_back(Waves(plate, hx, hy, at_k.back()));
  }

  entry_.resize(kEntries);
  size_t before = 0;
  for (int i = 1; i <= n; ++i) {
    const double k = i * dk;
    while (before + 2 < kWaves && at_k[before + 1] < k) ++before;
    const Waves &a = answer[before], &b = answer[before + 1];
    const double t = std::clamp((k - at_k[before]) / (at_k[before + 1] - at_k[before]), 0.0, 1.0);
    // Hankel transform
    const double weight = simpson(i, n) * dk / 3 / (2 * kPi) * short_share(k, cell) * std::exp(-k * e);
    const Waves wave = a.towards(b, t, weight);
    for (size_t j = 0; j < kEntries; ++j) {
      const double u = static_cast<double>(j) / per_u_, x = k * scale_ * u / (1 - u);
      const double j0 = ::j0(x), j1 = ::j1(x), ring = x > 1e-6 ? j1 / x : 0.5;
      Entry& at = entry_[j];
      at.nn += wave.nn * j0;
      at.nl -= wave.nl * j1;
      at.along += wave.ll * (j0 - ring) + wave.tt * ring;
      at.across += wave.ll * ring + wave.tt * (j0 - ring);
    }
  }
}

std::vector<Mat3> rimless_compliance(const MeshSpec& spec, const CoarseGrid& grid) {
  const Plate plate(grid.sheet, grid.hx, grid.hy, spec.underside);
  const double cell = std::max(grid.hx, grid.hy);
  const auto columns = static_cast<size_t>(grid.nx + 1), rows = static_cast<size_t>(grid.ny + 1);
  std::array<double, kPeriod> cosine, sine;
  for (size_t i = 0; i < kPeriod; ++i)
    cosine[i] = std::cos(2 * kPi * static_cast<double>(i) / kPeriod),
    sine[i] = std::sin(2 * kPi * static_cast<double>(i) / kPeriod);
  std::vector<Mat3> C(columns * rows, Mat3::Zero());
  for (size_t a = 0; a <= kPeriod / 2; ++a)
    for (size_t b = a == 0 ? 1 : 0; b <= kPeriod / 2; ++b) {
      const double tx = 2 * kPi * static_cast<double>(a) / kPeriod,
                   ty = 2 * kPi * static_cast<double>(b) / kPeriod;
      const double kx = tx / grid.hx, ky = ty / grid.hy;
      const double twice =
          (a % (kPeriod / 2) ? 2 : 1) * (b % (kPeriod / 2) ? 2 : 1);  // and its mirror images
      const double k = std::sqrt(kx * kx + ky * ky);
      const Mat3 u = twice / (kPeriod * kPeriod) * short_share(k, cell) * plate.answer(tx, ty);
      for (size_t i = 0; i < columns; ++i)
        for (size_t j = 0; j < rows; ++j) {
          const double cx = cosine[a * i % kPeriod], sx = sine[a * i % kPeriod];
          const double cy = cosine[b * j % kPeriod], sy = sine[b * j % kPeriod];
          Mat3& at = C[i * rows + j];
          at(0, 0) += u(2, 2) * cx * cy, at(1, 1) += u(0, 0) * cx * cy, at(2, 2) += u(1, 1) * cx * cy;
          at(1, 2) -= u(0, 1) * sx * sy, at(2, 1) -= u(0, 1) * sx * sy;
          at(1, 0) -= u(0, 2) * sx * cy, at(0, 1) += u(0, 2) * sx * cy;
          at(2, 0) -= u(1, 2) * cx * sy, at(0, 2) += u(1, 2) * cx * sy;
        }
    }
  for (size_t i = 0; i < columns; ++i)
    for (size_t j = 0; j < rows; ++j)
      if (!(std::hypot(static_cast<double>(i) * grid.hx, static_cast<double>(j) * grid.hy) < kReach * cell))
        C[i * rows + j].setZero();
  return C;
}

Mat3 TouchTable::at(double x, double y) const noexcept {
  const double r = std::sqrt(x * x + y * y);
  if (!(r < reach_)) return Mat3::Zero();
  const double u = r / (r + scale_) * per_u_;
  const size_t i = std::min(static_cast<size_t>(u), kEntries - 2);
  const double t = u - static_cast<double>(i);
  const Entry &a = entry_[i], &b = entry_[i + 1];
  const double across = a.across + t * (b.across - a.across), nl = a.nl + t * (b.nl - a.nl);
  const double more = a.along + t * (b.along - a.along) - across;
  const double cx = r > 0 ? x / r : 0, cy = r > 0 ? y / r : 0;
  Mat3 C;
  C(0, 0) = a.nn + t * (b.nn - a.nn);
  C(1, 0) = cx * nl, C(2, 0) = cy * nl;
  C(0, 1) = -C(1, 0), C(0, 2) = -C(2, 0);
  C(1, 1) = across + more * cx * cx, C(2, 2) = across + more * cy * cy;
  C(1, 2) = C(2, 1) = more * cx * cy;
  return C;
}

}  // namespace swage::tissue
