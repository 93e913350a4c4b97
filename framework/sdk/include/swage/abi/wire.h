/* SPDX-License-Identifier: Apache-2.0
 *
 * swage/abi/wire.h - a trait: a wire that bends plastically, collapses and breaks.
 */
#ifndef SWAGE_ABI_WIRE_H
#define SWAGE_ABI_WIRE_H

#include "object.h"

/* end() reports collapse and break once each in an attempt, to the first caller: it changes the object's record of what it has
 * reported and nothing else. Called in finish() of a coupling, after the solve. */
#define SWAGE_TRAIT_WIRE "swage.trait.wire/1"
typedef struct swage_wire_end {
  double collapsed; /* place whose whole section is plastic, 0 at the point .. 1 at the swage; below 0: none, or reported before */
  double broke;     /* place where it broke, likewise */
} swage_wire_end;
typedef struct swage_wire {
  swage_result (*end)(swage_instance*, const swage_object_step*, swage_wire_end* out); /* [rt] */
} swage_wire;

SWAGE_STATIC_ASSERT(sizeof(swage_wire_end) == 16, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_wire) == 8, "frozen layout");

#endif
