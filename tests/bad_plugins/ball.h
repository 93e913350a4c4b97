/* SPDX-License-Identifier: Apache-2.0
 *
 * A well-behaved ball in plain C, against the ABI and without the wrapper, which would hide the faults.
 * A bad plugin defines what it does differently and includes this file last:
 *
 *   BALL_ID         "org.example.bad.nan" (needed)
 *   BALL_FORCES     function instead of ball_forces
 *   BALL_CONFIGURE  function instead of ball_configure
 *   BALL_CREATE     function instead of ball_create
 *   BALL_FACTORIES  function instead of ball_get_factory
 *   BALL_TRAITS     that its descriptor lists, instead of solid
 *   BALL_PARAMS     its table, an array, instead of { radius }
 *   BALL_MAJOR, BALL_MINOR  of the ABI it says it was built for
 */
#ifndef BALL_H
#define BALL_H

#include <stdlib.h>
#include <string.h>

#include <swage/abi/object.h>

/* steps that a ball behaves well before it does what it is here for */
#define BALL_GOOD_STEPS 10u

#ifndef BALL_MAJOR
#define BALL_MAJOR SWAGE_ABI_MAJOR
#endif
#ifndef BALL_MINOR
#define BALL_MINOR SWAGE_ABI_MINOR
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef struct ball {
  swage_instance raw;
  const swage_host* host;
  int configured;
} ball;

#ifndef BALL_PARAMS
static const swage_param ball_params[] = {{sizeof(swage_param),
                                           SWAGE_PARAM_REAL,
                                           0,
                                           1,
                                           "radius",
                                           "Radius",
                                           "",
                                           "m",
                                           "mm",
                                           "Of the ball.",
                                           NULL,
                                           NULL,
                                           NULL,
                                           0.1e-3,
                                           10e-3,
                                           {1e-3, 0, 0, 0}}};
#define BALL_PARAMS ball_params
#define BALL_OWN_PARAMS
#endif

#ifndef BALL_CONFIGURE
static swage_result ball_configure(swage_instance* instance, const swage_values* values,
                                   swage_builder* builder) {
  const swage_pose start = {{0, 0, 0}, {1, 0, 0, 0}};
  const swage_mass mass = {1e-6, {4e-13, 4e-13, 4e-13}};
  uint32_t body;
  double radius = 1e-3;
  (void)instance;
#ifdef BALL_OWN_PARAMS
  radius = values->value[0].number[0];
#else
  (void)values;
#endif
  body = builder->body(builder, SWAGE_MOTION_DYNAMIC, &start, &mass, "ball");
  builder->sphere(builder, body, start.p, radius, SWAGE_SHAPE_USUAL);
  builder->state(builder, 1);
  return SWAGE_OK;
}
#define BALL_CONFIGURE ball_configure
#endif

static swage_result ball_configure_once(swage_instance* instance, const swage_values* values,
                                        swage_builder* builder) {
  const swage_result result = BALL_CONFIGURE(instance, values, builder);
  ((ball*)instance->self)->configured = result >= 0;
  return result;
}
static swage_result ball_activate(swage_instance* instance, double dt_s) {
  (void)dt_s;
  return ((const ball*)instance->self)->configured ? SWAGE_OK : SWAGE_ERROR;
}
static void ball_deactivate(swage_instance* instance) { (void)instance; }
static void ball_destroy(swage_instance* instance) { free(instance->self); }

#ifndef BALL_FORCES
static swage_result ball_forces(swage_instance* instance, const swage_object_step* step) {
  (void)instance;
  (void)step;
  return SWAGE_OK;
}
#define BALL_FORCES ball_forces
#endif
static swage_result ball_finish(swage_instance* instance, const swage_object_step* step) {
  (void)instance;
  if (step->n_state > 0) step->state[0] += 1;
  return SWAGE_OK;
}
static void ball_reset(swage_instance* instance, const swage_object_step* step) {
  (void)instance;
  if (step->n_state > 0) step->state[0] = 0;
}

static const void* ball_extension(swage_instance* instance, const char* id) {
  static const swage_object object = {BALL_FORCES, ball_finish, ball_reset};
  static const int promise = 1;
  (void)instance;
  if (strcmp(id, SWAGE_EXT_OBJECT) == 0) return &object;
  if (strcmp(id, SWAGE_TRAIT_SOLID) == 0) return &promise;
  return NULL;
}

static swage_instance* ball_make(const swage_host* host) {
  ball* made = (ball*)calloc(1, sizeof(ball));
  if (made == NULL) return NULL;
  made->host = host;
  made->raw.self = made;
  made->raw.configure = ball_configure_once;
  made->raw.activate = ball_activate;
  made->raw.deactivate = ball_deactivate;
  made->raw.destroy = ball_destroy;
  made->raw.get_extension = ball_extension;
  return &made->raw;
}
#ifndef BALL_CREATE
static swage_instance* ball_create(const swage_host* host, const char* id) {
  return strcmp(id, BALL_ID) == 0 ? ball_make(host) : NULL;
}
#define BALL_CREATE ball_create
#endif

#ifndef BALL_FACTORIES
#ifndef BALL_TRAITS
#define BALL_TRAITS SWAGE_TRAIT_SOLID
#endif
static const char* const ball_traits[] = {BALL_TRAITS, NULL};
static const swage_descriptor ball_descriptor = {
    sizeof(swage_descriptor), SWAGE_KIND_OBJECT, BALL_ID,      "1.0.0",    "Ball",
    "A ball that falls.",     "Swage",           "Apache-2.0", ball_traits};
static uint32_t ball_count(void) { return 1; }
static const swage_descriptor* ball_describe(uint32_t index) { return index == 0 ? &ball_descriptor : NULL; }
static const swage_param* ball_table(const char* id, uint32_t* count) {
  *count = strcmp(id, BALL_ID) == 0 ? (uint32_t)(sizeof(BALL_PARAMS) / sizeof(BALL_PARAMS[0])) : 0;
  return *count > 0 ? BALL_PARAMS : NULL;
}
static const void* ball_get_factory(const char* id) {
  static const swage_factory factory = {ball_count, ball_describe, BALL_CREATE};
  static const swage_param_factory params = {ball_table};
  if (strcmp(id, SWAGE_FACTORY_INSTANCES) == 0) return &factory;
  if (strcmp(id, SWAGE_FACTORY_PARAMS) == 0) return &params;
  return NULL;
}
#define BALL_FACTORIES ball_get_factory
#endif

__attribute__((visibility("default"))) extern const swage_entry swage_plugin_entry;
const swage_entry swage_plugin_entry = {sizeof(swage_entry), BALL_MAJOR, BALL_MINOR, 0,
                                        "plain C",           NULL,       NULL,       BALL_FACTORIES};

#ifdef __cplusplus
}
#endif
#endif
