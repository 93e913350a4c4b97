/* SPDX-License-Identifier: Apache-2.0
 *
 * swage/abi/calibration.h - the calibration that a device measures with; the host keeps it with the attempt. Optional: a device
 * without it is recorded as not calibrated.
 */
#ifndef SWAGE_ABI_CALIBRATION_H
#define SWAGE_ABI_CALIBRATION_H

#include "plugin.h"

#define SWAGE_EXT_CALIBRATION "swage.device.calibration/1"
typedef struct swage_device_calibration {
  /* [main & open] The calibration in use as JSON text of at most 1 MiB, empty for none; it stays until close(). Keys that the host
   * shows: "serial" of the device, "date" and "expires" as "2026-11-22", "residual" (SI) or {"displacement": {"worst"}}. */
  swage_str (*text)(swage_instance*);
} swage_device_calibration;

SWAGE_STATIC_ASSERT(sizeof(swage_device_calibration) == 8, "frozen layout");

#endif
