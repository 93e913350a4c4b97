/* SPDX-License-Identifier: Apache-2.0
 *
 * swage/abi/lesson_card.h - what a lesson measures and signals, readable without running it. Optional: a lesson without a
 * card is judged in the same way, but which values of its metrics are better is unknown.
 */
#ifndef SWAGE_ABI_LESSON_CARD_H
#define SWAGE_ABI_LESSON_CARD_H

#include "plugin.h"

/* Which values of a metric are better. */
#define SWAGE_BETTER_NONE 0   /* descriptive, not rated */
#define SWAGE_BETTER_LOWER 1
#define SWAGE_BETTER_HIGHER 2
#define SWAGE_BETTER_INSIDE 3 /* inside a band that a parameter gives */

/* Evidence that the metric distinguishes good from poor performance. */
#define SWAGE_EVIDENCE_NONE 0
#define SWAGE_EVIDENCE_A 1 /* distinguishes levels of experience in a published study of microsurgical tasks */
#define SWAGE_EVIDENCE_B 2 /* the same for other surgical tasks */
#define SWAGE_EVIDENCE_C 3 /* from a thesis or an expert's rule */
#define SWAGE_EVIDENCE_D 4 /* proposed by Swage, not validated */

typedef struct swage_metric_info {
  const char* id;      /* as declared with the builder: "grasp.tries" */
  const char* unit;    /* SI, "1" for a pure number */
  const char* doc;     /* one sentence */
  const char* formula; /* how it is computed, in one line */
  const char* code;    /* its number in a catalogue of metrics, "M06"; "" for none */
  int32_t better;      /* SWAGE_BETTER_* */
  int32_t evidence;    /* SWAGE_EVIDENCE_* */
} swage_metric_info;

/* Channels that suit a cue. The console gives each meaning its colour, shape and sound; FORCE needs a device with force output. */
#define SWAGE_CHANNEL_COLOUR 1u
#define SWAGE_CHANNEL_SHAPE 2u
#define SWAGE_CHANNEL_SOUND 4u
#define SWAGE_CHANNEL_FORCE 8u

/* Role of a cue for the trainee. Where the console's theme does not know the id, this role gives colour, shape and sound. */
#define SWAGE_CUE_NEUTRAL 0u /* a state that is neither good nor bad: grey, silent */
#define SWAGE_CUE_GOOD 1u    /* as asked */
#define SWAGE_CUE_WARNING 2u /* nearly, or take care */
#define SWAGE_CUE_BAD 3u     /* a fault */
#define SWAGE_CUE_TARGET 4u  /* where to go */

typedef struct swage_cue_info {
  const char* id;    /* a meaning: "grasp.good" */
  const char* doc;   /* when it is on */
  uint32_t channels; /* SWAGE_CHANNEL_* */
  uint32_t role;     /* SWAGE_CUE_* */
} swage_cue_info;

#define SWAGE_FACTORY_LESSON_CARD "swage.factory.lesson_card/1"
typedef struct swage_lesson_card_factory {
  /* [any] The tables of a plugin, static storage; *count = 0 and NULL for a plugin that has none. */
  const swage_metric_info* (*metrics)(const char* plugin_id, uint32_t* count);
  const swage_cue_info* (*cues)(const char* plugin_id, uint32_t* count);
} swage_lesson_card_factory;

/* How a metric is shown. */
#define SWAGE_SHOW_QUANTITY 0 /* with its unit, in the multiple that reads best */
#define SWAGE_SHOW_COUNT 1    /* a whole number; also shown while the attempt runs */
#define SWAGE_SHOW_SHARE 2    /* a pure number as per cent */
#define SWAGE_SHOW_YES_NO 3   /* 0 or 1 */
#define SWAGE_SHOW_POINTS 4   /* points of 100 that were deducted; shown beside the score, not among the metrics */

/* Title of a metric, and the values that this lesson requires of it. */
typedef struct swage_metric_label {
  const char* id;    /* of a metric of the card */
  const char* title; /* a few words for lists and axes: "Grip force, peak" */
  int32_t show;      /* SWAGE_SHOW_* */
  int32_t rank;      /* 1, 2, ...: shown first, in this order; 0: on demand */
  const char* least; /* parameter with the least required value; NULL: none. Of an interval the lower end counts */
  const char* most;  /* parameter with the greatest allowed value; NULL: none. Of an interval the upper end */
} swage_metric_label;

/* Requirements on the trainee, in sentences. */
#define SWAGE_CRITERION_PASS 1   /* needed to pass */
#define SWAGE_CRITERION_LIMIT 2  /* ends the attempt as not passed; in practice it may only be reported */
#define SWAGE_CRITERION_POINTS 3 /* costs points */
#define SWAGE_CRITERION_SHOW 4   /* nothing is asked: the lesson is a demonstration, without score or record */
#define SWAGE_CRITERION_ENDS 5   /* ends every attempt as not passed, in practice as well */
typedef struct swage_criterion {
  const char* text;  /* "Hold it for {hold_time}.": {id} stands for the value of a parameter, with its unit */
  const char* when;  /* condition under which the sentence holds. "id": the parameter is true, not 0, or a text that is not
                        empty; "!id": the opposite; "id=choice": it has that choice; NULL: always */
  int32_t kind;      /* SWAGE_CRITERION_* */
  uint32_t reserved;
} swage_criterion;

#define SWAGE_FACTORY_LESSON_LABELS "swage.factory.lesson_labels/1"
typedef struct swage_lesson_labels_factory {
  /* [any] The tables of a plugin, static storage; *count = 0 and NULL for a plugin that has none. */
  const swage_metric_label* (*labels)(const char* plugin_id, uint32_t* count);
  const swage_criterion* (*criteria)(const char* plugin_id, uint32_t* count);
} swage_lesson_labels_factory;

SWAGE_STATIC_ASSERT(sizeof(swage_metric_info) == 48, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_cue_info) == 24, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_lesson_card_factory) == 16, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_metric_label) == 40, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_criterion) == 24, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_lesson_labels_factory) == 16, "frozen layout");

#endif
