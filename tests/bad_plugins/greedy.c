/* SPDX-License-Identifier: Apache-2.0 */
/* declares more than a scene can hold, and private numbers by the billion */
#include <swage/abi/object.h>
static swage_result configure(swage_instance* instance, const swage_values* values, swage_builder* builder) {
  const swage_pose start = {{0, 0, 0}, {1, 0, 0, 0}};
  int i;
  (void)instance;
  (void)values;
  for (i = 0; i < 65; ++i) builder->body(builder, SWAGE_MOTION_FIXED, &start, 0, "one");
  builder->state(builder, 0x7FFFFFFFu);
  return SWAGE_OK;
}
#define BALL_ID "org.example.bad.greedy"
#define BALL_CONFIGURE configure
#include "ball.h"
