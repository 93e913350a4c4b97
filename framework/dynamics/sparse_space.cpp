// SPDX-License-Identifier: Apache-2.0
#include "dynamics/sparse_space.hpp"

#include <algorithm>

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
    : DisplacementSpace(max_unknowns + BandedBody::kUnknowns * room.vertices, 0),
      H_(max_unknowns + room.vertices, kFill * (max_unknowns + room.vertices)) {
  const size_t blocks = size_t{max_unknowns} + room.vertices;
  first_.reserve(blocks), sides_.reserve(room.constraints);
  // the band, bodies, and up to four blocks on either side of each constraint
  for (auto* pairs : {&pair_, &last_pair_}) pairs->reserve(2 * blocks + 4 * size_t{room.constraints});
  x_.resize(4 * blocks);
  late_.reserve(blocks), last_late_.reserve(blocks);
}

uint32_t SparseSpace::blocks_of(const DofBlock& block) noexcept {
  if (block.kind == DofBlock::Kind::kBanded) return block.band->vertices();
  return block.kind == DofBlock::Kind::kRigid ? 2 : 1;
}

size_t SparseSpace::begin(const Island& island) noexcept {
  DisplacementSpace::begin(island);
  first_.clear(), sides_.clear();
  n_ = 0;
  for (const DofBlock* block : island.blocks) first_.push_back(n_), n_ += blocks_of(*block);
  for (const Constraint& c : island.constraints) sides_.push_back({point(c.block_a, c, true), point(c.block_b, c, false)});
  find_pattern();
  early_ = false;
  if (!ready_ || n_ != last_n_ || late_ != last_late_ || !same_pairs(pair_, last_pair_)) {
    ready_ = H_.analyse(n_, pair_, late_);
    work += 16 * size_t{n_} * n_;
    last_n_ = n_;
    last_pair_.swap(pair_), last_late_.swap(late_);
  }
  return island.size;
}

/// False: bands have only advanced freely, and a search must begin where the loads and contacts of this step lead them.
bool SparseSpace::start(double* d) noexcept {
  DisplacementSpace::start(d);
  return false;
}

/// One side of a constraint by blocks of H: four columns per block of a band, three per block of others.
BlockPoint SparseSpace::point(uint32_t block, const Constraint& c, bool is_a) const noexcept {
  BlockPoint p;
  const uint32_t size = is_a ? c.size_a : c.size_b, stride = c.size_a + c.size_b;
  if (size == 0) return p;
  const DofBlock& m = *island().blocks[block];
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
    const uint32_t n = blocks_of(*island().blocks[m]), first = first_[m];
    for (uint32_t i = first; i < first + n; ++i)
      for (uint32_t k = i + 1; k < std::min(i + 3, first + n); ++k) pair_.push_back({k, i});
  }
  for (const Sides& s : sides_)
    for (uint32_t i = 0; i < s.a.size; ++i)
      for (uint32_t k = 0; k < s.b.size; ++k) pair_.push_back({s.a.block[i], s.b.block[k]});
  late_.assign(n_, 0);
  for (const Sides& s : sides_)
    for (const BlockPoint* p : {&s.a, &s.b})
      for (uint32_t k = 0; k < p->size; ++k) late_[p->block[k]] = 1;
  for (uint32_t m = 0; m < first_.size(); ++m)
    if (island().blocks[m]->kind == DofBlock::Kind::kHinge) late_[first_[m]] = 1;
}

/// Adds the upper half of what does not change in a solve.
void SparseSpace::add_block(uint32_t block) noexcept {
  const DofBlock& m = *island().blocks[block];
  if (m.kind == DofBlock::Kind::kBanded) return m.band->add_stiffness(H_, first_[block], true);
  BandedBlocks::Block M = BandedBlocks::Block::Identity();
  const int moves = m.kind == DofBlock::Kind::kHinge ? 1 : 3;
  for (int i = 0; i < moves; ++i) M(i, i) = m.m_hh;
  H_.add(first_[block], first_[block], M);
  if (m.kind != DofBlock::Kind::kRigid) return;
  M.topLeftCorner<3, 3>() = m.I_hh;
  H_.add(first_[block] + 1, first_[block] + 1, M);
}

bool SparseSpace::factor_early() noexcept {
  H_.set_zero();
  for (uint32_t m = 0; m < first_.size(); ++m) add_block(m);
  work += 64 * H_.early_work();
  return H_.factor_early();
}

bool SparseSpace::assemble(const double* d) noexcept {
  early_ = early_ || factor_early();
  if (!early_) return false;
  symmetric_ = true;
  for (const Constraint& c : island().constraints) symmetric_ = symmetric_ && c.D.n1 == 0 && c.D.n2 == 0;
  H_.take_late(symmetric_);
  for (uint32_t m = 0; m < first_.size(); ++m) {
    const DofBlock& block = *island().blocks[m];
    if (block.kind != DofBlock::Kind::kHinge) continue;
    BandedBlocks::Block M = BandedBlocks::Block::Zero();
    M(0, 0) = block.drive.stiffness(block.angle + d[block.offset]);
    H_.add(first_[m], first_[m], M);
  }
  for (size_t i = 0; i < sides_.size(); ++i) {
    const Tangent& D = island().constraints[i].D;
    if (stiffens(D)) add_contact(H_, sides_[i].a, sides_[i].b, matrix(D), symmetric_);
  }
  work += 64 * (symmetric_ ? 1 : 2) * H_.late_work() + 1000 * sides_.size();
  return H_.factor(symmetric_);
}

bool SparseSpace::search_direction(const double* d, bool same, double* step) noexcept {
  if (!ready_) return false;
  same = update_drives(d) && same;
  if (!same || !factored_) {
    factored_ = assemble(d);
    if (!factored_) return false;
  }
  work += 32 * (H_.fill() + n_);
  std::fill_n(x_.begin(), size_t{4} * n_, 0.0);
  const auto each = [&](auto&& entry) {
    for (uint32_t m = 0; m < first_.size(); ++m) {
      const DofBlock& block = *island().blocks[m];
      const uint32_t per = block.kind == DofBlock::Kind::kBanded ? 4 : 3;
      for (uint32_t u = 0; u < block.size; ++u)
        entry(block.offset + u, 4 * (first_[m] + u / per) + u % per);
    }
  };
  each([&](uint32_t of_island, uint32_t at) { x_[at] = -F_[of_island]; });
  H_.solve(x_.data());
  each([&](uint32_t of_island, uint32_t at) { step[of_island] = x_[at]; });
  return true;
}

int SparseSpace::sign() const noexcept { return H_.negative_pivots() % 2 == 0 ? 1 : -1; }

}  // namespace swage::dynamics
