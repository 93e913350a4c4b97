/* SPDX-License-Identifier: Apache-2.0
 *
 * swage/abi/device.h - a device gives samples and, when it can, takes forces.
 *
 * Device frame D0: right-handed, +x right, +y up, +z towards the user, metres. The host scales and turns it into the world.
 * No force reaches a device but through the host's force guard.
 */
#ifndef SWAGE_ABI_DEVICE_H
#define SWAGE_ABI_DEVICE_H

#include "plugin.h"

/* Flags of a device. */
#define SWAGE_DEVICE_LOCKSTEP 1u /* exchange is called on [rt], once per step: bit-exact; must be as quick as a step */
#define SWAGE_DEVICE_FORCE 2u    /* takes forces */
#define SWAGE_DEVICE_WORLD 4u    /* its poses are already in the world frame W (scripted hands, replays) */
#define SWAGE_DEVICE_SCRIPTED 8u /* it plays a script or a recording: its attempts count for no trainee */
#define SWAGE_DEVICE_POINTER 16u /* moved by pointer and keys over the view (SWAGE_HOST_POINTER): at rest without a window */

/* Bits of swage_sample.valid. */
#define SWAGE_VALID_POSE 1u
#define SWAGE_VALID_TWIST 2u
#define SWAGE_VALID_CLOSURE 4u
#define SWAGE_VALID_GRIP 8u
#define SWAGE_VALID_BUTTONS 16u
#define SWAGE_VALID_DONE 32u /* a script or replay has come to its end */

typedef struct swage_sample {
  uint64_t sequence; /* counts up with each new measurement */
  double time_s;     /* when it was measured, on the host's monotonic clock or in simulated time when LOCKSTEP */
  swage_pose pose;
  swage_twist twist;
  double closure;    /* 0 open .. 1 closed */
  double grip_force; /* N */
  uint32_t buttons, valid;
} swage_sample;

/* Command to the device, limited by the force guard. The anchor lets a servo faster than the step close the loop by itself:
 * F = stiffness (anchor.p - x) + damping (anchor_twist.v - v), while younger than `deadline_s`. */
typedef struct swage_command {
  double time_s;           /* simulated */
  swage_vec3 force;        /* N in the device frame */
  swage_vec3 torque;       /* N m */
  swage_pose anchor;
  swage_twist anchor_twist;
  double stiffness;        /* N/m */
  double damping;          /* N s/m */
  double gain;             /* 0..1 fade */
  double deadline_s;       /* host's monotonic clock */
} swage_command;

#define SWAGE_EXT_DEVICE "swage.device/1"
typedef struct swage_device {
  uint32_t flags, reserved;
  double rate_hz;   /* preferred rate of exchange on [io] */
  double max_force; /* N, 0 without FORCE */
  swage_result (*open)(swage_instance*);  /* [main & active] */
  void (*close)(swage_instance*);         /* [main & active] */
  swage_result (*exchange)(swage_instance*, const swage_command*, swage_sample* out); /* [io], or [rt] when LOCKSTEP */
} swage_device;

/* Host extension: what the person does with pointer and keyboard over the view. It arrives through the recorded command
 * ring, so that a mouse is as repeatable as any other device. Increments since the last step. In a lesson that is mirrored for
 * the left hand the plugin sees the mirror image: camera, dx, and the keys A-D, Z-X, left-right, pgup-pgdn exchanged. */
#define SWAGE_HOST_POINTER "swage.host.pointer/1"
#define SWAGE_KEY_COUNT 64u
typedef struct swage_pointer {
  double dx, dy;    /* displacement in the plane of view over 10 mm, at every magnification; +x right, +y up */
  double wheel;     /* notches, + away from the user */
  uint32_t buttons; /* bit 0 left, 1 middle, 2 right */
  uint32_t modifiers; /* bit 0 shift, 1 control, 2 alt */
  uint64_t keys;    /* bit i: key i is down; 0..25 = A..Z, 26..35 = 0..9, 36.. = left right up down space enter plus minus pgup pgdn */
  swage_quat camera; /* q_WC of the view: C is +x right, +y up, +z towards the viewer */
} swage_pointer;
typedef struct swage_host_pointer {
  const swage_pointer* (*read)(const swage_host*); /* [rt] never NULL */
} swage_host_pointer;

SWAGE_STATIC_ASSERT(sizeof(swage_sample) == 144, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_command) == 192, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_device) == 48, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_pointer) == 72, "frozen layout");

#endif
