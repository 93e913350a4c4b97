// SPDX-License-Identifier: Apache-2.0
//
// A lesson for the other hand. Mechanics is symmetric under reflection, so the scene is computed as the file says and only
// its inputs and outputs are reflected in the plane x = 0 of the world: the motion of the hands, and the picture and
// forces that go back. M = diag(-1, 1, 1) reflects points; a frame stays right-handed because its own y (or, of a shape, z)
// is reflected too: R' = M R diag(1, -1, 1). Reflecting twice changes nothing. Header-only, [any].
#pragma once

#include "toolkit/math.hpp"

namespace swage::toolkit {

/// Points, velocities, forces [any unit].
inline swage_vec3 mirrored(const swage_vec3& a) { return {-a.x, a.y, a.z}; }
/// Angular velocities and torques, which are axial vectors.
inline swage_vec3 mirrored_axial(const swage_vec3& a) { return {a.x, -a.y, -a.z}; }

/// X_WB of a body or tool whose frame is reflected in its own y: M R diag(1, -1, 1) is the quaternion i q j.
inline swage_pose mirrored(const swage_pose& X) { return {mirrored(X.p), {X.q.z, -X.q.y, -X.q.x, X.q.w}}; }

/// X_BS of a shape of such a body: its own z is reflected, which leaves spheres, capsules, cylinders and arcs unchanged and for
/// which a convex shape must reflect its vertices: diag(1, -1, 1) R diag(1, 1, -1) is j q k.
inline swage_pose mirrored_shape(const swage_pose& X) {
  return {{X.p.x, -X.p.y, X.p.z}, {X.q.x, X.q.w, -X.q.z, -X.q.y}};
}

/// q_WC of a reflected view: M R M is i q i, up to its sign.
inline swage_quat mirrored_view(const swage_quat& q) { return {q.w, q.x, -q.y, -q.z}; }

}  // namespace swage::toolkit
