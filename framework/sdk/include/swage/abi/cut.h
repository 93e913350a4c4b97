/* SPDX-License-Identifier: Apache-2.0
 *
 * swage/abi/cut.h - two traits: what parts a strand, and what can be parted.
 */
#ifndef SWAGE_ABI_CUT_H
#define SWAGE_ABI_CUT_H

#include "object.h"

/* A gripper whose jaws can be blades. */
#define SWAGE_TRAIT_BLADES "swage.trait.blades/1"
typedef struct swage_blades_law {
  double shear; /* 1: the force with which both blades press when they part a strand, over its strength; 0: they do not cut */
} swage_blades_law;
typedef struct swage_blades {
  swage_result (*law)(swage_instance*, const swage_object_step*, swage_blades_law* out); /* [rt] */
} swage_blades;

/* A strand (abi/strand.h) that can be parted. cut() parts the material at the arc length s [m] of the strand, or as near to it as the
 * object is able to; from the next step on nothing is borne there, and both parts go on by themselves. What is parted already stays so.
 * For finish() of a coupling, after the solve. It changes the object's own state and nothing else. */
#define SWAGE_TRAIT_CUTTABLE "swage.trait.cuttable/1"
typedef struct swage_cuttable {
  swage_result (*cut)(swage_instance*, const swage_object_step*, double s); /* [rt] */
} swage_cuttable;

SWAGE_STATIC_ASSERT(sizeof(swage_blades_law) == 8, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_blades) == 8, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_cuttable) == 8, "frozen layout");

#endif
