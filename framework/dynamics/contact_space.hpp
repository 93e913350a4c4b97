// SPDX-License-Identifier: Apache-2.0
//
// An island whose unknowns are the forces y of its constraints, 3 numbers each in frame W, and one torque per hinge drive. Without
// them the blocks would move by d* from the present pose, and the constraints would be at
//
//     v = v* + W y,    v* = u(at) + J d*,    W = J A^-1 J'                      the Delassus operator
//
// and y = f(v) is to be found. W consists of 3 x 3 blocks: the mobility that a flexible body answered, J A^-1 J' for a rigid body.
// With f(v) ~ c - D v and D = S R', with one column per direction in which a constraint resists (0 open, 1 without friction or
// torn, 2 sliding, 3 sticking), Newton's step ends at
//
//     (I + R' W S) s = R' (v* + W c),    y = c - S s,    v = v* + W y                     contact_system.hpp
//
// which is where H d = -F ends (multiply by J A^-1; det H = det A det(I + R' W S)). The merit F' A^-1 F is (y - f)' W (y - f). W
// may be singular: y is unique where f is compliant. c = 0 except for sliding contacts, so that little cancels in v.
//
// A point z is v followed by y; v = v* + W y holds only after a whole step from the start. [rt]; built on [main].
#pragma once

#include <cstdint>
#include <vector>

#include "dynamics/contact_system.hpp"
#include "dynamics/island.hpp"
#include "dynamics/space.hpp"

namespace swage::dynamics {

class ContactSpace final : public Space {
 public:
  /// Reserves for islands of `max_constraints` constraints and `max_hinges` drives; `max_of_bands`: unknowns of all bands.
  ContactSpace(uint32_t max_constraints, uint32_t max_hinges, uint32_t max_of_bands = 0);

  size_t begin(const Island& island) noexcept override;
  bool start(double* z) noexcept override;
  void displace(const double* z) noexcept override;
  void residual(const double* z) noexcept override;
  double merit() noexcept override;
  bool search_direction(const double* z, bool same, double* step) noexcept override;
  int sign() const noexcept override;
  void set_search_direction(const double* step) noexcept override;
  double slope(const double* z, const double* step) noexcept override;
  double length(const double* step) noexcept override;
  double moved(const double* z) noexcept override;
  void finish(const double* z, double* d) noexcept override;

 private:
  /// One side of a constraint on the block that is being added to W.
  struct JacobianBlock {
    uint32_t constraint = 0, point = 0;
    double sign = 1;
    const double* J = nullptr;  // 3 rows of `stride`, in the constraint's axes; unused for a flexible body
    uint32_t stride = 0;
    uint32_t first = 0;  // index of its first column among the unknowns of the block
  };
  /// What is unchanged since the last search direction.
  struct Kept {
    bool stiffness = true, forces = true;  // stiffness of the drives; c
  };

  void collect(uint32_t block) noexcept;
  void add_flexible(const DofBlock& block) noexcept;
  void add_rigid(const DofBlock& block, uint32_t hinge) noexcept;
  void add_banded(const DofBlock& block) noexcept;
  void add_drive(const DofBlock& hinge, size_t at) noexcept;
  double* line(size_t i) noexcept { return W_.data() + i * n_; }
  /// First number of a constraint, or of a drive (after all constraints), in y.
  size_t place(size_t constraint) const noexcept {
    return constraint < n_constraints_ ? 3 * constraint : 2 * n_constraints_ + constraint;
  }
  void apply_delassus(const double* y, double* v) const noexcept;
  void apply_inverse_mass(uint32_t block, const double* y, double* d) noexcept;
  void go(uint32_t block, const double* z, double* d) noexcept;

  Kept linearise(const double* z) noexcept;
  static void split(const Constraint& constraint, ContactSystem::Factors& f) noexcept;
  bool factor() noexcept;
  void solve() noexcept;

  const Island* island_ = nullptr;
  size_t n_constraints_ = 0, n_ = 0;  // n: numbers of y
  bool factored_ = false, solved_ = false;
  ContactSystem system_;
  std::vector<double> W_;
  std::vector<double> free_;  // v*
  std::vector<double> c_, drive_, v_,
      y_;  // of the last direction and its end point; drive_: N m/rad
  std::vector<double> F_, line_;
  std::vector<double> of_block_;  // work space: the unknowns of one block
  std::vector<Vec3> Jt_, Minv_Jt_;  // of the present block, per side and unknown: columns of J' and A^-1 J'
  std::vector<double> products_;    // of the present side with those before it, 12 numbers each
  std::vector<JacobianBlock> arm_;
  std::vector<const DofBlock*> hinge_;
};

}  // namespace swage::dynamics
