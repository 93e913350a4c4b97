/* SPDX-License-Identifier: Apache-2.0
 *
 * swage/abi/wire.h - a trait: a wire that bends for good, and how that ends.
 */
#ifndef SWAGE_ABI_WIRE_H
#define SWAGE_ABI_WIRE_H

#include "object.h"

/* end() tells each of the two once in an attempt, to who asks first: that it has been told is the object's own state, and nothing else
 * changes. For finish() of a coupling, after the solve. */
#define SWAGE_TRAIT_WIRE "swage.trait.wire/1"
typedef struct swage_wire_end {
  double collapsed; /* where its whole section flows, 0 at the point .. 1 at the swage; below 0: nowhere, or it has been told */
  double broke;     /* where it has broken, the same */
} swage_wire_end;
typedef struct swage_wire {
  swage_result (*end)(swage_instance*, const swage_object_step*, swage_wire_end* out); /* [rt] */
} swage_wire;

SWAGE_STATIC_ASSERT(sizeof(swage_wire_end) == 16, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_wire) == 8, "frozen layout");

#endif
