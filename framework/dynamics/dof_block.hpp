// SPDX-License-Identifier: Apache-2.0
//
// A block of degrees of freedom: a rigid body, a hinge, a particle, a band, or a flexible body. To the solve all are alike:
// unknowns x, inertia A = M / h^2, a force A (x - x_hat) that contacts must balance, and for a hinge the torque of its drive.
// Unknowns count from the pose at which the geometry was last evaluated.
//
// Threads: [rt], nothing allocates.
#pragma once

#include <cstdint>

#include "dynamics/banded_body.hpp"
#include "dynamics/hinge_drive.hpp"
#include "dynamics/rotation.hpp"

namespace swage::dynamics {

/// The answer of a flexible body about its points: their displacement is the free one plus h^2 W f.
struct PointMobility {
  const double* W = nullptr;      // m/s per N s, stride x stride, row-major
  const double* extra = nullptr;  // m, displacement beyond the free one; stride
  size_t stride = 0;
  double hh = 0;  // s2
};

struct DofBlock {
  enum class Kind : uint8_t { kRigid, kHinge, kParticle, kFlexible, kBanded };
  Kind kind = Kind::kRigid;
  uint32_t index = 0;            // body, hinge, particle of the world, or place among the flexible bodies
  uint32_t size = 6;             // number of unknowns; kFlexible: 0, its points answer instead (contact_space.hpp)
  uint32_t offset = 0;           // of its first unknown in the island
  double m_hh = 0;               // N/m, mass / h^2
  Mat3 I_hh = Mat3::Zero();      // N m / rad, inertia in W over h^2
  Mat3 inv_I_hh = Mat3::Zero();  // its inverse
  HingeDrive drive;
  double stiffness = 0;  // N m/rad, of the drive, in the last system

  Vec3 x = Vec3::Zero();  // m, from the pose without contacts
  Vec3 a = Vec3::Zero();  // rad, rotation over the step
  // N m, L0 / h + t: angular momentum at the start, and torque. Momentum is balanced, not angular velocity: that of a thin wire may
  // be almost all spin about its own axis, which says little about the rest of the momentum
  Vec3 b = Vec3::Zero();
  double angle = 0;                                 // kHinge: x itself [rad], not relative to x_hat
  Vec3 axis = Vec3::Zero(), anchor = Vec3::Zero();  // kHinge: in W
  PointMobility own;                                // kFlexible
  BandedBody* band = nullptr;                       // kBanded

  /// F = A (x + d - x_hat) - t(x + d): forces that contacts must balance. Writes `size` numbers at F.
  void residual(const double* d, double* F) const noexcept {
    switch (kind) {
      case Kind::kRigid: {
        const Vec3 f = m_hh * (x + Vec3(d[0], d[1], d[2])), t = I_hh * (a + Vec3(d[3], d[4], d[5])) - b;
        for (int i = 0; i < 3; ++i) F[i] = f[i], F[3 + i] = t[i];
        break;
      }
      case Kind::kHinge:
        F[0] = drive.inertia_hh * (angle + d[0] - drive.x_hat) - drive.torque(angle + d[0]);
        break;
      case Kind::kParticle:
        for (int i = 0; i < 3; ++i) F[i] = m_hh * (x[i] + d[i]);
        break;
      case Kind::kBanded:
        band->residual(d, F);
        break;
      case Kind::kFlexible:
        break;
    }
  }

  /// Step from the present pose to the pose without contacts; for a hinge without its drive.
  void to_free(double* d) const noexcept {
    if (kind == Kind::kBanded) return band->to_free(d);
    if (kind == Kind::kHinge) {
      d[0] = drive.x_hat - angle;
      return;
    }
    for (int i = 0; i < 3; ++i) d[i] = -x[i];
    if (kind != Kind::kRigid) return;
    const Vec3 turn = inv_I_hh * b - a;
    for (int i = 0; i < 3; ++i) d[3 + i] = turn[i];
  }

  /// A^-1 F.
  void apply_inverse_mass(const double* F, double* d) const noexcept {
    if (kind == Kind::kBanded) return band->apply_inverse(F, d);
    if (kind == Kind::kHinge) {
      d[0] = F[0] / drive.inertia_hh;
      return;
    }
    for (int i = 0; i < 3; ++i) d[i] = F[i] / m_hh;
    if (kind != Kind::kRigid) return;
    const Vec3 turn = inv_I_hh * Vec3(F[3], F[4], F[5]);
    for (int i = 0; i < 3; ++i) d[3 + i] = turn[i];
  }

  /// Updates the stiffness of the drive to that at a displacement of its hinge. True when it was the same.
  bool update_drive(double d) noexcept {
    if (kind != Kind::kHinge) return true;
    const double was = stiffness;
    return (stiffness = drive.stiffness(angle + d)) == was;
  }

  /// Adds dF/dd to the island's matrix H (n x n, row-major). Not for a band (sparse_space.hpp).
  void add_stiffness(const double* d, size_t n, double* H) const noexcept {
    double* at = H + offset * n + offset;
    for (uint32_t i = 0; i < size; ++i) at[i * n + i] += m_hh;
    if (kind == Kind::kHinge) at[0] += drive.stiffness(angle + d[0]);
    if (kind != Kind::kRigid) return;
    for (uint32_t i = 0; i < 3; ++i) {
      at[(3 + i) * n + 3 + i] -= m_hh;
      for (uint32_t j = 0; j < 3; ++j) at[(3 + i) * n + 3 + j] += I_hh(i, j);
    }
  }

  /// F' A^-1 F: twice the kinetic energy that the unbalanced impulse h F would give [J].
  double merit(const double* F) const noexcept {
    if (kind == Kind::kRigid) {
      const Vec3 f(F[0], F[1], F[2]), t(F[3], F[4], F[5]);
      return f.squaredNorm() / m_hh + t.dot(inv_I_hh * t);
    }
    if (kind == Kind::kBanded) return band->merit(F);
    double sum = 0;
    for (uint32_t i = 0; i < size; ++i) sum += F[i] * F[i];
    return sum / m_hh;
  }

  /// Displacement of the centre [m]; 0 for hinges and bands. Rotations and bands are measured at the contacts.
  double length(const double* d) const noexcept {
    if (kind != Kind::kRigid && kind != Kind::kParticle) return 0;
    return std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
  }
};

}  // namespace swage::dynamics
