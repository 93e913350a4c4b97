/* SPDX-License-Identifier: Apache-2.0 */
/* keeps what belongs into the host's state: a rewind does not rewind it */
#include <swage/abi/object.h>
static swage_result forces(swage_instance* instance, const swage_object_step* step);
#define BALL_ID "org.example.bad.remembers"
#define BALL_FORCES forces
#include "ball.h"
static swage_result forces(swage_instance* instance, const swage_object_step* step) {
  static double calls;
  (void)instance;
  step->F_B_W[0].f.x += 1e-9 * ++calls;
  return SWAGE_OK;
}
