// SPDX-License-Identifier: Apache-2.0
#include "dynamics/banded_body.hpp"

#include <swage/abi/band.h>

#include <algorithm>
#include <cmath>

#include "dynamics/flexible_body.hpp"

namespace swage::dynamics {

using toolkit::Vec3;

static_assert(toolkit::Band<10>::kStride == SWAGE_BAND_COLUMN && SWAGE_BAND_REACH == 10 &&
              BandedBody::kUnknowns == SWAGE_BAND_UNKNOWNS);

namespace {
constexpr uint32_t kBack = (SWAGE_BAND_REACH + SWAGE_BAND_UNKNOWNS - 1) / SWAGE_BAND_UNKNOWNS;  // vertices within reach

/// True when all numbers are finite: 0 x is 0 except for infinity and NaN, in whatever order the sum is taken.
bool finite(const double* x, size_t n) noexcept {
  return (0.0 * Eigen::Map<const Eigen::VectorXd>(x, static_cast<Eigen::Index>(n))).sum() == 0;
}
}  // namespace

BandedBody::BandedBody(uint32_t object, uint32_t vertices)
    : object_(object),
      vertices_(vertices),
      A_(static_cast<int>(kUnknowns * vertices)),
      factors_(static_cast<int>(kUnknowns * vertices)),
      block_(3 * static_cast<size_t>(vertices)) {
  for (std::vector<double>* v : {&gradient_, &free_, &q_, &line_}) v->assign(unknowns(), 0.0);
  column_.assign(size_t{kUnknowns} * unknowns() * vertices, 0.0);
  side_.assign(size_t{kUnknowns} * unknowns(), 0.0);
  column_from_.assign(vertices, vertices);
}

void BandedBody::begin() noexcept {
  std::fill(q_.begin(), q_.end(), 0.0);
  std::fill(free_.begin(), free_.end(), 0.0);
}

bool BandedBody::linearise(FlexibleBody& object, bool from_last, uint64_t& stiffer) noexcept {
  from_last_ = from_last;
  // A level that was too soft in the last step mostly is too soft in this one.
  uint64_t level = stiffer > 0 ? stiffer - 1 : 0;
  Attempt last = attempt(object, level);
  if (last == Attempt::kFactored) {
    while (level > 0 && last == Attempt::kFactored) last = attempt(object, --level);
    if (last == Attempt::kTooSoft) last = attempt(object, ++level);
  } else {
    while (last == Attempt::kTooSoft && level < SWAGE_BAND_STIFFER) last = attempt(object, ++level);
  }
  stiffer = level;
  if (last != Attempt::kFactored) return false;
  line(free_.data()) = -line(gradient_.data());
  solve(free_.data());
  has_blocks_ = false;
  std::fill(column_from_.begin(), column_from_.end(), vertices_);
  return true;
}

BandedBody::Attempt BandedBody::attempt(FlexibleBody& object, uint64_t stiffer) noexcept {
  A_.set_zero();
  std::fill(gradient_.begin(), gradient_.end(), 0.0);
  if (!object.linearise(static_cast<uint32_t>(stiffer), A_.column(0), gradient_.data())) return Attempt::kUnsound;
  if (!finite(gradient_.data(), unknowns())) return Attempt::kUnsound;
  hold();
  take_factors();
  if (factors_.factor()) return Attempt::kFactored;
  return object.stiffness_is_sound(A_.column(0)) ? Attempt::kTooSoft : Attempt::kUnsound;
}

/// Fixes unknowns without stiffness where they are.
void BandedBody::hold() noexcept {
  const int n = A_.size();
  // entries beyond the last unknown
  for (int j = std::max(0, n - SWAGE_BAND_REACH); j < n; ++j) std::fill(A_.column(j) + (n - j), A_.column(j) + SWAGE_BAND_COLUMN, 0.0);
  for (int j = 0; j < n; ++j) {
    double* a = A_.column(j);
    a[SWAGE_BAND_COLUMN - 1] = 0;
    if (a[0] != 0) continue;
    A_.hold(j);
    a[0] = kHeld;
    gradient_[static_cast<size_t>(j)] = 0;
  }
}

/// Copies A to the factors, in reverse order where from_last_. Sizes are equal: nothing allocates.
void BandedBody::take_factors() noexcept {
  if (!from_last_) {
    factors_ = A_;
    return;
  }
  // entry k of column j is entry k of column n - 1 - j - k of A; beyond the end it is 0
  constexpr std::ptrdiff_t kNext = 1 - SWAGE_BAND_COLUMN;
  const int n = A_.size();
  for (int j = 0; j < n; ++j) {
    double* to = factors_.column(j);
    const double* from = A_.column(n - 1 - j);
    const int last = std::min(n - 1 - j, SWAGE_BAND_REACH);
    if (last == SWAGE_BAND_REACH) {
#pragma GCC unroll 11
      for (int k = 0; k <= SWAGE_BAND_REACH; ++k) to[k] = from[k * kNext];
    } else {
      for (int k = 0; k <= SWAGE_BAND_REACH; ++k) to[k] = k <= last ? from[k * kNext] : 0;
    }
    to[SWAGE_BAND_COLUMN - 1] = 0;
  }
  std::fill_n(factors_.column(n), SWAGE_BAND_REACH * SWAGE_BAND_COLUMN, 0.0);
}

/// Number of leading zeros of x in the order of the factors, which substitution skips.
int BandedBody::first_of(const double* x) const noexcept {
  const auto n = static_cast<int>(unknowns());
  const int way = from_last_ ? -1 : 1;
  const double* at = from_last_ ? x + n - 1 : x;
  int first = 0;
  for (; first < n && *at == 0; ++first) at += way;
  return first;
}

/// Solves in place.
void BandedBody::solve(double* x) const noexcept {
  const int first = first_of(x);
  if (first == static_cast<int>(unknowns())) return;
  from_last_ ? factors_.solve_reversed(x, first) : factors_.solve(x, first);
}

const double* BandedBody::column(uint32_t vertex, uint32_t least, uint32_t most) noexcept {
  constexpr int kSides = static_cast<int>(kUnknowns);
  const size_t of_vertex = size_t{kUnknowns} * kUnknowns;
  double* to = column_.data() + of_vertex * vertices_ * vertex;
  const auto placed = [&](uint32_t v) { return from_last_ ? vertices_ - 1 - v : v; };
  const uint32_t at = placed(vertex), from = placed(from_last_ ? most : least);
  if (column_from_[vertex] <= from) return to;
  double* side = from_last_ ? side_.data() : to;
  // forward substitution reads back as far as the band reaches
  const uint32_t clear = std::min(from, at - std::min(at, kBack));
  std::fill(side + of_vertex * clear, side + of_vertex * vertices_, 0.0);
  for (uint32_t k = 0; k < kUnknowns; ++k) {
    const uint32_t unknown = from_last_ ? kUnknowns - 1 - k : k;
    side[kUnknowns * (kUnknowns * at + unknown) + k] = 1;
  }
  factors_.solve<kSides>(side, kSides * static_cast<int>(at), kSides * static_cast<int>(from));
  if (from_last_)
    for (uint32_t i = kUnknowns * from; i < unknowns(); ++i)
      std::copy_n(side + kUnknowns * i, kUnknowns, to + kUnknowns * (unknowns() - 1 - i));
  column_from_[vertex] = from;
  return to;
}

/// Copies A to blocks, on demand: only the sparse solve of a whole island needs them.
void BandedBody::find_blocks() noexcept {
  has_blocks_ = true;
  for (uint32_t j = 0; j < vertices_; ++j)
    for (int c = 0; c < 4; ++c) {
      const int column = static_cast<int>(4 * j) + c;
      const double* a = A_.column(column);
      // what lies beyond the reach is the zero at the end of the column
      double* M = block_[3 * j].data() + 4 * c;
      for (int r = 0; r < c; ++r) M[r] = A_.at(column, column - c + r);
      for (int r = c; r < 4; ++r) M[r] = a[r - c];
      if (j + 1 < vertices_) std::copy_n(a + 4 - c, 4, block_[3 * j + 1].data() + 4 * c);
      if (j + 2 < vertices_) std::copy_n(a + 8 - c, 4, block_[3 * j + 2].data() + 4 * c);
    }
}

void BandedBody::add_stiffness(BandedBlocks& H, uint32_t first, bool symmetric) noexcept {
  if (!has_blocks_) find_blocks();
  for (uint32_t j = 0; j < vertices_; ++j)
    for (uint32_t below = 0; below < 3 && j + below < vertices_; ++below) {
      const BandedBlocks::Block& M = block_[3 * j + below];
      H.add(first + j + below, first + j, M);
      if (!symmetric && below > 0) H.add(first + j, first + j + below, M.transpose());
    }
}

void BandedBody::go(const double* d) noexcept { line(q_.data()) += line(d); }

bool BandedBody::release() noexcept {
  if (q_ == free_) return false;
  std::copy(free_.begin(), free_.end(), q_.begin());
  return true;
}

void BandedBody::residual(const double* d, double* F) const noexcept {
  line(line_.data()) = line(q_.data()) + line(d);
  A_.multiply(line_.data(), F);
  line(F) += line(gradient_.data());
}

void BandedBody::to_free(double* d) const noexcept {
  line(d) = line(free_.data()) - line(q_.data());
}

double BandedBody::merit(const double* F) const noexcept {
  std::copy_n(F, unknowns(), line_.begin());
  const int first = first_of(F);
  return from_last_ ? factors_.inverse_form_reversed(line_.data(), first) : factors_.inverse_form(line_.data(), first);
}

Vec3 BandedBody::moved(const contact::ChainPlace& at, const Vec3& turn, const double* q) noexcept {
  const double* a = q + kUnknowns * at.segment;
  const double s = at.share;
  return Vec3((1 - s) * a[0] + s * a[4], (1 - s) * a[1] + s * a[5], (1 - s) * a[2] + s * a[6]) + a[3] * turn;
}

}  // namespace swage::dynamics
