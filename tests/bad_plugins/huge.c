/* SPDX-License-Identifier: Apache-2.0 */
/* forgets that newtons are not micronewtons */
#include <swage/abi/object.h>
static swage_result forces(swage_instance* instance, const swage_object_step* step);
#define BALL_ID "org.example.bad.huge"
#define BALL_FORCES forces
#include "ball.h"
static swage_result forces(swage_instance* instance, const swage_object_step* step) {
  (void)instance;
  if (step->step >= BALL_GOOD_STEPS) step->F_B_W[0].f.z = 1e12;
  return SWAGE_OK;
}
