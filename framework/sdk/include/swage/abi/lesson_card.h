/* SPDX-License-Identifier: Apache-2.0
 *
 * swage/abi/lesson_card.h - what a lesson measures and signals, readable without running it. Optional: a lesson without a
 * card is judged alike; nobody then knows which way its metrics are better.
 */
#ifndef SWAGE_ABI_LESSON_CARD_H
#define SWAGE_ABI_LESSON_CARD_H

#include "plugin.h"

/* Which values of a metric are better. */
#define SWAGE_BETTER_NONE 0   /* it describes and does not rate */
#define SWAGE_BETTER_LOWER 1
#define SWAGE_BETTER_HIGHER 2
#define SWAGE_BETTER_INSIDE 3 /* inside a band that a parameter gives */

/* How well it is known that the metric tells good from poor hands. */
#define SWAGE_EVIDENCE_NONE 0
#define SWAGE_EVIDENCE_A 1 /* tells experience apart in microsurgical tasks in a published study */
#define SWAGE_EVIDENCE_B 2 /* elsewhere in surgery */
#define SWAGE_EVIDENCE_C 3 /* from a thesis or an expert's rule */
#define SWAGE_EVIDENCE_D 4 /* ours, untested */

typedef struct swage_metric_info {
  const char* id;      /* as declared with the builder: "grasp.tries" */
  const char* unit;    /* SI, "1" for a pure number */
  const char* doc;     /* one sentence */
  const char* formula; /* how it is computed, in one line */
  const char* code;    /* its number in a catalogue of metrics, "M06"; "" for none */
  int32_t better;      /* SWAGE_BETTER_* */
  int32_t evidence;    /* SWAGE_EVIDENCE_* */
} swage_metric_info;

/* Channels that suit a cue. The console gives each meaning its colour, shape and sound; FORCE needs a device that has it. */
#define SWAGE_CHANNEL_COLOUR 1u
#define SWAGE_CHANNEL_SHAPE 2u
#define SWAGE_CHANNEL_SOUND 4u
#define SWAGE_CHANNEL_FORCE 8u

typedef struct swage_cue_info {
  const char* id;    /* a meaning: "grasp.good" */
  const char* doc;   /* when it is on */
  uint32_t channels; /* SWAGE_CHANNEL_* */
  uint32_t reserved;
} swage_cue_info;

#define SWAGE_FACTORY_LESSON_CARD "swage.factory.lesson_card/1"
typedef struct swage_lesson_card_factory {
  /* [any] The tables of a plugin, static storage; *count = 0 and NULL for a plugin that has none. */
  const swage_metric_info* (*metrics)(const char* plugin_id, uint32_t* count);
  const swage_cue_info* (*cues)(const char* plugin_id, uint32_t* count);
} swage_lesson_card_factory;

SWAGE_STATIC_ASSERT(sizeof(swage_metric_info) == 48, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_cue_info) == 24, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_lesson_card_factory) == 16, "frozen layout");

#endif
