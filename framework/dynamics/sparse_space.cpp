// SPDX-License-Identifier: Apache-2.0
#include "dynamics/sparse_space.hpp"

#include <algorithm>
#include <cmath>

namespace swage::dynamics {

namespace {

// Blocks below the diagonal per block of the system. A thread alone has 2; in a tight throw, where it touches itself and a needle at
// a hundred places, 20. Where it is too little the island is left as it is, and counted.
constexpr uint32_t kFill = 40;

bool same_pairs(const std::vector<BandedBlocks::Pair>& a, const std::vector<BandedBlocks::Pair>& b) noexcept {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& p, const auto& q) { return p.a == q.a && p.b == q.b; });
}

/// The tangent as a matrix in the axes of a constraint.
Mat3 matrix(const Tangent& D) noexcept {
  Mat3 M;
  M << D.nn, 0, 0, D.n1, D.t11, D.t12, D.n2, D.t12, D.t22;
  return M;
}

}  // namespace

SparseSpace::SparseSpace(uint32_t max_unknowns, const SparseRoom& room)
    : H_(max_unknowns + room.vertices, kFill * (max_unknowns + room.vertices)),
      correction_(size_t{4} * (max_unknowns + room.vertices)) {
  const size_t blocks = size_t{max_unknowns} + room.vertices;
  first_.reserve(blocks), sides_.reserve(room.constraints), contact_.reserve(room.constraints);
  // the band, bodies, and up to four blocks on either side of each constraint
  for (auto* pairs : {&pair_, &last_pair_}) pairs->reserve(2 * blocks + 4 * size_t{room.constraints});
  late_.reserve(blocks), last_late_.reserve(blocks);
  for (std::vector<double>* v : {&x_, &F0_, &F_, &whole_}) v->resize(4 * blocks);
}

uint32_t SparseSpace::blocks_of(const DofBlock& block) noexcept {
  if (block.kind == DofBlock::Kind::kBanded) return block.band->vertices();
  return block.kind == DofBlock::Kind::kRigid ? 2 : 1;
}

template <class Entry>
void SparseSpace::each(const Entry& entry) const noexcept {
  for (uint32_t m = 0; m < first_.size(); ++m) {
    const DofBlock& block = *island_->blocks[m];
    const uint32_t per = block.kind == DofBlock::Kind::kBanded ? 4 : 3;
    for (uint32_t u = 0; u < block.size; ++u) entry(block.offset + u, 4 * H_.place_of(first_[m] + u / per) + u % per);
  }
}

size_t SparseSpace::begin(const Island& island) noexcept {
  island_ = &island;
  factored_ = false;
  first_.clear(), sides_.clear(), contact_.clear();
  n_ = 0;
  for (const DofBlock* block : island.blocks) first_.push_back(n_), n_ += blocks_of(*block);
  for (const Constraint& c : island.constraints) sides_.push_back({point(c.block_a, c, true), point(c.block_b, c, false)});
  find_pattern();
  ready_ = analyse() && eliminate_early();
  size_ = ready_ ? size_t{4} * (n_ - H_.early()) : 0;
  if (!ready_) return 0;
  for (const auto& [a, b] : sides_) contact_.emplace_back(H_, a, b).begin_late(H_.early());
  condense_residual();
  return size_;
}

/// Orders the system, unless it has the pairs of the last one. False: there is no room for it.
bool SparseSpace::analyse() noexcept {
  if (n_ == last_n_ && late_ == last_late_ && same_pairs(pair_, last_pair_)) return true;
  const bool fits = H_.analyse(n_, pair_, late_);
  work += 200 * size_t{n_} + 4 * H_.work();
  last_n_ = fits ? n_ : 0;
  last_pair_.swap(pair_), last_late_ = late_;
  return fits;
}

/// Fills H_ with what does not change in a solve, and eliminates what nothing touches.
bool SparseSpace::eliminate_early() noexcept {
  H_.set_zero(true);
  for (uint32_t m = 0; m < first_.size(); ++m) add_block(m);
  work += 64 * H_.early_work();
  return H_.factor_early();
}

/// F0: the residual at z = 0 without constraints, early unknowns eliminated. Keeps in x_ what finish() needs of these.
void SparseSpace::condense_residual() noexcept {
  std::fill_n(x_.begin(), size_t{4} * n_, 0.0);
  std::fill_n(whole_.begin(), island_->size, 0.0);
  double* const F = whole_.data();
  std::fill(F_.begin(), F_.end(), 0.0);  // d = 0, as long as the largest block
  for (const DofBlock* block : island_->blocks) block->residual(F_.data(), F + block->offset);
  each([&](uint32_t of_island, uint32_t at) { x_[at] = -F[of_island]; });
  H_.condense(x_.data());
  for (size_t i = 0; i < size_; ++i) F0_[i] = -x_[size_t{4} * H_.early() + i];
  work += 32 * H_.fill();
}

/// False: bands have only advanced freely, and a search must begin where the loads and contacts of this step lead them.
bool SparseSpace::start(double* z) noexcept {
  std::fill_n(z, size_, 0.0);
  return false;
}

/// J z of a constraint.
Displacement SparseSpace::along(const BlockContact& c, const double* z) const noexcept {
  double u[4];
  H_.has_fours() ? assembly::displace_by_fours(c, z, u) : assembly::displace<toolkit::Twos>(c, z, u);
  return {u[0], u[1], u[2]};
}

void SparseSpace::displace(const double* z) noexcept {
  for (size_t i = 0; i < island_->constraints.size(); ++i) {
    Constraint& c = island_->constraints[i];
    const Displacement u = ready_ ? along(contact_[i], z) : Displacement{};
    c.u = {c.at.g + u.g, c.at.s1 + u.s1, c.at.s2 + u.s2};
  }
}

void SparseSpace::set_search_direction(const double* step) noexcept {
  for (size_t i = 0; i < contact_.size(); ++i) island_->constraints[i].along = along(contact_[i], step);
}

/// F of all but constraints, at z.
void SparseSpace::forces_of_blocks(const double* z) noexcept {
  for (size_t i = 0; i < size_; ++i) F_[i] = -F0_[i];
  H_.take_product(z, F_.data());
  for (size_t i = 0; i < size_; ++i) F_[i] = -F_[i];
  // the torque of a drive is not linear
  for (uint32_t m = 0; m < first_.size(); ++m)
    if (const DofBlock& block = *island_->blocks[m]; block.kind == DofBlock::Kind::kHinge)
      block.residual(z + in_z(first_[m]), F_.data() + in_z(first_[m]));
}

void SparseSpace::residual(const double* z) noexcept {
  if (!ready_) return;
  forces_of_blocks(z);
  for (size_t i = 0; i < contact_.size(); ++i) {
    const Force& force = island_->constraints[i].f;
    const double f[3] = {force.fn, force.f1, force.f2};
    if (f[0] == 0 && f[1] == 0 && f[2] == 0) continue;
    H_.has_fours() ? assembly::push_by_fours(contact_[i], f, F_.data()) : assembly::push<toolkit::Twos>(contact_[i], f, F_.data());
  }
}

/// That of the whole island, in which early unknowns are balanced.
double SparseSpace::merit() noexcept {
  if (!ready_) return 0;
  std::fill_n(whole_.begin(), island_->size, 0.0);
  const uint32_t first = 4 * H_.early();
  each([&](uint32_t of_island, uint32_t at) {
    if (at >= first) whole_[of_island] = F_[at - first];
  });
  double sum = 0;
  for (const DofBlock* block : island_->blocks) sum += block->merit(whole_.data() + block->offset);
  return sum;
}

double SparseSpace::slope(const double* z, const double* step) noexcept {
  if (!ready_) return 0;
  forces_of_blocks(z);
  double sum = 0;
  for (size_t i = 0; i < size_; ++i) sum += F_[i] * step[i];
  return sum;
}

double SparseSpace::length(const double* step) noexcept {
  double longest = 0;
  for (uint32_t m = 0; ready_ && m < first_.size(); ++m)
    if (late_[first_[m]] != 0) longest = std::max(longest, island_->blocks[m]->length(step + in_z(first_[m])));
  for (const BlockContact& c : contact_) {
    const Displacement u = along(c, step);
    longest = std::max(longest, std::sqrt(u.g * u.g + u.s1 * u.s1 + u.s2 * u.s2));
  }
  return longest;
}

void SparseSpace::finish(const double* z, double* d) noexcept {
  std::fill_n(d, island_->size, 0.0);
  if (!ready_) return;
  std::copy_n(z, size_, x_.begin() + 4 * H_.early());
  H_.solve_early(x_.data());
  each([&](uint32_t of_island, uint32_t at) { d[of_island] = x_[at]; });
}

/// One side of a constraint by blocks of H: four columns per block of a band, three per block of others.
BlockPoint SparseSpace::point(uint32_t block, const Constraint& c, bool is_a) const noexcept {
  BlockPoint p;
  const uint32_t size = is_a ? c.size_a : c.size_b, stride = c.size_a + c.size_b;
  if (size == 0) return p;
  const DofBlock& m = *island_->blocks[block];
  const bool band = m.kind == DofBlock::Kind::kBanded;
  const uint32_t per = band ? 4 : 3, first = is_a ? c.offset_a - m.offset : c.offset_b - m.offset;
  const double *J = c.J + (is_a ? 0 : c.size_a), sign = is_a ? 1 : -1;
  p.size = (size + per - 1) / per;
  for (uint32_t k = 0; k < p.size; ++k) {
    p.block[k] = first_[block] + first / per + k;
    p.J[k].setZero();
    for (uint32_t u = k * per; u < std::min(size, (k + 1) * per); ++u)
      for (uint32_t r = 0; r < 3; ++r)
        p.J[k](static_cast<int>(r), static_cast<int>(u - k * per)) = sign * J[r * stride + u];
  }
  return p;
}

void SparseSpace::find_pattern() noexcept {
  pair_.clear();
  for (uint32_t m = 0; m < first_.size(); ++m) {
    const uint32_t n = blocks_of(*island_->blocks[m]), first = first_[m];
    for (uint32_t i = first; i < first + n; ++i)
      for (uint32_t k = i + 1; k < std::min(i + 3, first + n); ++k) pair_.push_back({k, i});
  }
  for (const auto& [a, b] : sides_)
    for (uint32_t i = 0; i < a.size; ++i)
      for (uint32_t k = 0; k < b.size; ++k) pair_.push_back({a.block[i], b.block[k]});
  late_.assign(n_, 0);
  for (const auto& sides : sides_)
    for (const BlockPoint& p : sides)
      for (uint32_t k = 0; k < p.size; ++k) late_[p.block[k]] = 1;
  for (uint32_t m = 0; m < first_.size(); ++m)
    if (island_->blocks[m]->kind == DofBlock::Kind::kHinge) late_[first_[m]] = 1;
}

/// Adds the upper half of what does not change in a solve.
void SparseSpace::add_block(uint32_t block) noexcept {
  const DofBlock& m = *island_->blocks[block];
  if (m.kind == DofBlock::Kind::kBanded) return m.band->add_stiffness(H_, first_[block], true);
  BandedBlocks::Block M = BandedBlocks::Block::Identity();
  const int moves = m.kind == DofBlock::Kind::kHinge ? 1 : 3;
  for (int i = 0; i < moves; ++i) M(i, i) = m.m_hh;
  H_.add(first_[block], first_[block], M);
  if (m.kind != DofBlock::Kind::kRigid) return;
  M.topLeftCorner<3, 3>() = m.I_hh;
  H_.add(first_[block] + 1, first_[block] + 1, M);
}

bool SparseSpace::assemble(const double* z) noexcept {
  symmetric_ = true;
  for (const Constraint& c : island_->constraints) symmetric_ = symmetric_ && c.D.n1 == 0 && c.D.n2 == 0;
  H_.take_late(symmetric_);
  for (uint32_t m = 0; m < first_.size(); ++m) {
    const DofBlock& block = *island_->blocks[m];
    if (block.kind != DofBlock::Kind::kHinge) continue;
    BandedBlocks::Block M = BandedBlocks::Block::Zero();
    M(0, 0) = block.drive.stiffness(block.angle + z[in_z(first_[m])]);
    H_.add(first_[m], first_[m], M);
  }
  for (size_t i = 0; i < contact_.size(); ++i) {
    const Tangent& D = island_->constraints[i].D;
    if (stiffens(D)) add_contact(H_, contact_[i], matrix(D), symmetric_);
  }
  work += 64 * (symmetric_ ? 1 : 2) * H_.late_work() + 1000 * contact_.size();
  return H_.factor();
}

bool SparseSpace::search_direction(const double* z, bool same, double* step) noexcept {
  if (!ready_) return false;
  same = same_drives(z) && same;
  if (!same || !factored_) factored_ = assemble(z);
  correction_.clear();
  if (!factored_) return false;
  work += 32 * H_.late_fill() + 8 * size_;
  for (size_t i = 0; i < size_; ++i) step[i] = -F_[i];
  H_.solve_late(step);
  return true;
}

bool SparseSpace::corrected_direction(const double* z, uint32_t constraint, const Tangent& D, double* step) noexcept {
  if (!ready_ || !factored_ || !same_drives(z)) return false;
  const Tangent& then = island_->constraints[constraint].D;
  const double E[3][3] = {{D.nn - then.nn, 0, 0},
                          {D.n1 - then.n1, D.t11 - then.t11, D.t12 - then.t12},
                          {D.n2 - then.n2, D.t12 - then.t12, D.t22 - then.t22}};
  work += 128 * H_.late_fill() + 32 * size_;
  for (size_t i = 0; i < size_; ++i) step[i] = -F_[i];
  return correction_.solve(H_, contact_, constraint, E, step, size_);
}

/// Sets the drives of hinges to the pieces that they are on at z. True when none changed.
bool SparseSpace::same_drives(const double* z) noexcept {
  bool same = true;
  for (uint32_t m = 0; m < first_.size(); ++m)
    if (DofBlock& block = *island_->blocks[m]; block.kind == DofBlock::Kind::kHinge) same = block.update_drive(z[in_z(first_[m])]) && same;
  return same;
}

int SparseSpace::sign() const noexcept { return correction_.sign() * (H_.negative_pivots() % 2 == 0 ? 1 : -1); }

}  // namespace swage::dynamics
