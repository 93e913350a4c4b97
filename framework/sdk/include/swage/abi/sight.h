/* SPDX-License-Identifier: Apache-2.0
 *
 * swage/abi/sight.h - a LOCKSTEP device that sees the scene, as the eyes above a hand do. For scripted hands that must find
 * what chance has put somewhere. What it makes of it is recorded as any other sample: a replay needs no eyes.
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

/* What bind() sees. Static while bound. */
typedef struct swage_sight_card {
  uint32_t struct_size, n_mark;
  const swage_scene_card* scene;
  const swage_scene_mark* mark;
} swage_sight_card;

/* What look() sees: the scene as the last step left it. */
typedef struct swage_sight {
  uint32_t struct_size, n_mark;
  const swage_view* view;
  const swage_vec3* mark_p_W; /* [n_mark] m, where a POINT stands now */
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
