// SPDX-License-Identifier: Apache-2.0
#include "mesh.hpp"

#include <algorithm>
#include <cmath>

namespace swage::tissue {
namespace {

/// The interval of the nodes 0..n in which a place lies, and its position in it, 0..1.
struct Between {
  int node;
  double along;
};
Between between_nodes(double u, int n) {
  const double at = std::clamp(u, 0.0, static_cast<double>(n));
  const int i = std::min(static_cast<int>(at), n - 1);
  return {i, at - i};
}

}  // namespace

Mesh::Mesh(const MeshSpec& spec) {
  const CoarseGrid grid(spec);
  half_slit_ = 0.5 * spec.slit, width_ = spec.size[0], depth_ = spec.size[1];
  nx_ = grid.nx, ny_ = grid.ny, hx_ = grid.hx, hy_ = grid.hy;
  rows_ = static_cast<uint32_t>(ny_ + 1);
  columns_ = static_cast<uint32_t>(half_slit_ > 0 ? nx_ + 2 : nx_ + 1);
  nodes_ = size_t{columns_} * rows_;
  coarse_ = wall_compliance(spec, grid);
  touch_ = TouchTable(spec, grid);
  take_away(rimless_compliance(spec, grid));
  used_.reserve(nodes_), loaded_.reserve(nodes_);
  stamp_.assign(nodes_, 0);
  column_.resize(nodes_), load_.resize(nodes_), moved_.resize(nodes_);
}

/// Subtracts from the coarse mesh the part that the mesh around a contact replaces.
void Mesh::take_away(const std::vector<Mat3>& rimless) {
  const bool slit = half_slit_ > 0;
  const uint32_t half = columns_ / 2;
  for (uint32_t a = 0; a < nodes_; ++a)
    for (uint32_t b = 0; b < nodes_; ++b) {
      const uint32_t ca = a / rows_, cb = b / rows_, ra = a % rows_, rb = b % rows_;
      if (slit && (ca < half) != (cb < half)) continue;
      const Mat3& C = rimless[(ca > cb ? ca - cb : cb - ca) * rows_ + (ra > rb ? ra - rb : rb - ra)];
      const double sx = ca < cb ? -1 : 1, sy = ra < rb ? -1 : 1;
      const double sign[9] = {1, sx, sy, sx, 1, sx * sy, sy, sx * sy, 1};
      double* const to = coarse_.data() + 9 * (size_t{a} * nodes_ + b);
      for (int k = 0; k < 9; ++k) to[k] -= sign[k] * C(k / 3, k % 3);
    }
}

Mesh::Place Mesh::place(double beyond_x, double beyond_y) const noexcept {
  Place p;
  const double x = p.x = std::clamp(beyond_x, -0.5 * width_, 0.5 * width_);
  const double y = p.y = std::clamp(beyond_y, -0.5 * depth_, 0.5 * depth_);
  uint32_t column[2];
  double along = 0;
  if (half_slit_ > 0) {
    const int half = nx_ / 2;
    p.side = x < 0 ? -1 : 1;
    const Between at = between_nodes((std::abs(x) - half_slit_) / hx_, half);  // from the slit's edge to the rim
    along = at.along;
    for (int k = 0; k < 2; ++k)
      column[k] = static_cast<uint32_t>(p.side > 0 ? half + 1 + at.node + k : half - at.node - k);
  } else {
    const Between at = between_nodes(x / hx_ + 0.5 * nx_, nx_);
    along = at.along;
    for (int k = 0; k < 2; ++k) column[k] = static_cast<uint32_t>(at.node + k);
  }
  const Between across = between_nodes(y / hy_ + 0.5 * ny_, ny_);
  for (uint32_t i = 0; i < 2; ++i)
    for (uint32_t j = 0; j < 2; ++j) {
      p.node[2 * i + j] = column[i] * rows_ + static_cast<uint32_t>(across.node) + j;
      p.weight[2 * i + j] = (i ? along : 1 - along) * (j ? across.along : 1 - across.along);
    }
  return p;
}

Mat3 Mesh::between(const Place& p, const Place& q) const noexcept {
  Mat3 C = p.side == q.side ? touch_.at(p.x - q.x, p.y - q.y) : Mat3::Zero();
  for (size_t a = 0; a < Place::kNodes; ++a)
    for (size_t b = 0; b < Place::kNodes; ++b) {
      const double w = p.weight[a] * q.weight[b];
      const double* const B = block(p.node[a], q.node[b]);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) C(i, j) += w * B[3 * i + j];
    }
  return C;
}

void Mesh::gather(std::span<const Place> places) noexcept {
  used_.clear();
  ++now_;
  for (const Place& p : places)
    for (size_t k = 0; k < Place::kNodes; ++k) {
      if (stamp_[p.node[k]] == now_) continue;
      stamp_[p.node[k]] = now_;
      used_.push_back(p.node[k]);
    }
}

void Mesh::responses(std::span<const Place> places, Mat3* out) noexcept {
  const size_t n = places.size();
  gather(places);
  for (size_t j = 0; j < n; ++j) {
    const Place& q = places[j];
    for (const uint32_t a : used_) {
      double sum[9] = {};
      for (size_t b = 0; b < Place::kNodes; ++b) {
        const double w = q.weight[b];
        const double* const B = block(a, q.node[b]);
        for (int k = 0; k < 9; ++k) sum[k] += w * B[k];
      }
      for (int k = 0; k < 9; ++k) column_[a](k / 3, k % 3) = sum[k];
    }
    for (size_t i = j; i < n; ++i) {
      const Place& p = places[i];
      Mat3 C = p.side == q.side ? touch_.at(p.x - q.x, p.y - q.y) : Mat3::Zero();
      for (size_t a = 0; a < Place::kNodes; ++a) C += p.weight[a] * column_[p.node[a]];
      out[i * n + j] = C;
      if (i != j) out[j * n + i] = C.transpose();
    }
  }
}

void Mesh::displace(std::span<const Place> places, std::span<const Load> loads, Vec3* u) noexcept {
  loaded_.clear();
  ++now_;
  for (const Load& load : loads)
    for (size_t k = 0; k < Place::kNodes; ++k) {
      const uint32_t a = load.at.node[k];
      if (stamp_[a] != now_) stamp_[a] = now_, load_[a].setZero(), loaded_.push_back(a);
      load_[a] += load.at.weight[k] * load.f;
    }
  gather(places);
  for (const uint32_t a : used_) {
    double sum[3] = {};
    for (const uint32_t b : loaded_) {
      const double* const B = block(a, b);
      const Vec3& f = load_[b];
      for (int i = 0; i < 3; ++i) sum[i] += B[3 * i] * f[0] + B[3 * i + 1] * f[1] + B[3 * i + 2] * f[2];
    }
    moved_[a] = Vec3(sum[0], sum[1], sum[2]);
  }
  for (size_t i = 0; i < places.size(); ++i) {
    const Place& p = places[i];
    Vec3 sum = Vec3::Zero();
    for (size_t a = 0; a < Place::kNodes; ++a) sum += p.weight[a] * moved_[p.node[a]];
    for (const Load& load : loads)
      if (p.side == load.at.side) sum += touch_.at(p.x - load.at.x, p.y - load.at.y) * load.f;
    u[i] = sum;
  }
}

}  // namespace swage::tissue
