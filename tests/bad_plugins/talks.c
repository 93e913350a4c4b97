/* SPDX-License-Identifier: Apache-2.0 */
/* writes texts in the middle of a step */
#include <swage/abi/object.h>
static swage_result forces(swage_instance* instance, const swage_object_step* step);
#define BALL_ID "org.example.bad.talks"
#define BALL_FORCES forces
#include "ball.h"
static swage_result forces(swage_instance* instance, const swage_object_step* step) {
  const ball* self = (const ball*)instance->self;
  const swage_str where = {"", 0}, message = {"I step!", 7};
  (void)step;
  self->host->report(self->host, SWAGE_NOTE, where, message);
  return SWAGE_OK;
}
