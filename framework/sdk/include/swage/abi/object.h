/* SPDX-License-Identifier: Apache-2.0
 *
 * swage/abi/object.h - an object: its bodies, the forces on them, and their response to impulses.
 *
 * Most objects declare bodies or particles and add forces; the host integrates them and solves their contacts. An object
 * with inner mechanics (beam, thread, tissue) offers swage.object.solver/1 and moves its flexible bodies itself.
 */
#ifndef SWAGE_ABI_OBJECT_H
#define SWAGE_ABI_OBJECT_H

#include "builder.h"

/* Values of the bound device channels in this step. */
typedef struct swage_input {
  swage_pose X_WD;    /* pose of the hand in the scene, after scaling */
  double closure;     /* 0 open .. 1 closed */
  double grip_force;  /* N at the handle; 0 when the device does not measure it */
  uint32_t buttons;   /* bit mask */
  uint32_t valid;     /* SWAGE_VALID_* of device.h: which of the above were measured */
} swage_input;

/* Force-limited drive of a hinge: torque = clamp(stiffness (target - angle) - damping rate, +- max_torque), implicit. */
typedef struct swage_drive {
  double target;     /* rad */
  double stiffness;  /* N m / rad */
  double damping;    /* N m s / rad */
  double max_torque; /* N m */
} swage_drive;

/* View of one object in a step. Arrays are the host's, valid for the call; index i is the i-th declared item. */
typedef struct swage_object_step {
  uint32_t struct_size, reserved;
  uint64_t step;
  double time_s, dt_s;
  double scene_length;          /* m, characteristic length of the scene; tolerances are relative to it */
  swage_vec3 gravity;           /* m/s2 in W; the host applies it to dynamic bodies and particles itself */
  const swage_input* input;     /* NULL when no device is bound */
  swage_pose* X_WB;             /* [n_body]; writable for flexible bodies in solver calls only */
  swage_twist* V_WB;            /* [n_body]; same */
  swage_wrench* F_B_W;          /* [n_body] add to it in forces() */
  double* particle_p_W;         /* [3 n_particle] read */
  double* particle_v_W;         /* [3 n_particle] read */
  double* particle_f_W;         /* [3 n_particle] add to it in forces() */
  const double* hinge_angle;    /* [n_hinge] rad */
  const double* hinge_rate;     /* [n_hinge] rad/s */
  const double* hinge_torque;   /* [n_hinge] N m that contacts put on the hinge in the last step */
  swage_drive* drive;           /* [n_hinge] write in forces() */
  double* state;                /* [n_state] */
  double* signal;               /* [n_signal] write in finish() */
  uint32_t n_body, n_particle, n_hinge, n_state, n_signal, reserved1;
} swage_object_step;

#define SWAGE_EXT_OBJECT "swage.object/1"
typedef struct swage_object {
  swage_result (*forces)(swage_instance*, const swage_object_step*); /* [rt & active] before contacts */
  swage_result (*finish)(swage_instance*, const swage_object_step*); /* [rt & active] after integration */
  void (*reset)(swage_instance*, const swage_object_step*);          /* [rt & active] state back to the start */
} swage_object;

/* A point at which a contact or a tie acts on a flexible body. */
typedef struct swage_contact_point {
  uint32_t body, shape; /* the object's own indices; shape is SWAGE_NONE for a tie */
  swage_vec3 p_W;       /* m */
  swage_vec3 n_W;       /* unit, pointing into the object; of a tie: its axis */
} swage_contact_point;

/* Mechanics of flexible bodies. Per step: advance, then mobility for all contact points at once, then apply_impulses. advance
 * makes the whole free motion: without contacts and ties its poses are final and the other two are not called. Contacts are
 * found on the poses that advance wrote. reset comes before the first step, with the flexible bodies at their start poses.
 * mobility returns v_free and W of the velocities v = v_free + W j under impulses j. W is symmetric, positive semi-definite, 3n x 3n
 * row-major [m/s per N s], points stacked xyz. It may be called again in a step, for more points: only apply_impulses counts. */
#define SWAGE_EXT_SOLVER "swage.object.solver/1"
typedef struct swage_solver {
  swage_result (*advance)(swage_instance*, const swage_object_step*); /* [rt] free motion; write flexible poses and twists */
  swage_result (*mobility)(swage_instance*, const swage_object_step*, uint32_t n, const swage_contact_point* point,
                             double* v_free, double* W);              /* [rt] v_free: 3n, m/s */
  swage_result (*apply_impulses)(swage_instance*, const swage_object_step*, uint32_t n, const swage_contact_point* point,
                        const double* impulse); /* [rt] 3n, N s on the object; write final flexible poses and twists */
} swage_solver;

/* Where on a chain (SWAGE_HOST_CHAIN) a contact point is: on the centre line at (1 - share) p[segment] + share p[segment + 1].
 * Those are the weights with which the two vertices move it; p_W - centre line is its arm about the wire. */
typedef struct swage_chain_place {
  uint32_t segment;  /* of the chain, from 0; SWAGE_NONE: the point is on no chain */
  uint32_t reserved;
  double share;      /* 0..1 */
  double s;          /* m, arc length */
} swage_chain_place;

/* The solver of an object with chains: the same functions, with the place of each point on its chain. For an object that offers
 * this extension swage.object.solver/1 is not used. */
#define SWAGE_EXT_SOLVER_2 "swage.object.solver/2"
typedef struct swage_solver_2 {
  swage_result (*advance)(swage_instance*, const swage_object_step*); /* [rt] */
  swage_result (*mobility)(swage_instance*, const swage_object_step*, uint32_t n, const swage_contact_point* point,
                             const swage_chain_place* place, double* v_free, double* W); /* [rt] */
  swage_result (*apply_impulses)(swage_instance*, const swage_object_step*, uint32_t n, const swage_contact_point* point,
                        const swage_chain_place* place, const double* impulse); /* [rt] */
} swage_solver_2;

/* Offered beside a solver by an object whose surface differs from its shapes, as tissue that has not recovered from an earlier contact.
 * Called together with mobility, for the same points. u_W: 3n, m, displacement of the free surface from the shape at each
 * point. Its component along the normal of a contact changes the gap; v_free remains the velocity of the point in this step. */
#define SWAGE_EXT_SURFACE "swage.object.surface/1"
typedef struct swage_surface {
  swage_result (*displacement)(swage_instance*, const swage_object_step*, uint32_t n, const swage_contact_point* point,
                               double* u_W); /* [rt] */
} swage_surface;

/* Traits: interfaces through which a coupling uses an object of any plugin. Offered through get_extension under the trait's id and
 * listed in the descriptor. A trait without functions is a promise only: get_extension returns any non-NULL pointer. */
#define SWAGE_TRAIT_SOLID "swage.trait.solid/1" /* its COLLIDES shapes resist penetration */

#define SWAGE_TRAIT_GRASPABLE "swage.trait.graspable/1"
typedef struct swage_graspable_place {
  double s;             /* 0 at the point .. 1 at the swage, along the body; 0.5 for objects without ends */
  double length;        /* m, arc length that s spans */
  swage_vec3 p_W;       /* m, nearest place on the centre line */
  swage_vec3 tangent_W; /* unit, towards the swage */
  swage_vec3 normal_W;  /* unit, normal of the plane of the curve; perpendicular to the tangent */
} swage_graspable_place;
typedef struct swage_graspable {
  swage_result (*locate)(swage_instance*, const swage_object_step*, swage_vec3 p_W, swage_graspable_place* out); /* [rt] */
} swage_graspable;

#define SWAGE_TRAIT_GRIPPER "swage.trait.gripper/1"
typedef struct swage_gripper_state {
  uint32_t left_body, right_body; /* indices of the jaws */
  swage_vec3 tip_W;               /* m, middle of the two tips */
  swage_vec3 axis_W;              /* unit, hinge to tip */
  swage_vec3 closing_W;           /* unit, from the right jaw to the left */
  double opening;                 /* rad between the jaws */
  double closure;                 /* 0..1 as commanded */
} swage_gripper_state;
typedef struct swage_gripper {
  swage_result (*describe)(swage_instance*, const swage_object_step*, swage_gripper_state* out); /* [rt] */
} swage_gripper;

#define SWAGE_TRAIT_PIERCING "swage.trait.piercing/1"
typedef struct swage_piercing_place {
  double s;               /* 0 at the point .. 1 at the swage */
  double length;          /* m, arc length that s spans */
  double radius;          /* m, of the wire there */
  swage_vec3 p_W;         /* m, on the centre line */
  swage_vec3 tangent_W;   /* unit, towards the swage */
  uint32_t body;          /* the object's own index: which body is there */
  uint32_t reserved;
} swage_piercing_place;
typedef struct swage_piercing {
  swage_result (*place)(swage_instance*, const swage_object_step*, double s, swage_piercing_place* out);          /* [rt] */
  swage_result (*nearest)(swage_instance*, const swage_object_step*, swage_vec3 p_W, swage_piercing_place* out); /* [rt] */
} swage_piercing;

#define SWAGE_TRAIT_PIERCEABLE "swage.trait.pierceable/1"
typedef struct swage_pierceable_law {
  double stiffness;      /* N/m, of a contact with its surface: force = (stiffness + stiffening x) x at an overlap x */
  double stiffening;     /* N/m2 */
  double friction;       /* Coulomb coefficient, on the surface and inside */
  double puncture_force; /* N, normal force at which a sharp point perpendicular to the surface punctures it */
  double cutting_force;  /* N, on a point that advances through the tissue */
  double drag;           /* N per m of inserted length */
  double side_stiffness; /* N/m per m of inserted length, across the needle */
  double failure_stress; /* Pa, mean pressure on the needle's side at which the tissue tears */
} swage_pierceable_law;
typedef struct swage_pierceable_place {
  double depth;        /* m below the entry surface, negative outside */
  double beyond;       /* m from the far surface, negative inside and before it */
  double edge;         /* m, distance inside the rim and the edges of a slit, negative beyond them */
  swage_vec3 p_W;      /* m, the nearest place of the entry surface */
  swage_vec3 normal_W; /* unit, of the entry surface, out of the tissue */
  uint32_t body;       /* the object's own index: which body is there */
  uint32_t reserved;
} swage_pierceable_place;
typedef struct swage_pierceable {
  swage_result (*law)(swage_instance*, const swage_object_step*, swage_pierceable_law* out); /* [rt] */
  swage_result (*locate)(swage_instance*, const swage_object_step*, swage_vec3 p_W, swage_pierceable_place* out); /* [rt] */
} swage_pierceable;

SWAGE_STATIC_ASSERT(sizeof(swage_input) == 80, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_drive) == 32, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_object_step) == 192, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_contact_point) == 56, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_chain_place) == 24, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_graspable_place) == 88, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_gripper_state) == 96, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_piercing_place) == 80, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_pierceable_law) == 64, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_pierceable_place) == 80, "frozen layout");

#endif
