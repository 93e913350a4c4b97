/* SPDX-License-Identifier: Apache-2.0 */
/* writes where nothing is */
#include <swage/abi/object.h>
static swage_result forces(swage_instance* instance, const swage_object_step* step);
#define BALL_ID "org.example.bad.crashes_in_step"
#define BALL_FORCES forces
#include "ball.h"
static int* volatile nowhere;
static swage_result forces(swage_instance* instance, const swage_object_step* step) {
  (void)instance;
  if (step->step >= BALL_GOOD_STEPS) *nowhere = 1;
  return SWAGE_OK;
}
