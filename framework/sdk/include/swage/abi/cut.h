/* SPDX-License-Identifier: Apache-2.0
 *
 * swage/abi/cut.h - two traits: blades that cut a strand, and a strand that can be cut.
 */
#ifndef SWAGE_ABI_CUT_H
#define SWAGE_ABI_CUT_H

#include "object.h"

/* A gripper whose jaws can be blades. */
#define SWAGE_TRAIT_BLADES "swage.trait.blades/1"
typedef struct swage_blades_law {
  double shear; /* 1 (ratio): force of each blade that cuts a strand, over the strand's strength; 0: they do not cut */
} swage_blades_law;
typedef struct swage_blades {
  swage_result (*law)(swage_instance*, const swage_object_step*, swage_blades_law* out); /* [rt] */
} swage_blades;

/* A strand (abi/strand.h) that can be cut. cut() parts the material at the arc length s [m] of the strand, or at the nearest place where
 * the object can; from the next step on no force is transmitted there and the two parts move independently. A cut is final.
 * Called in finish() of a coupling, after the solve. It changes the object's own state and nothing else. */
#define SWAGE_TRAIT_CUTTABLE "swage.trait.cuttable/1"
typedef struct swage_cuttable {
  swage_result (*cut)(swage_instance*, const swage_object_step*, double s); /* [rt] */
} swage_cuttable;

SWAGE_STATIC_ASSERT(sizeof(swage_blades_law) == 8, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_blades) == 8, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_cuttable) == 8, "frozen layout");

#endif
