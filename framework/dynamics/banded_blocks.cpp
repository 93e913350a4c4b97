// SPDX-License-Identifier: Apache-2.0
#include "dynamics/banded_blocks.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace swage::dynamics {

namespace {

using Block = BandedBlocks::Block;

}  // namespace

BandedBlocks::BandedBlocks(uint32_t max_blocks, uint32_t max_fill)
    : max_blocks_(max_blocks), max_fill_(max_fill), words_((max_blocks + 63) / 64) {
  near_.resize(size_t{max_blocks} * words_), of_degree_.resize(size_t{kDegrees} * words_);
  at_.resize(max_blocks), of_.resize(max_blocks), degree_.resize(max_blocks);
  first_.resize(max_blocks + 1), first_update_.resize(max_blocks + 1);
  row_.resize(max_fill), place_.resize(size_t{max_blocks} * max_blocks);
  update_.resize(8 * static_cast<size_t>(max_fill));
  diagonal_.resize(max_blocks), lower_.resize(max_fill), upper_.resize(max_fill);
  late_diagonal_.resize(max_blocks), late_lower_.resize(max_fill);
  y_.resize(4 * static_cast<size_t>(max_blocks));
}

bool BandedBlocks::analyse(uint32_t blocks, std::span<const Pair> coupled, std::span<const uint8_t> late) noexcept {
  n_ = blocks, updates_ = 0;
  first_[0] = 0;
  done_ = 0, early_ = blocks - static_cast<uint32_t>(std::count(late.begin(), late.end(), uint8_t{1}));
  if (blocks <= max_blocks_ && order(coupled, late) && list_updates()) return true;
  n_ = 0;
  return false;
}

/// Minimum degree order: eliminates the block of least degree, the lowest index of equals, couples its neighbours with each other, and
/// repeats. Late blocks come after all others. Blocks of one degree are bits of one line, so that the least is found in a few words.
bool BandedBlocks::order(std::span<const Pair> coupled, std::span<const uint8_t> late) noexcept {
  words_ = (n_ + 63) / 64;
  std::fill_n(near_.begin(), size_t{n_} * words_, uint64_t{0});
  std::fill_n(of_degree_.begin(), size_t{kDegrees} * words_, uint64_t{0});
  const auto bit = [](uint32_t i) { return uint64_t{1} << (i % 64); };
  for (const Pair& p : coupled)
    if (p.a != p.b) line(p.a)[p.b / 64] |= bit(p.b), line(p.b)[p.a / 64] |= bit(p.a);
  const auto is_late = [&](uint32_t i) { return !late.empty() && late[i] != 0; };
  const auto file = [&](uint32_t i) {
    degree_[i] = 0;
    for (uint32_t w = 0; w < words_; ++w) degree_[i] += static_cast<uint32_t>(std::popcount(line(i)[w]));
    with_degree(degree_[i])[i / 64] |= bit(i);
  };
  uint32_t entries = 0;
  for (const bool now_late : {false, true}) {
    for (uint32_t i = 0; i < n_; ++i)
      if (is_late(i) == now_late) file(i);
    for (uint32_t k = now_late ? early_ : 0, last = now_late ? n_ : early_; k < last; ++k) {
      const uint32_t least = least_degree();
      if (entries + degree_[least] > max_fill_) return false;
      of_[k] = least, at_[least] = k;
      with_degree(degree_[least])[least / 64] &= ~bit(least);
      first_[k] = entries;
      for (uint32_t w = 0; w < words_; ++w)
        for (uint64_t bits = line(least)[w]; bits != 0; bits &= bits - 1)
          row_[entries++] = 64 * w + static_cast<uint32_t>(std::countr_zero(bits));
      for (uint32_t e = first_[k]; e < entries; ++e) {
        const uint32_t i = row_[e];
        for (uint32_t w = 0; w < words_; ++w) line(i)[w] |= line(least)[w];
        line(i)[i / 64] &= ~bit(i);
        line(i)[least / 64] &= ~bit(least);
        if (is_late(i) != now_late) continue;
        with_degree(degree_[i])[i / 64] &= ~bit(i);
        file(i);
      }
    }
  }
  first_[n_] = entries;
  return true;
}

/// The block of least degree of those that are filed, the lowest index of equals. Beyond the last line all degrees count as equal.
uint32_t BandedBlocks::least_degree() noexcept {
  for (uint32_t d = 0;; ++d)
    for (uint32_t w = 0; w < words_; ++w)
      if (const uint64_t bits = with_degree(d)[w]; bits != 0) return 64 * w + static_cast<uint32_t>(std::countr_zero(bits));
}

/// Renumbers rows in elimination order and lists, for every product, the block from which it is subtracted.
bool BandedBlocks::list_updates() noexcept {
  for (uint32_t k = 0; k < n_; ++k) {
    for (uint32_t e = first_[k]; e < first_[k + 1]; ++e) row_[e] = at_[row_[e]];
    std::sort(row_.begin() + first_[k], row_.begin() + first_[k + 1]);
    for (uint32_t e = first_[k]; e < first_[k + 1]; ++e) place(row_[e], k) = e;
  }
  for (uint32_t k = 0; k < n_; ++k) {
    first_update_[k] = static_cast<uint32_t>(updates_);
    for (uint32_t j = first_[k]; j < first_[k + 1]; ++j)
      for (uint32_t i = j + 1; i < first_[k + 1]; ++i) {
        if (updates_ == update_.size()) return false;
        update_[updates_++] = {place(row_[i], row_[j]), static_cast<uint16_t>(i - first_[k]),
                               static_cast<uint16_t>(j - first_[k])};
      }
  }
  first_update_[n_] = static_cast<uint32_t>(updates_);
  return true;
}

void BandedBlocks::set_zero(bool symmetric) noexcept {
  done_ = 0, symmetric_ = symmetric;
  for (uint32_t i = 0; i < n_; ++i) diagonal_[i].setZero();
  for (uint32_t e = 0; e < first_[n_]; ++e) lower_[e].setZero();
  for (uint32_t e = 0; !symmetric && e < first_[n_]; ++e) upper_[e].setZero();
}

void BandedBlocks::add(uint32_t a, uint32_t b, const Block& M) noexcept {
  const uint32_t i = at_[a], j = at_[b];
  if (i == j)
    diagonal_[i] += M;
  else if (i > j)
    lower_[place(i, j)] += M;
  else  // above the diagonal: kept transposed, at its mirror place below
    (symmetric_ ? lower_ : upper_)[place(j, i)] += M.transpose();
}

/// D = L U in place, without pivoting. The inverse is not formed: for a thread a million times stiffer along than across, a product with
/// it would lose the stiffness across. Symmetric: L is made from U, which is made from the upper half alone.
bool BandedBlocks::split(Block& D) noexcept {
  for (int k = 0; k < 4; ++k) {
    const double pivot = D(k, k);
    if (!std::isfinite(pivot) || pivot == 0 || (symmetric_ && pivot < 0)) return false;
    negative_ += pivot < 0;
    for (int r = k + 1; r < 4; ++r) D(r, k) = (symmetric_ ? D(k, r) : D(r, k)) / pivot;
    for (int c = k + 1; c < 4; ++c)
      for (int r = k + 1; r < (symmetric_ ? c + 1 : 4); ++r) D(r, c) -= D(r, k) * D(k, c);
  }
  return true;
}

BlockStore BandedBlocks::store() const noexcept {
  const auto numbers = [](const Blocks& blocks) { return const_cast<double*>(blocks.data()->data()); };
  return {numbers(diagonal_), numbers(lower_), numbers(upper_), row_.data(), first_.data(), n_};
}

bool BandedBlocks::eliminate(uint32_t from, uint32_t to) noexcept {
  const BlockStore blocks = store();
  for (uint32_t k = from; k < to; ++k) {
    if (!split(diagonal_[k])) return false;
    const BlockColumn column{k, first_[k], first_[k + 1] - first_[k], update_.data() + first_update_[k],
                             update_.data() + first_update_[k + 1]};
    fours_ ? eliminate_by_fours(blocks, column, symmetric_) : eliminate_by_twos(blocks, column, symmetric_);
  }
  return true;
}

bool BandedBlocks::factor_early() noexcept {
  negative_ = 0;
  if (!eliminate(0, early_)) return false;
  // the two halves of a block differ by rounding: the upper one counts, as in split()
  for (uint32_t k = early_; k < n_; ++k)
    for (int c = 0; c < 4; ++c)
      for (int r = c + 1; r < 4; ++r) diagonal_[k](r, c) = diagonal_[k](c, r);
  std::copy(diagonal_.begin() + early_, diagonal_.begin() + n_, late_diagonal_.begin() + early_);
  std::copy(lower_.begin() + first_[early_], lower_.begin() + first_[n_], late_lower_.begin() + first_[early_]);
  done_ = early_;
  return true;
}

void BandedBlocks::take_late(bool symmetric) noexcept {
  symmetric_ = symmetric;
  std::copy(late_diagonal_.begin() + done_, late_diagonal_.begin() + n_, diagonal_.begin() + done_);
  const uint32_t first = first_[done_], last = first_[n_];
  std::copy(late_lower_.begin() + first, late_lower_.begin() + last, lower_.begin() + first);
  if (!symmetric) std::copy(late_lower_.begin() + first, late_lower_.begin() + last, upper_.begin() + first);
}

bool BandedBlocks::factor() noexcept {
  negative_ = 0;
  return eliminate(done_, n_);
}

void BandedBlocks::forward(uint32_t from, uint32_t to, uint32_t base, double* y) const noexcept {
  fours_ ? forward_by_fours(store(), {from, to, base}, y) : forward_by_twos(store(), {from, to, base}, y);
}

void BandedBlocks::backward(uint32_t from, uint32_t to, uint32_t base, double* y) const noexcept {
  fours_ ? backward_by_fours(store(), {from, to, base}, y) : backward_by_twos(store(), {from, to, base}, y);
}

void BandedBlocks::solve(double* x) const noexcept {
  double* y = y_.data();
  for (uint32_t k = 0; k < n_; ++k) std::copy_n(x + 4 * of_[k], 4, y + 4 * k);
  forward(0, n_, 0, y);
  backward(0, n_, 0, y);
  for (uint32_t k = 0; k < n_; ++k) std::copy_n(y + 4 * k, 4, x + 4 * of_[k]);
}

void BandedBlocks::condense(double* y) const noexcept { forward(0, early_, 0, y); }

void BandedBlocks::solve_early(double* y) const noexcept { backward(0, early_, 0, y); }

void BandedBlocks::solve_late(double* x) const noexcept {
  forward(early_, n_, early_, x);
  backward(early_, n_, early_, x);
}

void BandedBlocks::solve_four_late(double* X) const noexcept {
  const Part late{early_, n_, early_};
  fours_ ? solve_four_by_fours(store(), late, X) : solve_four_by_twos(store(), late, X);
}

void BandedBlocks::take_product(const double* x, double* r) const noexcept {
  BlockStore S = store();
  S.diagonal = const_cast<double*>(late_diagonal_.data()->data()), S.lower = const_cast<double*>(late_lower_.data()->data());
  fours_ ? take_symmetric_by_fours(S, {early_, n_, early_}, x, r) : take_symmetric_by_twos(S, {early_, n_, early_}, x, r);
}

}  // namespace swage::dynamics
