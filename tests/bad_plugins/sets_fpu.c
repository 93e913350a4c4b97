/* SPDX-License-Identifier: Apache-2.0 */
/* turns subnormal numbers off while it steps */
#include <swage/abi/object.h>
#if defined(__x86_64__)
#include <xmmintrin.h>
#endif
static swage_result forces(swage_instance* instance, const swage_object_step* step);
#define BALL_ID "org.example.bad.sets_fpu"
#define BALL_FORCES forces
#include "ball.h"
static swage_result forces(swage_instance* instance, const swage_object_step* step) {
  (void)instance;
#if defined(__x86_64__)
  if (step->step >= BALL_GOOD_STEPS) _mm_setcsr(_mm_getcsr() | 0x8040u);
#else
  (void)step;
#endif
  return SWAGE_OK;
}
