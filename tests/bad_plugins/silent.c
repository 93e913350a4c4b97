/* SPDX-License-Identifier: Apache-2.0 */
/* refuses and does not say why */
#include <swage/abi/object.h>
static swage_result configure(swage_instance* instance, const swage_values* values, swage_builder* builder) {
  (void)instance;
  (void)values;
  (void)builder;
  return SWAGE_ERROR;
}
#define BALL_ID "org.example.bad.silent"
#define BALL_CONFIGURE configure
#include "ball.h"
