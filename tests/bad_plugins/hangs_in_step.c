/* SPDX-License-Identifier: Apache-2.0 */
/* waits for something that never comes, in the middle of a step */
#include <swage/abi/object.h>
#include <unistd.h>
static swage_result forces(swage_instance* instance, const swage_object_step* step);
#define BALL_ID "org.example.bad.hangs_in_step"
#define BALL_FORCES forces
#include "ball.h"
static swage_result forces(swage_instance* instance, const swage_object_step* step) {
  (void)instance;
  while (step->step >= BALL_GOOD_STEPS) pause();
  return SWAGE_OK;
}
