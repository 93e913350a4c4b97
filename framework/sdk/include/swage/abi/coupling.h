/* SPDX-License-Identifier: Apache-2.0
 *
 * swage/abi/coupling.h - what happens between two objects. A coupling names traits, never plugins.
 */
#ifndef SWAGE_ABI_COUPLING_H
#define SWAGE_ABI_COUPLING_H

#include "object.h"

/* One contact between object a and object b, found by the host this step in a fixed order. */
typedef struct swage_contact {
  uint32_t body_a, shape_a, body_b, shape_b; /* each object's own indices */
  uint64_t feature;                          /* which features touch; equal from step to step while the touch lasts */
  swage_vec3 p_W;                            /* m, midway between the surfaces */
  swage_vec3 n_W;                            /* unit, from b into a */
  double gap;                                /* m, negative when overlapping */
  swage_vec3 f_a_W;                          /* N on a: in finish() of this step, in resolve() of the step before */
  double slip;                               /* m/s tangential speed; same timing as f_a_W */
  /* the law at this contact: a coupling may change these in resolve() */
  double friction;    /* Coulomb coefficient */
  double stiffness;   /* N/m normal compliance of the touching surfaces */
  double restitution; /* 0..1, for what flies free */
} swage_contact;

typedef struct swage_coupling_step {
  uint32_t struct_size, n_contact;
  uint64_t step;
  double time_s, dt_s;
  const swage_object_step* a;
  const swage_object_step* b;
  swage_contact* contact; /* [n_contact] */
  double* state;          /* [n_state] */
  double* signal;         /* [n_signal] */
  uint32_t n_state, n_signal;
  void* host_data;
  void (*event)(const struct swage_coupling_step*, uint32_t event, double value); /* [rt] declared index */
} swage_coupling_step;

#define SWAGE_EXT_COUPLING "swage.coupling/1"
typedef struct swage_coupling {
  const char* const* needs_a; /* traits that object a must offer, NULL-terminated, static */
  const char* const* needs_b;
  uint32_t detects;  /* 1: the host finds contacts between a and b for the solver; 0: this coupling only looks */
  uint32_t reserved;
  swage_result (*bind)(swage_instance*, swage_instance* a, swage_instance* b);   /* [main & !active] after configure */
  swage_result (*resolve)(swage_instance*, const swage_coupling_step*);          /* [rt & active] detected, not solved */
  swage_result (*finish)(swage_instance*, const swage_coupling_step*);           /* [rt & active] solved: forces known */
  void (*reset)(swage_instance*, const swage_coupling_step*);                    /* [rt & active] */
} swage_coupling;

SWAGE_STATIC_ASSERT(sizeof(swage_contact) == 136, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_coupling_step) == 96, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_coupling) == 56, "frozen layout");

#endif
