// SPDX-License-Identifier: Apache-2.0
//
// A lesson for the other hand. Mechanics does not know left from right, so the scene is computed as the file says and only
// what crosses its border is reflected in the plane x = 0 of the world: what hands do on the way in, what is shown and felt
// on the way out. M = diag(-1, 1, 1) reflects points; a frame keeps being right-handed because its own y (or, of a shape, z)
// is reflected too: R' = M R diag(1, -1, 1). Reflecting twice changes nothing. Header-only, [any].
#pragma once

#include "toolkit/math.hpp"

namespace swage::toolkit {

/// Points, velocities, forces [any unit].
inline swage_vec3 mirrored(const swage_vec3& a) { return {-a.x, a.y, a.z}; }
/// Angular velocities and torques: the other way round.
inline swage_vec3 mirrored_axial(const swage_vec3& a) { return {a.x, -a.y, -a.z}; }

/// X_WB of a body or tool whose frame is reflected in its own y: M R diag(1, -1, 1) is the quaternion i q j.
inline swage_pose mirrored(const swage_pose& X) { return {mirrored(X.p), {X.q.z, -X.q.y, -X.q.x, X.q.w}}; }

/// X_BS of a shape of such a body: its own z is reflected, which no sphere, capsule, cylinder or arc notices and a convex
/// one makes up for with its vertices: diag(1, -1, 1) R diag(1, 1, -1) is j q k.
inline swage_pose mirrored_shape(const swage_pose& X) {
  return {{X.p.x, -X.p.y, X.p.z}, {X.q.x, X.q.w, -X.q.z, -X.q.y}};
}

/// q_WC of a view, whose right is left: M R M is i q i, up to its sign.
inline swage_quat mirrored_view(const swage_quat& q) { return {q.w, q.x, -q.y, -q.z}; }

}  // namespace swage::toolkit
