// SPDX-License-Identifier: Apache-2.0
//
// Conversions between the plain structs of the ABI and Eigen, and the usual rotations. Header-only.
#pragma once

#include <swage/abi/base.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

namespace swage::toolkit {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;

inline Vec3 vec(const swage_vec3& a) { return {a.x, a.y, a.z}; }
inline Quat quat(const swage_quat& q) { return {q.w, q.x, q.y, q.z}; }
inline swage_vec3 raw(const Vec3& a) { return {a.x(), a.y(), a.z()}; }
inline swage_quat raw(const Quat& q) { return {q.w(), q.x(), q.y(), q.z()}; }

/// q v by Eigen's formula, same operations in the same order, inlined: Eigen's own is a call wherever it is used.
inline Vec3 rotated(const Quat& q, const Vec3& v) {
  const Vec3 u = q.vec();
  Vec3 uv = u.cross(v);
  uv += uv;
  return v + q.w() * uv + u.cross(uv);
}

/// X_AB: p_A = p + q p_B.
struct Pose {
  Vec3 p = Vec3::Zero();  // m
  Quat q = Quat::Identity();

  Pose() = default;
  Pose(const Vec3& position, const Quat& rotation) : p(position), q(rotation) {}
  explicit Pose(const swage_pose& raw_pose) : p(vec(raw_pose.p)), q(quat(raw_pose.q)) {}

  Vec3 operator*(const Vec3& p_B) const { return p + rotated(q, p_B); }
  Pose operator*(const Pose& X_BC) const { return {p + rotated(q, X_BC.p), q * X_BC.q}; }
  Pose inverse() const {
    const Quat qi = q.conjugate();
    return {rotated(qi, -p), qi};
  }
  swage_pose abi() const { return {raw(p), raw(q)}; }
};

/// A Pose with its rotation as a matrix: cheaper when many points are carried over.
struct Frame {
  Vec3 p = Vec3::Zero();  // m
  Mat3 R = Mat3::Identity();

  Frame() = default;
  Frame(const Vec3& position, const Mat3& rotation) : p(position), R(rotation) {}
  explicit Frame(const Pose& pose) : p(pose.p), R(pose.q.toRotationMatrix()) {}
  explicit Frame(const swage_pose& raw_pose) : Frame(Pose(raw_pose)) {}

  Vec3 operator*(const Vec3& p_B) const { return p + turn(p_B); }
  Frame operator*(const Frame& X_BC) const { return {*this * X_BC.p, R * X_BC.R}; }
  /// X_BA * X_AC without forming the inverse.
  Frame inverse_times(const Frame& X_AC) const {
    Frame X_BC;
    X_BC.p = turn_back(X_AC.p - p);
    for (int i = 0; i < 3; ++i) X_BC.R.col(i) = turn_back(X_AC.R.col(i));
    return X_BC;
  }
  Vec3 inverse_times(const Vec3& p_A) const { return turn_back(p_A - p); }

  // products with the matrix, column by column: compilers generate slower code for Eigen's general product. Inlined everywhere: a call
  // costs as much as the product, and there are a dozen in one query of a needle against a jaw
  [[gnu::always_inline]] Vec3 turn(const Vec3& v_B) const { return v_B.x() * R.col(0) + v_B.y() * R.col(1) + v_B.z() * R.col(2); }
  [[gnu::always_inline]] Vec3 turn_back(const Vec3& v_A) const { return {R.col(0).dot(v_A), R.col(1).dot(v_A), R.col(2).dot(v_A)}; }
};

/// Unit quaternion of the rotation vector `a` [rad]: exact exponential, smooth through zero.
inline Quat exp_rotation(const Vec3& a) {
  const double angle = a.norm();
  const double half = 0.5 * angle;
  // sin(half)/angle by its series below 1e-4 rad, where the relative error of the series is under 1e-17
  const double k = angle < 1e-4 ? 0.5 - angle * angle / 48.0 : std::sin(half) / angle;
  return {std::cos(half), k * a.x(), k * a.y(), k * a.z()};
}

/// Rotation vector [rad] of a unit quaternion, in (-pi, pi]; accurate for slow rotations (no acos).
inline Vec3 log_rotation(const Quat& q) {
  const double sign = q.w() < 0 ? -1.0 : 1.0;
  const Vec3 v = sign * q.vec();
  const double s = v.norm();
  const double k = s < 1e-8 ? 2.0 : 2.0 * std::atan2(s, sign * q.w()) / s;
  return k * v;
}

inline Mat3 skew(const Vec3& a) {
  Mat3 m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

}  // namespace swage::toolkit
