// SPDX-License-Identifier: Apache-2.0
//
// An island in the forces y of its rows, 3 numbers each in W, and one per hinge for its drive. Without them the movers would go
// by d* from here, so that the rows stand at
//
//     v = v* + W y,    v* = u(at) + J d*,    W = J A^-1 J'                      the Delassus operator
//
// and y = f(v) is to be found. W is put together from 3 x 3 blocks: of an own solver what it answered, of a body J A^-1 J'. With
// f(v) ~ c - D v and D = S R', of as many columns as directions in which rows push back (0 open, 1 without friction or torn, 2
// sliding, 3 sticking), Newton's step ends at
//
//     (I + R' W S) s = R' (v* + W c),    y = c - S s,    v = v* + W y
//
// which is where H d = -F ends (multiply by J A^-1; det H = det A det(I + R' W S)). The merit F' A^-1 F is (y - f)' W (y - f). W
// may be singular: y is unique where f gives way. Where nothing slips S = R and the system is symmetric, positive definite.
// c = 0 but for what slides, so v hardly cancels.
//
// A point z is v, then y; only after a whole step from the start does v = v* + W y hold. [rt]; built on [main].
#pragma once

#include <cstdint>
#include <vector>

#include "dynamics/island.hpp"
#include "dynamics/space.hpp"

namespace swage::dynamics {

class ContactSpace final : public Space {
 public:
  /// Of islands of so many rows and drives, and of one mover's sides.
  ContactSpace(uint32_t max_rows, uint32_t max_hinges);

  size_t begin(const Island& island) noexcept override;
  bool start(double* z) noexcept override;
  void displace(const double* z) noexcept override;
  void residual(const double* z) noexcept override;
  double merit() noexcept override;
  bool direction(const double* z, bool same, double* step) noexcept override;
  int sign() const noexcept override;
  void aim(const double* step) noexcept override;
  double slope(const double* z, const double* step) noexcept override;
  double length(const double* step) noexcept override;
  double moved(const double* z) noexcept override;
  void finish(const double* z, double* d) noexcept override;

 private:
  /// A side of a row on the mover at hand.
  struct Arm {
    uint32_t row = 0, point = 0;
    double sign = 1;
    const double* J = nullptr;  // 3 lines of `stride`, in the row's axes; of an own solver none
    uint32_t stride = 0;
  };
  /// D = S R' of a row, in W; of a drive the first number of R.
  struct Factors {
    size_t first = 0;  // line of the system
    uint32_t rank = 0;
    bool symmetric = true;
    Vec3 R[3], S[3];
  };
  /// What is as it was in the last direction.
  struct Kept {
    bool stiffness = true, forces = true;  // of the drives; c
  };

  void collect(uint32_t mover) noexcept;
  void add_own(const Mover& mover) noexcept;
  void add_rigid(const Mover& mover, uint32_t hinge) noexcept;
  void add_drive(const Mover& hinge, size_t at) noexcept;
  double* line(size_t i) noexcept { return W_.data() + i * n_; }
  /// Of a row or, after all rows, of a drive, among the numbers of y.
  size_t place(size_t row) const noexcept { return row < rows_ ? 3 * row : 2 * rows_ + row; }
  void spread(const double* y, double* v) const noexcept;
  void respond(uint32_t mover, const double* y, double* d) const noexcept;
  void go(uint32_t mover, const double* z, double* d) const noexcept;

  Kept linearise(const double* z) noexcept;
  static void split(const Row& row, Factors& f) noexcept;
  bool factor() noexcept;
  void fill(size_t row) noexcept;
  void solve() noexcept;

  const Island* island_ = nullptr;
  size_t rows_ = 0, n_ = 0, rank_ = 0;  // n: numbers of y; rank: of the system
  bool factored_ = false, symmetric_ = true, solved_ = false;
  std::vector<double> W_, M_;
  std::vector<double> free_;  // v*
  std::vector<double> c_, drive_, v_,
      y_;  // of the last direction, and where it leads; N m/rad, of the drives
  std::vector<double> F_, s_, right_, line_;
  std::vector<Vec3> lever_, turn_;  // of the mover at hand, per arm and unknown: columns of J' and A^-1 J'
  std::vector<Arm> arm_;
  std::vector<Factors> factors_;
  std::vector<uint32_t> pivot_;
  std::vector<const Mover*> hinge_;
};

}  // namespace swage::dynamics
