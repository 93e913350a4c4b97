// SPDX-License-Identifier: Apache-2.0
#include "dynamics/contact_system.hpp"

#include <algorithm>

#include "dynamics/dense.hpp"
#include "dynamics/jacobian.hpp"

namespace swage::dynamics {
namespace {

using Line = Eigen::Map<Eigen::VectorXd>;
using ConstLine = Eigen::Map<const Eigen::VectorXd>;


double product(const Vec3& R, size_t size, const double* of) {
  return size == 3 ? R.x() * of[0] + R.y() * of[1] + R.z() * of[2] : R.x() * of[0];
}

}  // namespace

ContactSystem::ContactSystem(uint32_t max_constraints, uint32_t max_drives)
    : of_(max_constraints + max_drives), was_(max_constraints + max_drives), left_(max_constraints + max_drives) {
  const size_t n = size_t{3} * max_constraints + max_drives;
  for (std::vector<double>* m : {&store_, &A_}) m->resize(n * n);
  for (std::vector<double>* v : {&line_, &w_, &right_, &s_}) v->resize(n);
  for (std::vector<uint32_t>* v : {&spring_, &rest_}) v->reserve(of_.size());
  for (std::vector<uint32_t>* v : {&first_, &slot_}) v->resize(of_.size());
  for (std::vector<uint32_t>* v : {&number_, &pivot_}) v->resize(n);
}

void ContactSystem::begin(const double* W, size_t constraints, size_t drives) noexcept {
  W_ = W, constraints_ = constraints, drives_ = drives;
  n_ = 3 * constraints + drives;
  ready_ = false;
  std::fill_n(left_.begin(), elements(), uint8_t{0});
}

bool ContactSystem::factor() noexcept {
  if (!(ready_ && springs_hold())) ready_ = factor_springs();
  return ready_ && factor_rest();
}

/// True when every element counted as a spring has the factors that M was built with. Others leave M until begin().
bool ContactSystem::springs_hold() noexcept {
  bool all = true;
  for (const uint32_t i : spring_) {
    const Factors &now = of_[i], &was = was_[i];
    left_[i] = !(now.spring && now.rank == was.rank && std::equal(now.R, now.R + now.rank, was.R));
    all = all && !left_[i];
  }
  return all;
}

/// line_ = R' times the rows of W that belong to an element.
void ContactSystem::combine(const Vec3& R, size_t element, const double* from, size_t stride, size_t length) noexcept {
  if (size(element) == 3)
    lines::set_sum(length, R.data(), from, stride, line_.data());
  else
    Line(line_.data(), index(length)) = R.x() * ConstLine(from, index(length));
}

/// Builds and factors M = I + R' W R over all elements that are springs now.
bool ContactSystem::factor_springs() noexcept {
  spring_.clear();
  springs_ = slots_ = 0;
  std::fill_n(slot_.begin(), elements(), scene::kNone);
  for (uint32_t i = 0; i < elements(); ++i) {
    if (!of_[i].spring || of_[i].rank == 0 || left_[i]) continue;
    spring_.push_back(i);
    was_[i] = of_[i];
    first_[i] = static_cast<uint32_t>(springs_);
    springs_ += of_[i].rank;
  }
  double* M = store_.data();
  for (size_t k = 0; k < spring_.size(); ++k) {
    const uint32_t i = spring_[k];
    for (uint32_t a = 0; a < of_[i].rank; ++a, M += springs_) {
      const size_t from = place(i);
      combine(of_[i].R[a], i, W(from) + from, n_, n_ - from);
      for (size_t l = k; l < spring_.size(); ++l) {
        const uint32_t j = spring_[l];
        for (uint32_t b = 0; b < of_[j].rank; ++b)
          M[first_[j] + b] = product(of_[j].R[b], size(j), &line_[place(j) - from]);
      }
      M[first_[i] + a] += 1;
    }
  }
  work += 3 * springs_ * n_ + springs_ * springs_ * springs_ / 6;
  return cholesky_factor(springs_, store_.data());
}

/// Appends the rows of V and of the Schur complement G for one more element.
void ContactSystem::add_to_rest(size_t element) noexcept {
  slot_[element] = static_cast<uint32_t>(slots_);
  for (size_t k = 0; k < size(element); ++k, ++slots_) {
    number_[slots_] = static_cast<uint32_t>(place(element) + k);
    const double* of_W = W(number_[slots_]);
    double* of_V = V(slots_);
    for (const uint32_t i : spring_)
      for (uint32_t a = 0; a < was_[i].rank; ++a) of_V[first_[i] + a] = product(was_[i].R[a], size(i), of_W + place(i));
    solve_transposed(springs_, store_.data(), of_V);
    for (size_t other = 0; other <= slots_; ++other)
      G(slots_)[other] = G(other)[slots_] = of_W[number_[other]] - dot(springs_, of_V, V(other));
  }
  work += size(element) * springs_ * (springs_ / 2 + 3 + slots_);
}

/// Builds and factors A = I + R' G S over the elements that bear force and are not in M.
bool ContactSystem::factor_rest() noexcept {
  rest_.clear();
  lines_ = 0;
  size_t next = 0;
  for (uint32_t i = 0; i < elements(); ++i) {
    const bool spring = next < spring_.size() && spring_[next] == i;
    next += spring;
    if (spring || of_[i].rank == 0) continue;
    if (slot_[i] == scene::kNone) add_to_rest(i);
    rest_.push_back(i);
    first_[i] = static_cast<uint32_t>(lines_);
    lines_ += of_[i].rank;
  }
  double* A = A_.data();
  for (const uint32_t i : rest_)
    for (uint32_t a = 0; a < of_[i].rank; ++a, A += lines_) {
      combine(of_[i].R[a], i, G(slot_[i]), n_ - springs_, slots_);
      for (const uint32_t j : rest_)
        for (uint32_t b = 0; b < of_[j].rank; ++b) A[first_[j] + b] = product(of_[j].S[b], size(j), &line_[slot_[j]]);
      A[first_[i] + a] += 1;
    }
  work += 3 * lines_ * (slots_ + lines_) + lines_ * lines_ * lines_ / 3;
  return lu_factor(lines_, A_.data(), pivot_.data());
}

/// Forward substitution through M, the solve with A, and back substitution.
void ContactSystem::solve(const double* b, double* y) noexcept {
  for (const uint32_t i : spring_)
    for (uint32_t a = 0; a < was_[i].rank; ++a) w_[first_[i] + a] = product(was_[i].R[a], size(i), b + place(i));
  solve_transposed(springs_, store_.data(), w_.data());
  for (const uint32_t i : rest_) {
    double left[3] = {};
    for (size_t k = 0; k < size(i); ++k) left[k] = b[place(i) + k] - dot(springs_, V(slot_[i] + k), w_.data());
    for (uint32_t a = 0; a < of_[i].rank; ++a) right_[first_[i] + a] = product(of_[i].R[a], size(i), left);
  }
  lu_solve(lines_, A_.data(), pivot_.data(), right_.data(), s_.data());
  for (const uint32_t i : rest_) {
    Vec3 f = Vec3::Zero();
    for (uint32_t a = 0; a < of_[i].rank; ++a) f += s_[first_[i] + a] * of_[i].S[a];
    for (size_t k = 0; k < size(i); ++k) {
      y[place(i) + k] -= f[index(k)];
      Line(w_.data(), index(springs_)) -= f[index(k)] * ConstLine(V(slot_[i] + k), index(springs_));
    }
  }
  solve_upper(springs_, store_.data(), w_.data());
  for (const uint32_t i : spring_)
    for (uint32_t a = 0; a < was_[i].rank; ++a)
      for (size_t k = 0; k < size(i); ++k) y[place(i) + k] -= w_[first_[i] + a] * was_[i].R[a][index(k)];
  work += springs_ * (springs_ + 2 * slots_) + lines_ * lines_;
}

int ContactSystem::sign() const noexcept { return determinant_sign(lines_, A_.data(), pivot_.data()); }

}  // namespace swage::dynamics
