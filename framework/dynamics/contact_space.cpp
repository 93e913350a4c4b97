// SPDX-License-Identifier: Apache-2.0
#include "dynamics/contact_space.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dynamics/jacobian.hpp"
#include "dynamics/lines.hpp"

namespace swage::dynamics {
namespace {

using Line = Eigen::Map<Eigen::VectorXd>;
using ConstLine = Eigen::Map<const Eigen::VectorXd>;


Vec3 vec3(const double* a) { return {a[0], a[1], a[2]}; }
Vec3 force(const Constraint& constraint) {
  return in_world(constraint, constraint.f.fn, constraint.f.f1, constraint.f.f2);
}

}  // namespace

ContactSpace::ContactSpace(uint32_t max_constraints, uint32_t max_hinges, uint32_t max_of_bands)
    : system_(max_constraints, max_hinges) {
  const size_t n = size_t{3} * max_constraints + max_hinges;
  W_.resize(n * n);
  for (std::vector<double>* v : {&free_, &c_, &F_, &v_, &y_, &line_}) v->resize(n);
  Jt_.resize(size_t{2} * BandedBody::kOfPoint * max_constraints), Minv_Jt_.resize(size_t{12} * max_constraints + 1);
  products_.resize(size_t{2} * 12 * max_constraints);
  of_block_.resize(std::max(max_of_bands, 6u));
  arm_.reserve(size_t{2} * max_constraints);
  drive_.resize(max_hinges);
  hinge_.reserve(max_hinges);
}

// --- points

bool ContactSpace::start(double* z) noexcept {
  std::fill_n(z, 2 * n_, 0.0);
  for (size_t i = 0; i < n_constraints_; ++i) {
    const Constraint& constraint = island_->constraints[i];
    put(in_world(constraint, constraint.at.g, constraint.at.s1, constraint.at.s2), z + 3 * i);
  }
  return false;
}

void ContactSpace::displace(const double* z) noexcept {
  for (size_t i = 0; i < n_constraints_; ++i) {
    Constraint& constraint = island_->constraints[i];
    const Vec3 v = vec3(z + 3 * i);
    constraint.u = {constraint.n.dot(v), constraint.t1.dot(v), constraint.t2.dot(v)};
  }
}

/// F = y - f.
void ContactSpace::residual(const double* z) noexcept {
  const double* y = z + n_;
  for (size_t i = 0; i < n_constraints_; ++i)
    put(vec3(y + 3 * i) - force(island_->constraints[i]), &F_[3 * i]);
  for (size_t i = 3 * n_constraints_, h = 0; i < n_; ++i, ++h)
    F_[i] = y[i] - hinge_[h]->drive.torque(hinge_[h]->angle + z[i]);
}

double ContactSpace::merit() noexcept {
  std::fill_n(line_.begin(), n_, 0.0);
  work += n_ * n_;
  apply_delassus(F_.data(), line_.data());
  double sum = 0;
  for (size_t i = 0; i < n_; ++i) sum += F_[i] * line_[i];
  return sum;
}

/// v += W y.
void ContactSpace::apply_delassus(const double* y, double* v) const noexcept {
  const double* L = W_.data();
  Line all(v, index(n_));
  for (size_t i = 0; i < 3 * n_constraints_; i += 3, L += 3 * n_) {
    if (y[i] == 0 && y[i + 1] == 0 && y[i + 2] == 0) continue;
    lines::add_sum(n_, y + i, L, n_, v);
  }
  for (size_t i = 3 * n_constraints_; i < n_; ++i, L += n_) all += y[i] * ConstLine(L, index(n_));
}

// --- steps

/// Where neither D nor c has changed since the last call, the step ends at the same point.
bool ContactSpace::search_direction(const double* z, bool same, double* step) noexcept {
  const Kept kept = linearise(z);
  if (!(same && kept.stiffness && factored_)) {
    solved_ = false;
    factored_ = factor();
    if (!factored_) return false;
  }
  if (!(solved_ && kept.forces)) solve();
  solved_ = true;
  for (size_t i = 0; i < n_; ++i) step[i] = v_[i] - z[i], step[n_ + i] = y_[i] - z[n_ + i];
  return true;
}

/// Computes c = f + D v and the stiffness of the drives.
ContactSpace::Kept ContactSpace::linearise(const double* z) noexcept {
  Kept kept;
  const auto keep = [](double& old, double now, bool& same) {
    same = same && old == now;
    old = now;
  };
  for (size_t i = 0; i < n_constraints_; ++i) {
    const Constraint& constraint = island_->constraints[i];
    const Force& f = constraint.f;
    const Displacement& u = constraint.u;
    const Tangent& D = constraint.D;
    const Vec3 c = in_world(constraint, f.fn + D.nn * u.g, f.f1 + D.n1 * u.g + D.t11 * u.s1 + D.t12 * u.s2,
                            f.f2 + D.n2 * u.g + D.t12 * u.s1 + D.t22 * u.s2);
    for (size_t k = 0; k < 3; ++k) keep(c_[3 * i + k], c[index(k)], kept.forces);
  }
  for (size_t h = 0; h < hinge_.size(); ++h) {
    const DofBlock& hinge = *hinge_[h];
    const double angle = hinge.angle + z[3 * n_constraints_ + h], k = hinge.drive.stiffness(angle);
    keep(drive_[h], k, kept.stiffness);
    keep(c_[3 * n_constraints_ + h], hinge.drive.torque_at_zero(angle) - k * hinge.angle, kept.forces);
  }
  return kept;
}

/// Factors D = S R' of a constraint: the normal with its friction, then the tangential directions.
void ContactSpace::split(const Constraint& constraint, ContactSystem::Factors& f) noexcept {
  const Tangent& D = constraint.D;
  f.rank = 0;
  f.spring = D.n1 == 0 && D.n2 == 0 && D.t12 == 0 && D.t11 == D.t22;
  const auto add = [&f](const Vec3& R) { f.R[f.rank] = f.S[f.rank] = R, ++f.rank; };
  if (D.nn > 0) {
    const double root = std::sqrt(D.nn);
    add(root * constraint.n);
    if (D.n1 != 0 || D.n2 != 0) f.S[0] += (D.n1 * constraint.t1 + D.n2 * constraint.t2) / root;
  }
  // rounding may leave these below zero where a slipping contact opens
  if (!(std::max(D.t11, D.t22) > 0)) return;
  if (D.t12 == 0 && D.t11 == D.t22) {
    const double root = std::sqrt(D.t11);
    add(root * constraint.t1);
    add(root * constraint.t2);
  } else if (D.t11 >= D.t22) {  // rank one: the law resists across one direction only
    const double root = std::sqrt(D.t11);
    add(root * constraint.t1 + D.t12 / root * constraint.t2);
  } else {
    const double root = std::sqrt(D.t22);
    add(D.t12 / root * constraint.t1 + root * constraint.t2);
  }
}

/// Islands without a thread need few search directions, hardly two alike: where something slips there they are factored whole.
bool ContactSpace::factor() noexcept {
  bool springs = true;
  for (size_t i = 0; i < n_constraints_; ++i) {
    split(island_->constraints[i], system_.of(i));
    springs = springs && system_.of(i).spring;
  }
  springs = springs || island_->banded;
  for (size_t i = 0; i < n_constraints_; ++i) system_.of(i).spring = system_.of(i).spring && springs;
  for (size_t h = 0; h < hinge_.size(); ++h) {
    ContactSystem::Factors& f = system_.of(n_constraints_ + h);
    f.rank = drive_[h] > 0 ? 1 : 0;
    f.spring = springs;
    f.R[0] = f.S[0] = {std::sqrt(drive_[h]), 0, 0};
  }
  return system_.factor();
}

/// Computes v and y at the end of the step.
void ContactSpace::solve() noexcept {
  std::copy_n(free_.begin(), n_, v_.begin());
  apply_delassus(c_.data(), v_.data());
  std::copy_n(c_.begin(), n_, y_.begin());
  system_.solve(v_.data(), y_.data());
  std::copy_n(free_.begin(), n_, v_.begin());
  apply_delassus(y_.data(), v_.data());
  work += 2 * n_ * n_ + std::exchange(system_.work, 0);
}

int ContactSpace::sign() const noexcept { return system_.sign(); }

void ContactSpace::set_search_direction(const double* step) noexcept {
  for (size_t i = 0; i < n_constraints_; ++i) {
    Constraint& constraint = island_->constraints[i];
    const Vec3 v = vec3(step + 3 * i);
    constraint.along = {constraint.n.dot(v), constraint.t1.dot(v), constraint.t2.dot(v)};
  }
}

double ContactSpace::slope(const double* z, const double* step) noexcept {
  const double* y = z + n_;
  double sum = 0;
  for (size_t i = 0; i < 3 * n_constraints_; ++i) sum += y[i] * step[i];
  for (size_t i = 3 * n_constraints_, h = 0; i < n_; ++i, ++h)
    sum += (y[i] - hinge_[h]->drive.torque(hinge_[h]->angle + z[i])) * step[i];
  return sum;
}

/// d = A^-1 J' y: displacement of a body, particle or band under the forces y.
void ContactSpace::apply_inverse_mass(uint32_t block, const double* y, double* d) noexcept {
  const DofBlock& m = *island_->blocks[block];
  double* F = of_block_.data();
  std::fill_n(F, m.size, 0.0);
  for (size_t i = 0; i < n_constraints_; ++i) {
    const Constraint& constraint = island_->constraints[i];
    const uint32_t stride = constraint.size_a + constraint.size_b;
    const Vec3 v = vec3(y + 3 * i), f(constraint.n.dot(v), constraint.t1.dot(v), constraint.t2.dot(v));
    const auto add = [&](const double* J, uint32_t size, double* to) {
      for (uint32_t u = 0; u < size; ++u)
        to[u] += J[u] * f[0] + J[stride + u] * f[1] + J[2 * stride + u] * f[2];
    };
    if (constraint.block_a == block) add(constraint.J, constraint.size_a, F + (constraint.offset_a - m.offset));
    if (constraint.block_b == block)
      add(constraint.J + constraint.size_a, constraint.size_b, F + (constraint.offset_b - m.offset));
  }
  m.apply_inverse_mass(F, d);
}

double ContactSpace::length(const double* step) noexcept {
  double longest = 0, d[6];
  for (size_t i = 0; i < n_constraints_; ++i) longest = std::max(longest, vec3(step + 3 * i).norm());
  for (uint32_t m = 0; m < island_->blocks.size(); ++m) {
    const DofBlock& block = *island_->blocks[m];
    if (block.kind != DofBlock::Kind::kRigid && block.kind != DofBlock::Kind::kParticle) continue;
    apply_inverse_mass(m, step + n_, d);
    longest = std::max(longest, block.length(d));
  }
  return longest;
}

double ContactSpace::moved(const double* z) noexcept {
  double longest = 0, d[6];
  for (size_t i = 0; i < n_constraints_; ++i) {
    const Constraint& constraint = island_->constraints[i];
    longest = std::max(
        longest,
        (vec3(z + 3 * i) - in_world(constraint, constraint.at.g, constraint.at.s1, constraint.at.s2)).norm());
  }
  for (uint32_t m = 0; m < island_->blocks.size(); ++m) {
    const DofBlock& block = *island_->blocks[m];
    if (block.kind != DofBlock::Kind::kRigid && block.kind != DofBlock::Kind::kParticle) continue;
    go(m, z, d);
    longest = std::max(longest, block.length(d));
  }
  return longest;
}

/// Displacement of a block from the pose of the linearisation to z.
void ContactSpace::go(uint32_t block, const double* z, double* d) noexcept {
  const DofBlock& m = *island_->blocks[block];
  apply_inverse_mass(block, z + n_, d);
  double* to_free = of_block_.data();
  m.to_free(to_free);
  Line(d, m.size) += ConstLine(to_free, m.size);
}

void ContactSpace::finish(const double* z, double* d) noexcept {
  for (size_t i = 0; i < n_constraints_; ++i) island_->constraints[i].y = vec3(z + n_ + 3 * i);
  uint32_t hinge = 0;
  for (uint32_t m = 0; m < island_->blocks.size(); ++m) {
    const DofBlock& block = *island_->blocks[m];
    if (block.kind == DofBlock::Kind::kFlexible) continue;
    if (block.kind == DofBlock::Kind::kHinge)
      d[block.offset] = z[3 * n_constraints_ + hinge++];
    else
      go(m, z, d + block.offset);
  }
}

}  // namespace swage::dynamics
