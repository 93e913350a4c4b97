/* SPDX-License-Identifier: Apache-2.0
 *
 * swage/abi/visual.h - primitives drawn on objects beside their shapes: one list from each object or coupling.
 *
 * For drawing only: requested when a snapshot is taken; no part of the state, and not judged.
 */
#ifndef SWAGE_ABI_VISUAL_H
#define SWAGE_ABI_VISUAL_H

#include "coupling.h"

/* Kinds of primitives. Positions of TEAR and WOUND along the surface are the present ones; along `direction` they are those of the surface
 * without dents, which the drawing adds. */
#define SWAGE_VISUAL_DENT 1  /* the surface at a distance r from a is displaced by (b - a) / sqrt(1 + (r/radius)^2); dents add up */
#define SWAGE_VISUAL_TEAR 2  /* flat capsule from a to b in a surface of normal `direction`; those of one group are one torn region */
#define SWAGE_VISUAL_WOUND 3 /* of the torn region of its group: a its opening, b its deepest point, `direction` inwards,
                              * radius of a disc with the area of the region, strength 1 if an object is in it, 0 if it is empty */
#define SWAGE_VISUAL_LINE 4  /* from a to b, with a least width on the screen */
#define SWAGE_VISUAL_DISC 5  /* about a, normal `direction` */
#define SWAGE_VISUAL_TUBE 6  /* from a to b, with round ends, to scale */
#define SWAGE_VISUAL_KINDS 6

/* Tone of a line, a disc or a tube; the console has the colours. Dents, tears and wounds have looks of their own: 0. */
#define SWAGE_TONE_INK 0   /* ink of a surgeon's pen */
#define SWAGE_TONE_FLESH 1 /* raw tissue */
#define SWAGE_TONE_DEEP 2  /* the dark of an opening */
#define SWAGE_TONES 3

typedef struct swage_visual {
  uint32_t kind;        /* SWAGE_VISUAL_* */
  uint32_t body;        /* frame of a, b and direction: index of a body of the object; SWAGE_NONE: the world */
  uint32_t group;       /* of TEAR and WOUND: number of the region, from 0 */
  uint32_t tone;        /* SWAGE_TONE_* */
  swage_vec3 a, b;      /* m */
  swage_vec3 direction; /* unit where the kind has one, 0 elsewhere */
  double radius;        /* m, not negative; of a DENT positive */
  double strength;      /* 0..1; of LINE, DISC and TUBE the share of the radius that is drawn; 0: invisible */
} swage_visual;

/* Called after finish(). An object gets a NULL coupling step; a coupling gets a NULL object step and draws on object b, with indices of
 * b's bodies. Writes at most `capacity` primitives (one more than are drawn: a list that fills it is counted as cut) into out and their number into *n, and must not change state. */
#define SWAGE_EXT_VISUAL "swage.visual/1"
typedef struct swage_visuals {
  swage_result (*draw)(swage_instance*, const swage_object_step*, const swage_coupling_step*, uint32_t capacity, swage_visual* out,
                       uint32_t* n); /* [rt & active] */
} swage_visuals;

SWAGE_STATIC_ASSERT(sizeof(swage_visual) == 104, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_visuals) == 8, "frozen layout");

#endif
