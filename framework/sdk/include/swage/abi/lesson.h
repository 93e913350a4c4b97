/* SPDX-License-Identifier: Apache-2.0
 *
 * swage/abi/lesson.h - a lesson observes and judges; it applies no forces. The same code judges live and re-judges recordings.
 */
#ifndef SWAGE_ABI_LESSON_H
#define SWAGE_ABI_LESSON_H

#include "object.h"

/* Scene card for bind(): everything with a name in the scene, in the order of the lesson file. Static while bound. */
typedef struct swage_scene_object {
  swage_str name, plugin;
  uint32_t first_body, n_body;         /* into swage_view.X_WB */
  uint32_t first_particle, n_particle; /* into swage_view.particle_p_W */
  swage_instance* instance;            /* for its traits */
} swage_scene_object;
typedef struct swage_scene_signal {
  swage_str owner; /* object, coupling or device instance name */
  swage_str id, unit;
} swage_scene_signal;
typedef struct swage_scene_event {
  swage_str owner, id;
} swage_scene_event;

typedef struct swage_scene_card {
  uint32_t struct_size, n_object, n_signal, n_event;
  const swage_scene_object* object;
  const swage_scene_signal* signal; /* index = index into swage_view.signal */
  const swage_scene_event* event;   /* index = swage_view_event.event */
  double scene_length;              /* m */
} swage_scene_card;

typedef struct swage_view_event {
  uint32_t event, reserved;
  double value;
} swage_view_event;

/* The scene in observe(), after a step. */
typedef struct swage_view {
  uint32_t struct_size, n_body, n_particle, n_signal;
  uint64_t step;
  double time_s, dt_s;
  const swage_pose* X_WB;
  const swage_twist* V_WB;
  const double* particle_p_W;
  const double* signal;
  const swage_view_event* event; /* of this step, in order */
  const swage_object_step* object_step; /* [n_object] for calls to traits */
  uint32_t n_event, n_object;
} swage_view;

/* Marks are what a lesson shows in the scene; declared in bind(), shown and cued in observe(). */
#define SWAGE_MARK_ARC_RANGE 1 /* part of an object's arc shape: number[0], number[1] in 0..1 */
#define SWAGE_MARK_POINT 2     /* a point in the world: position, radius number[0] */
typedef struct swage_mark {
  int32_t kind;
  uint32_t object;  /* ARC_RANGE: index in the scene card */
  swage_str meaning; /* "region.target", "target.point" */
  double number[2];
  swage_vec3 p_W;
} swage_mark;

typedef struct swage_lesson_binder {
  uint32_t struct_size, reserved;
  void* host_data;
  uint32_t (*mark)(struct swage_lesson_binder*, const swage_mark*); /* [main] */
  void (*error)(struct swage_lesson_binder*, const char* message);  /* [main] e.g. a signal that no instance offers */
} swage_lesson_binder;

typedef struct swage_verdict {
  uint32_t struct_size, reserved;
  void* host_data;
  void (*cue)(const struct swage_verdict*, uint32_t object, uint32_t cue);       /* [rt] SWAGE_NONE clears the object's cue */
  void (*mark)(const struct swage_verdict*, uint32_t mark, uint32_t cue, const swage_vec3* p_W); /* [rt] cue SWAGE_NONE: none */
  void (*metric)(const struct swage_verdict*, uint32_t metric, double value);    /* [rt] */
  void (*event)(const struct swage_verdict*, uint32_t event, double value);      /* [rt] */
  void (*phase)(const struct swage_verdict*, uint32_t phase);                    /* [rt] */
  /* [rt] score: 0..100; reason: declared index of the event that explains a failure, SWAGE_NONE after a success */
  void (*finish)(const struct swage_verdict*, int32_t passed, double score, uint32_t reason);
} swage_verdict;

#define SWAGE_EXT_LESSON "swage.lesson/1"
typedef struct swage_lesson {
  swage_result (*bind)(swage_instance*, const swage_scene_card*, swage_lesson_binder*); /* [main & !active] */
  swage_result (*observe)(swage_instance*, const swage_view*, const swage_verdict*, double* state); /* [rt & active] */
  void (*reset)(swage_instance*, double* state);                                        /* [rt & active] */
  uint64_t reserved;
} swage_lesson;

/* Host extension: what an attempt is for. In practice a lesson may report that a limit is exceeded and continue; in a test
 * the limit ends the attempt. An attempt without a mode is judged as a test. */
#define SWAGE_HOST_ATTEMPT "swage.host.attempt/1"
#define SWAGE_ATTEMPT_TEST 0
#define SWAGE_ATTEMPT_PRACTICE 1
#define SWAGE_ATTEMPT_DEMO 2
typedef struct swage_host_attempt {
  int32_t (*mode)(const swage_host*); /* [any] SWAGE_ATTEMPT_*, the same from activate on */
} swage_host_attempt;

SWAGE_STATIC_ASSERT(sizeof(swage_scene_object) == 56, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_scene_card) == 48, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_view) == 96, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_mark) == 64, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_lesson_binder) == 32, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_verdict) == 64, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_lesson) == 32, "frozen layout");

#endif
