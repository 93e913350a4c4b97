/* SPDX-License-Identifier: Apache-2.0
 *
 * swage/abi/device_signals.h - what a device tells of itself: a battery, a temperature, raw volts. The host records it with the
 * attempt and shows it. It is no part of the scene: no lesson sees it, and a replay repeats without it. Optional.
 */
#ifndef SWAGE_ABI_DEVICE_SIGNALS_H
#define SWAGE_ABI_DEVICE_SIGNALS_H

#include "plugin.h"

#define SWAGE_MOST_DEVICE_SIGNALS 8u

/* One of them; static storage, UTF-8. */
typedef struct swage_device_signal {
  const char* id;   /* "sensor.volts"; one of its kind in this device */
  const char* unit; /* of SI, "1" for a share */
  const char* doc;  /* one sentence */
} swage_device_signal;

#define SWAGE_EXT_DEVICE_SIGNALS "swage.device.signals/1"
typedef struct swage_device_signals {
  uint32_t count, reserved;          /* 1 to SWAGE_MOST_DEVICE_SIGNALS */
  const swage_device_signal* signal; /* [count] static storage */
  /* [io & active], or [rt & active] when LOCKSTEP: on the thread of exchange() and right after it. out[count], SI; NaN: not known now. */
  swage_result (*read)(swage_instance*, double* out);
} swage_device_signals;

SWAGE_STATIC_ASSERT(sizeof(swage_device_signal) == 24, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_device_signals) == 24, "frozen layout");

#endif
