/* SPDX-License-Identifier: Apache-2.0 */
/* makes itself a buffer in every step, and gives it back */
#include <swage/abi/object.h>
static swage_result forces(swage_instance* instance, const swage_object_step* step);
#define BALL_ID "org.example.bad.allocates"
#define BALL_FORCES forces
#include "ball.h"
static swage_result forces(swage_instance* instance, const swage_object_step* step) {
  volatile double* buffer = (volatile double*)malloc(64 * sizeof(double));
  (void)instance;
  if (buffer == NULL) return SWAGE_ERROR;
  buffer[0] = step->time_s;
  step->F_B_W[0].f.x += 0 * buffer[0];
  free((void*)buffer);
  return SWAGE_OK;
}
