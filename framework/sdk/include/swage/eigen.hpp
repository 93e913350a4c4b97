// SPDX-License-Identifier: Apache-2.0
//
// The boundary's plain structs seen through Eigen. The only header of the wrapper that needs Eigen.
//
// vec() of an lvalue is a map: writing to it writes to the host's array. Maps are unaligned, so the instruction
// set that a plugin is compiled for does not matter. Quaternions are copied: the boundary's order is w x y z,
// Eigen's x y z w.
#pragma once

#include <swage/abi/base.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace swage {

using Vec3Map = Eigen::Map<Eigen::Vector3d>;
using ConstVec3Map = Eigen::Map<const Eigen::Vector3d>;

inline Vec3Map vec(swage_vec3& v) { return Vec3Map(&v.x); }
inline ConstVec3Map vec(const swage_vec3& v) { return ConstVec3Map(&v.x); }
Eigen::Vector3d vec(const swage_vec3&& v) = delete;  // would dangle: name the value first

/// Three doubles of an interleaved array, e.g. vec(step->particle_p_W, i).
inline Vec3Map vec(double* interleaved, size_t i = 0) { return Vec3Map(interleaved + 3 * i); }
inline ConstVec3Map vec(const double* interleaved, size_t i = 0) { return ConstVec3Map(interleaved + 3 * i); }

inline Eigen::Quaterniond quat(const swage_quat& q) { return {q.w, q.x, q.y, q.z}; }

/// p_A = X_AB p_B.
inline Eigen::Vector3d transform(const swage_pose& X_AB, const Eigen::Vector3d& p_B) {
  return vec(X_AB.p) + quat(X_AB.q) * p_B;
}

/// Conversions to the boundary's structs.
inline swage_vec3 abi(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
inline swage_quat abi(const Eigen::Quaterniond& q) { return {q.w(), q.x(), q.y(), q.z()}; }
inline swage_pose abi(const Eigen::Vector3d& p, const Eigen::Quaterniond& q) { return {abi(p), abi(q)}; }

}  // namespace swage
