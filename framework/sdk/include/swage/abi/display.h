/* SPDX-License-Identifier: Apache-2.0
 *
 * swage/abi/display.h - host extension: mono or stereo view of the scene. Judging depth is a different task in stereo.
 */
#ifndef SWAGE_ABI_DISPLAY_H
#define SWAGE_ABI_DISPLAY_H

#include "plugin.h"

#define SWAGE_HOST_DISPLAY "swage.host.display/1"
#define SWAGE_EYES_NONE 0 /* no viewer: a run without a window, or an attempt without a record of it */
#define SWAGE_EYES_MONO 1 /* one picture for both eyes */
#define SWAGE_EYES_STEREO 2 /* a picture for each eye */
typedef struct swage_host_display {
  /* [any] SWAGE_EYES_* as the attempt began, the same from activate on; a replay returns the recorded value. */
  int32_t (*eyes)(const swage_host*);
} swage_host_display;

SWAGE_STATIC_ASSERT(sizeof(swage_host_display) == 8, "frozen layout");

#endif
