/* SPDX-License-Identifier: Apache-2.0
 *
 * swage/abi/coupling.h - a coupling: the interaction of two objects. It names traits, never plugins.
 */
#ifndef SWAGE_ABI_COUPLING_H
#define SWAGE_ABI_COUPLING_H

#include "object.h"

/* One contact between object a and object b, found by the host this step in a fixed order. */
typedef struct swage_contact {
  uint32_t body_a, shape_a, body_b, shape_b; /* each object's own indices */
  uint64_t feature;                          /* id of the two touching features; constant while the contact lasts */
  swage_vec3 p_W;                            /* m, midway between the surfaces */
  swage_vec3 n_W;                            /* unit, from b into a */
  double gap;                                /* m, negative when overlapping */
  swage_vec3 f_a_W;                          /* N on a: in finish() of this step, in resolve() of the step before */
  double slip;                               /* m/s tangential speed; same timing as f_a_W */
  /* the law at this contact: a coupling may change these in resolve() */
  double friction;    /* Coulomb coefficient */
  double stiffness;   /* N/m, normal, of the touching surfaces; 0: this contact bears no force */
  double restitution; /* 0..1, of impacts of bodies that are not held */
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
  uint32_t detects;  /* 1: the host finds contacts between a and b for the solver; 0: this coupling only observes */
  uint32_t reserved;
  swage_result (*bind)(swage_instance*, swage_instance* a, swage_instance* b);   /* [main & !active] after configure */
  swage_result (*resolve)(swage_instance*, const swage_coupling_step*);          /* [rt & active] detected, not solved */
  swage_result (*finish)(swage_instance*, const swage_coupling_step*);           /* [rt & active] solved: forces known */
  void (*reset)(swage_instance*, const swage_coupling_step*);                    /* [rt & active] */
} swage_coupling;

/* A compliant constraint between a body of object a and one of object b, solved together with the contacts. Along its axis it is
 * a spring that slides beyond a limit (bristle friction); across the axis it is a spring that yields beyond its strength. With s the
 * displacement of a relative to b from the rest position of the tie:
 *     f_along  = clamp(-stiffness_along s_along, -forward_limit, backward_limit)
 *     f_across = -stiffness_across s_across, returned radially to `strength` */
typedef struct swage_tie {
  uint32_t body_a, body_b;   /* each object's own indices; SWAGE_NONE: the world */
  swage_vec3 p_W;            /* m, point of action on both; on a flexible b it is p_W less the part of offset_W across the axis */
  swage_vec3 axis_W;         /* unit, sliding direction of a along b; turns with a, and on_solved() gets it turned */
  swage_vec3 offset_W;       /* m, s at the poses of resolve() */
  double stiffness_across;   /* N/m */
  double stiffness_along;    /* N/m */
  double strength;           /* N, greatest force across the axis; HUGE_VAL: it never yields */
  double forward_limit;      /* N, greatest force against a motion of a along +axis; HUGE_VAL: it never slides */
  double backward_limit;     /* N, the same against a motion of a along -axis */
  swage_vec3 f_a_W;          /* N on a; written by the host before on_solved(). In ties(): that of the step before, where the solve starts; 0: not known */
  swage_vec3 plastic_slip_W; /* m, plastic part of s: slip along the axis, yield across it; same timing */
} swage_tie;

/* Offered by a coupling with ties; their rest positions are its own state. Order: resolve, ties, the solve, on_solved, finish. */
#define SWAGE_EXT_TIES "swage.coupling.ties/1"
typedef struct swage_ties {
  swage_result (*ties)(swage_instance*, const swage_coupling_step*, uint32_t capacity, swage_tie* out, uint32_t* n); /* [rt] */
  swage_result (*on_solved)(swage_instance*, const swage_coupling_step*, uint32_t n, const swage_tie* tie); /* [rt] the solved ties */
} swage_ties;

SWAGE_STATIC_ASSERT(sizeof(swage_contact) == 136, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_tie) == 168, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_ties) == 16, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_coupling_step) == 96, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_coupling) == 56, "frozen layout");

#endif
