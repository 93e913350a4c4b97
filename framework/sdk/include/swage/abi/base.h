/* SPDX-License-Identifier: Apache-2.0
 *
 * swage/abi/base.h - the scalars, vectors and results that cross the boundary between host and plugin.
 *
 * Conventions of the whole boundary:
 *   - SI units; world frame W right-handed with +Z up; quaternions w x y z, unit, Hamilton.
 *   - X_WB is the pose of frame B in frame W: p_W = X_WB.p + rotate(X_WB.q, p_B).
 *   - Only the types below, sized integers and pointers to them cross. No ownership crosses: the side that creates an object destroys it.
 *   - Each function is tagged with the thread role that may call it:
 *       [main] session thread, may allocate, read files and report text
 *       [rt]   the step, once per millisecond: no allocation, lock, I/O, throw or log
 *       [io]   one host-made thread per device, may block on a driver
 *       [any]  all of them
 *     A role is a promise about concurrency (one caller at a time per instance), not one operating-system thread.
 */
#ifndef SWAGE_ABI_BASE_H
#define SWAGE_ABI_BASE_H

#include <stdint.h>

#ifdef __cplusplus
#define SWAGE_STATIC_ASSERT(cond, text) static_assert(cond, text)
#else
#define SWAGE_STATIC_ASSERT(cond, text) _Static_assert(cond, text)
#endif

/* A host loads a plugin when the majors agree and the plugin's minor is not newer than the host's. */
#define SWAGE_ABI_MAJOR 1u
#define SWAGE_ABI_MINOR 0u

/* Results: zero and above is success. */
typedef int32_t swage_result;
#define SWAGE_OK 0
#define SWAGE_DISCARD 1  /* this step's contribution is void; carry on */
#define SWAGE_ERROR (-1) /* the instance asks to be quarantined */
#define SWAGE_FAULT (-2) /* the wrapper stopped an exception; the host quarantines */

/* Codes of swage_host.fault: a plugin's own are 0 and above; the C++ wrapper's are below 0, with a: index of the entry. */
#define SWAGE_FAULT_THROWN (-1) /* an exception was stopped */
#define SWAGE_FAULT_THREAD (-2) /* called from the wrong thread; b: the SWAGE_THREAD_* that called */
#define SWAGE_FAULT_ORDER (-3)  /* called out of order, e.g. a step before activate */

/* Severities of swage_host.report. */
#define SWAGE_NOTE 0
#define SWAGE_WARNING 1
#define SWAGE_SEVERE 2

/* Thread roles, as swage_host.thread_kind returns them. */
#define SWAGE_THREAD_MAIN 1
#define SWAGE_THREAD_RT 2
#define SWAGE_THREAD_IO 3

typedef struct swage_vec3 {
  double x, y, z;
} swage_vec3;

typedef struct swage_quat {
  double w, x, y, z;
} swage_quat;

/* X_AB: frame B seen from frame A. */
typedef struct swage_pose {
  swage_vec3 p; /* m */
  swage_quat q;
} swage_pose;

/* Velocity of the origin of a frame [m/s] and its angular velocity [rad/s], both expressed in W. */
typedef struct swage_twist {
  swage_vec3 v, w;
} swage_twist;

/* Force [N] and torque about the origin of a frame [N m], both expressed in W. */
typedef struct swage_wrench {
  swage_vec3 f, t;
} swage_wrench;

/* UTF-8, not terminated, valid for the call only. */
typedef struct swage_str {
  const char* data;
  uint64_t size;
} swage_str;

SWAGE_STATIC_ASSERT(sizeof(swage_vec3) == 24, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_quat) == 32, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_pose) == 56, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_twist) == 48, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_wrench) == 48, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_str) == 16, "frozen layout");

#endif
