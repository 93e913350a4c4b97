/* SPDX-License-Identifier: Apache-2.0
 *
 * The layout as a C compiler sees it. Compiling is the test.
 */
#include <stddef.h>
#include <swage/abi/band.h>
#include <swage/abi/calibration.h>
#include <swage/abi/coupling.h>
#include <swage/abi/cut.h>
#include <swage/abi/device.h>
#include <swage/abi/device_signals.h>
#include <swage/abi/display.h>
#include <swage/abi/environment.h>
#include <swage/abi/lesson.h>
#include <swage/abi/lesson_card.h>
#include <swage/abi/object.h>
#include <swage/abi/sight.h>
#include <swage/abi/strand.h>
#include <swage/abi/visual.h>
#include <swage/abi/wire.h>

#define SWAGE_SIZE(type, bytes) _Static_assert(sizeof(type) == bytes, #type);
#define SWAGE_OFFSET(type, member, bytes) _Static_assert(offsetof(type, member) == bytes, #type "." #member);
#include "layout.inc"

int swage_layout_holds_in_c(void) { return 1; }
