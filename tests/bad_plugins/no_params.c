/* SPDX-License-Identifier: Apache-2.0 */
/* has no parameters and no factory for them: that is allowed */
#include <swage/abi/object.h>
static const void* factories(const char* id);
static uint32_t configured_body(swage_builder* builder);
static swage_result configure(swage_instance* instance, const swage_values* values, swage_builder* builder) {
  (void)instance;
  return values->count == 0 && configured_body(builder) == 0 ? SWAGE_OK : SWAGE_ERROR;
}
static const swage_param nothing[1];
#define BALL_ID "org.example.bad.no_params"
#define BALL_CONFIGURE configure
#define BALL_FACTORIES factories
#define BALL_PARAMS nothing
#include "ball.h"
static uint32_t configured_body(swage_builder* builder) {
  const swage_pose start = {{0, 0, 0}, {1, 0, 0, 0}};
  (void)nothing;
  return builder->body(builder, SWAGE_MOTION_FIXED, &start, NULL, "ball");
}
static const char* const traits[] = {SWAGE_TRAIT_SOLID, NULL};
static const swage_descriptor descriptor = {
    sizeof(swage_descriptor), SWAGE_KIND_OBJECT, BALL_ID,      "1.0.0", "Ball",
    "A ball that stays.",     "Swage",           "Apache-2.0", traits};
static uint32_t count(void) { return 1; }
static const swage_descriptor* describe(uint32_t index) { return index == 0 ? &descriptor : NULL; }
static const void* factories(const char* id) {
  static const swage_factory factory = {count, describe, BALL_CREATE};
  return strcmp(id, SWAGE_FACTORY_INSTANCES) == 0 ? &factory : NULL;
}
