/* SPDX-License-Identifier: Apache-2.0
 *
 * swage/abi/sight.h - a LOCKSTEP device that observes the scene. For scripted hands that must find objects at random places.
 * Its samples are recorded as those of any device, so a replay does not need the observation.
 */
#ifndef SWAGE_ABI_SIGHT_H
#define SWAGE_ABI_SIGHT_H

#include "device.h"
#include "lesson.h"

/* A mark of the lesson, as it was declared. */
typedef struct swage_scene_mark {
  int32_t kind;    /* SWAGE_MARK_* */
  uint32_t object; /* ARC_RANGE: index in the scene card */
  swage_str meaning;
  double number[2];
} swage_scene_mark;

/* Argument of bind(). Static while bound. */
typedef struct swage_sight_card {
  uint32_t struct_size, n_mark;
  const swage_scene_card* scene;
  const swage_scene_mark* mark;
} swage_sight_card;

/* Argument of look(): the scene after the last step. */
typedef struct swage_sight {
  uint32_t struct_size, n_mark;
  const swage_view* view;
  const swage_vec3* mark_p_W; /* [n_mark] m, present position of a POINT */
} swage_sight;

#define SWAGE_EXT_SIGHT "swage.device.sight/1"
typedef struct swage_device_sight {
  swage_result (*bind)(swage_instance*, const swage_sight_card*); /* [main & !active] after the lesson's bind() */
  swage_result (*look)(swage_instance*, const swage_sight*);      /* [rt & active] each step, before exchange() */
} swage_device_sight;

SWAGE_STATIC_ASSERT(sizeof(swage_scene_mark) == 40, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_sight_card) == 24, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_sight) == 24, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_device_sight) == 16, "frozen layout");

#endif
