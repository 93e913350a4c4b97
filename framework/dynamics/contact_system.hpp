// SPDX-License-Identifier: Apache-2.0
//
// The linear system of a step in contact space (contact_space.hpp),
//
//     (I + R' W S) s = R' b,    D = S R'
//
// with up to three numbers s for each element: a constraint that bears force, or the drive of a hinge. From one search direction to the
// next only elements change that slip or come to another piece of their law; the others are springs, R = S. Their part is factored
// anew only when one of the springs changes,
//
//     M = I + R_k' W R_k = U' U,    V = U'^-1 R_k' W_ke
//
// and the other elements each time, with the Schur complement G as their Delassus operator:
//
//     A = I + R_e' G S_e,    G = W_ee - V' V
//
// det M > 0, so that the sign of the determinant is that of det A. Why: of 28 constraints of a thread wound round jaws 16 stick, and
// a solve has seven search directions on average; A has 18 rows where the whole has 75. [rt]; built on [main].
#pragma once

#include <cstdint>
#include <vector>

#include "toolkit/math.hpp"

namespace swage::dynamics {

using toolkit::Vec3;

class ContactSystem {
 public:
  /// Factors of D = S R' of an element, in frame W; a drive uses the first number of R = S only.
  struct Factors {
    uint32_t rank = 0;
    bool spring = false;  // R = S, constant on its piece of the law
    Vec3 R[3], S[3];
  };

  ContactSystem(uint32_t max_constraints, uint32_t max_drives);

  /// Sets W: symmetric, n x n, with 3 numbers per constraint and then one per drive. It is not copied, but read until the next begin().
  void begin(const double* W, size_t constraints, size_t drives) noexcept;
  /// Factors of a constraint, or of a drive (counted after all constraints); to be filled before factor().
  Factors& of(size_t element) noexcept { return of_[element]; }
  /// False where the system is singular or not finite.
  bool factor() noexcept;
  /// Solves for s with the right-hand side R' b and subtracts S s from y; n numbers each.
  void solve(const double* b, double* y) noexcept;
  /// Sign of the determinant.
  int sign() const noexcept;

  /// Multiply-adds since it was last set to 0.
  uint64_t work = 0;

 private:
  size_t elements() const noexcept { return constraints_ + drives_; }
  size_t size(size_t element) const noexcept { return element < constraints_ ? 3 : 1; }
  /// Index of the element's first number in W.
  size_t place(size_t element) const noexcept { return element < constraints_ ? 3 * element : 2 * constraints_ + element; }
  const double* W(size_t number) const noexcept { return W_ + number * n_; }
  double* V(size_t slot) noexcept { return store_.data() + (springs_ + slot) * springs_; }
  double* G(size_t slot) noexcept { return store_.data() + n_ * springs_ + slot * (n_ - springs_); }
  void combine(const Vec3& R, size_t element, const double* from, size_t stride, size_t length) noexcept;

  bool springs_hold() noexcept;
  bool factor_springs() noexcept;
  void add_to_rest(size_t element) noexcept;
  bool factor_rest() noexcept;

  const double* W_ = nullptr;
  size_t constraints_ = 0, drives_ = 0, n_ = 0;
  size_t springs_ = 0, slots_ = 0, lines_ = 0;  // rows of M, G and A
  bool ready_ = false;                          // M is factored
  std::vector<Factors> of_, was_;               // was_: of the springs in M
  std::vector<uint8_t> left_;                   // per element: has ceased to be a spring
  std::vector<uint32_t> spring_, rest_;         // elements of M; of A
  std::vector<uint32_t> first_, slot_;          // per element: its first row in M or A, in G
  std::vector<uint32_t> number_;                // per row of G: its number in W
  std::vector<double> store_;                   // U, then V row by row, then G: n^2 numbers at most
  std::vector<double> A_, line_, w_, right_, s_;
  std::vector<uint32_t> pivot_;
};

}  // namespace swage::dynamics
