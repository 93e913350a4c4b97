// SPDX-License-Identifier: Apache-2.0
// throws, without the wrapper that would stop it
#include <stdexcept>

#include <swage/abi/object.h>

extern "C" {
static swage_result forces(swage_instance* instance, const swage_object_step* step);
}
#define BALL_ID "org.example.bad.throws"
#define BALL_FORCES forces
#include "ball.h"

static swage_result forces(swage_instance*, const swage_object_step* step) {
  if (step->step >= BALL_GOOD_STEPS) throw std::runtime_error("no");
  return SWAGE_OK;
}
