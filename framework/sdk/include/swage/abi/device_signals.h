/* SPDX-License-Identifier: Apache-2.0
 *
 * swage/abi/device_signals.h - signals of a device itself: a battery, a temperature, raw volts. The host records it with the
 * attempt and shows it. It is no part of the scene: no lesson sees it, and a replay repeats without it. Optional.
 */
#ifndef SWAGE_ABI_DEVICE_SIGNALS_H
#define SWAGE_ABI_DEVICE_SIGNALS_H

#include "plugin.h"

#define SWAGE_MOST_DEVICE_SIGNALS 8u

/* A signal of a device; static storage, UTF-8. */
typedef struct swage_device_signal {
  const char* id;   /* "sensor.volts"; unique within this device */
  const char* unit; /* SI, "1" for a ratio */
  const char* doc;  /* one sentence */
} swage_device_signal;

#define SWAGE_EXT_DEVICE_SIGNALS "swage.device.signals/1"
typedef struct swage_device_signals {
  uint32_t count, reserved;          /* 1 to SWAGE_MOST_DEVICE_SIGNALS */
  const swage_device_signal* signal; /* [count] static storage */
  /* [io & active], or [rt & active] when LOCKSTEP: on the thread of exchange() and right after it. out[count], SI; NaN: unknown. */
  swage_result (*read)(swage_instance*, double* out);
} swage_device_signals;

SWAGE_STATIC_ASSERT(sizeof(swage_device_signal) == 24, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_device_signals) == 24, "frozen layout");

#endif
