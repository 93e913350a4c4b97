/* SPDX-License-Identifier: Apache-2.0
 *
 * swage/abi/environment.h - host extension: the surroundings that the lesson sets. The host damps DYNAMIC bodies itself; an object
 * reads the fluid, the film and the charge and adds their forces, as only it knows its form.
 */
#ifndef SWAGE_ABI_ENVIRONMENT_H
#define SWAGE_ABI_ENVIRONMENT_H

#include "plugin.h"

#define SWAGE_MEDIUM_UNSET 0 /* none in the lesson: a thread is in still air, on rigid bodies no fluid acts */
#define SWAGE_MEDIUM_DRY 1   /* air; charged objects keep their charge */
#define SWAGE_MEDIUM_MOIST 2 /* air; surfaces carry a film of water */
#define SWAGE_MEDIUM_WATER 3 /* everything is under water */
typedef struct swage_environment {
  uint32_t struct_size;
  uint32_t medium;        /* SWAGE_MEDIUM_* */
  double density;         /* kg/m3, of the fluid */
  double viscosity;       /* Pa s, of the fluid */
  double surface_tension; /* N/m, of the film; 0: nothing is wet */
  double contact_angle;   /* rad, of the film on what it wets */
  double film;            /* m, thickness of the film */
  double charge;          /* C/m, of a thread along its length */
  double ground_z;        /* m, height in W of an earthed metal plane; counts where `grounded` is 1 */
  double linear_damping;  /* N s/m, of each DYNAMIC body: force -k v (the host applies it) */
  double angular_damping; /* N m s/rad, of each DYNAMIC body: torque -k w (the host applies it) */
  uint32_t grounded;      /* 1: there is an earthed plane */
  uint32_t reserved;
} swage_environment;

#define SWAGE_HOST_ENVIRONMENT "swage.host.environment/1"
typedef struct swage_host_environment {
  /* [any] The same from configure on. Writes at most struct_size bytes. */
  void (*read)(const swage_host*, swage_environment* out);
} swage_host_environment;

SWAGE_STATIC_ASSERT(sizeof(swage_environment) == 88, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_host_environment) == 8, "frozen layout");

#endif
