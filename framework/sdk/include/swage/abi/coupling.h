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
  double stiffness;   /* N/m normal compliance of the touching surfaces; 0: here they pass through each other */
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

/* A compliant link between a body of object a and one of object b, solved together with the contacts. Along its axis it sticks like
 * a bristle and slides beyond a limit; across it is a spring that gives way beyond its strength. With s the displacement of a
 * against b from where the tie is at rest:
 *     f_along  = clamp(-stiffness_along s_along, -forward_limit, backward_limit)
 *     f_across = -stiffness_across s_across, returned radially to `strength` */
typedef struct swage_tie {
  uint32_t body_a, body_b;   /* each object's own indices; SWAGE_NONE: the world */
  swage_vec3 p_W;            /* m, where it acts on both; a b with a solver of its own gives at p_W less what offset_W is across */
  swage_vec3 axis_W;         /* unit, direction in which a slides along b; turns with a, and on_solved() sees it turned */
  swage_vec3 offset_W;       /* m, s at the poses that resolve() sees */
  double stiffness_across;   /* N/m */
  double stiffness_along;    /* N/m */
  double strength;           /* N, most that it holds across the axis; HUGE_VAL: it never gives way */
  double forward_limit;         /* N, most that it holds back a moving along +axis; HUGE_VAL: it never slides */
  double backward_limit;          /* N, the same for a moving along -axis */
  swage_vec3 f_a_W;          /* N on a; written by the host before on_solved() */
  swage_vec3 plastic_slip_W;         /* m, the part of s that it gave up: slid along the axis, torn across it; same timing */
} swage_tie;

/* Offered by a coupling that has such links; anchors and bristles are its own state. resolve, then ties; the solve; on_solved, then finish. */
#define SWAGE_EXT_TIES "swage.coupling.ties/1"
typedef struct swage_ties {
  swage_result (*ties)(swage_instance*, const swage_coupling_step*, uint32_t capacity, swage_tie* out, uint32_t* n); /* [rt] */
  swage_result (*on_solved)(swage_instance*, const swage_coupling_step*, uint32_t n, const swage_tie* tie); /* [rt] same, solved */
} swage_ties;

SWAGE_STATIC_ASSERT(sizeof(swage_contact) == 136, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_tie) == 168, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_ties) == 16, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_coupling_step) == 96, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_coupling) == 56, "frozen layout");

#endif
