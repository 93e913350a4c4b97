/* SPDX-License-Identifier: Apache-2.0
 *
 * swage/abi/visual.h - what is drawn on objects beside their shapes: one list of primitives, from an object or a coupling.
 *
 * For the eye only: it is asked when a picture is taken, is no part of the state, and nothing judges it.
 */
#ifndef SWAGE_ABI_VISUAL_H
#define SWAGE_ABI_VISUAL_H

#include "coupling.h"

/* What a primitive is. Places of TEAR and WOUND are those of now along the surface, and at rest across it: the dents of the same
 * object, which the picture adds, displace them only along `direction`. */
#define SWAGE_VISUAL_DENT 1  /* the surface at a distance r from a is displaced by (b - a) / sqrt(1 + (r/radius)^2); dents add up */
#define SWAGE_VISUAL_TEAR 2  /* flat capsule from a to b in a surface of normal `direction`; those of one group are one torn region */
#define SWAGE_VISUAL_WOUND 3 /* of the torn region of its group: a where it is open, b how far it leads, `direction` the way inwards,
                              * radius of a disc as large as the region, strength 1 where something is in it and 0 where it is empty */
#define SWAGE_VISUAL_LINE 4  /* from a to b, seen at any magnification */
#define SWAGE_VISUAL_DISC 5  /* about a, normal `direction` */
#define SWAGE_VISUAL_TUBE 6  /* from a to b, with round ends, to scale */
#define SWAGE_VISUAL_KINDS 6

/* How a line, a disc or a tube looks; the console has the colours. Dents, tears and wounds have looks of their own: 0. */
#define SWAGE_TONE_INK 0   /* as from a surgeon's pen */
#define SWAGE_TONE_FLESH 1 /* raw tissue */
#define SWAGE_TONE_DEEP 2  /* the dark of an opening */
#define SWAGE_TONES 3

typedef struct swage_visual {
  uint32_t kind;        /* SWAGE_VISUAL_* */
  uint32_t body;        /* in whose frame a, b and direction are: an index of the object's own; SWAGE_NONE: the world */
  uint32_t group;       /* of TEAR and WOUND: which region; counts from 0 */
  uint32_t tone;        /* SWAGE_TONE_* */
  swage_vec3 a, b;      /* m */
  swage_vec3 direction; /* unit where the kind has one, 0 elsewhere */
  double radius;        /* m, not negative; of a DENT positive */
  double strength;      /* 0..1; of LINE, DISC and TUBE the share of the radius that is drawn, 0: nothing */
} swage_visual;

/* Of an object the coupling's step is NULL. Of a coupling the object's step is NULL, and what it draws is on object b: indices of
 * bodies are those of b. Writes at most `capacity` primitives into out, their number into *n, and nothing else. After finish(). */
#define SWAGE_EXT_VISUAL "swage.visual/1"
typedef struct swage_visuals {
  swage_result (*draw)(swage_instance*, const swage_object_step*, const swage_coupling_step*, uint32_t capacity, swage_visual* out,
                       uint32_t* n); /* [rt & active] */
} swage_visuals;

SWAGE_STATIC_ASSERT(sizeof(swage_visual) == 104, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_visuals) == 8, "frozen layout");

#endif
