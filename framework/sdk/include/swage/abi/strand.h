/* SPDX-License-Identifier: Apache-2.0
 *
 * swage/abi/strand.h - a trait of threads: properties, and places by arc length, for couplings.
 */
#ifndef SWAGE_ABI_STRAND_H
#define SWAGE_ABI_STRAND_H

#include "object.h"

/* A long thin flexible object: a suture, a rubber band. Arc lengths are those of the unloaded material, from its first end: an
 * arc length identifies the same material at all times. */
#define SWAGE_TRAIT_STRAND "swage.trait.strand/1"
typedef struct swage_strand_law {
  double length;   /* m, unloaded */
  double radius;   /* m */
  double strength; /* N, tension at which it breaks */
  double pull_off; /* N, pull that draws it out of the needle to which it is swaged */
} swage_strand_law;
typedef struct swage_strand_place {
  double s;             /* m, 0 at the first end */
  double tension;       /* N, at s after the solve; for finish() */
  swage_vec3 p_W;       /* m, on the centre line */
  swage_vec3 tangent_W; /* unit, towards the last end */
  swage_vec3 normal_W;  /* unit, perpendicular to the tangent; turns with the material as it twists */
  uint32_t body;        /* the object's own index: which body is there */
  uint32_t parted;      /* 1: the piece is cut or broken there */
} swage_strand_place;
typedef struct swage_strand {
  swage_result (*law)(swage_instance*, const swage_object_step*, swage_strand_law* out);                         /* [rt] */
  swage_result (*place)(swage_instance*, const swage_object_step*, double s, swage_strand_place* out);           /* [rt] */
  swage_result (*nearest)(swage_instance*, const swage_object_step*, swage_vec3 p_W, swage_strand_place* out);  /* [rt] */
} swage_strand;

/* How fine a strand is: between its nodes it is straight. Offered beside SWAGE_TRAIT_STRAND, so that whoever looks at single places
 * of it takes enough of them. */
#define SWAGE_TRAIT_STRAND_NODES "swage.trait.strand_nodes/1"
typedef struct swage_strand_nodes {
  /* [rt] writes the number of nodes, ends included, constant while active */
  swage_result (*count)(swage_instance*, const swage_object_step*, uint32_t* out);
} swage_strand_nodes;

/* Places of the whole strand in one call, for who looks at all of it in every step. Offered beside SWAGE_TRAIT_STRAND. */
#define SWAGE_TRAIT_STRAND_LINE "swage.trait.strand_line/1"
typedef struct swage_strand_line {
  /* [rt] n >= 2 places at equal arc lengths, both ends included: p_W[3 i ...] m, parted[i] as swage_strand_place tells them of each */
  swage_result (*line)(swage_instance*, const swage_object_step*, uint32_t n, double* p_W, uint32_t* parted);
} swage_strand_line;

SWAGE_STATIC_ASSERT(sizeof(swage_strand_law) == 32, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_strand_place) == 96, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_strand) == 24, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_strand_nodes) == 8, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_strand_line) == 8, "frozen layout");

#endif
