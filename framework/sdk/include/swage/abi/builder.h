/* SPDX-License-Identifier: Apache-2.0
 *
 * swage/abi/builder.h - everything an instance will ever own is declared here, once, during configure. [main]
 *
 * Indices that the builder returns count per instance from 0. SWAGE_NONE reports a refused declaration; the builder has
 * then recorded why. Declared poses are in the object's own frame O; the lesson file places O in the world.
 */
#ifndef SWAGE_ABI_BUILDER_H
#define SWAGE_ABI_BUILDER_H

#include "plugin.h"

#define SWAGE_NONE 0xFFFFFFFFu

/* How a body moves. */
#define SWAGE_MOTION_FIXED 0   /* never */
#define SWAGE_MOTION_FOLLOWS 1 /* takes the pose of the device that the lesson binds to the object; speed-limited, swept */
#define SWAGE_MOTION_DYNAMIC 2 /* integrated by the host under forces and contacts */
#define SWAGE_MOTION_HINGED 3  /* one angle about an axis fixed in its parent, with a force-limited drive (see hinge) */
#define SWAGE_MOTION_FLEXIBLE 4 /* moved by the object's own solver: extension swage.object.solver/1 */

/* Kinds of declaration for declare(); each counts its own indices. */
#define SWAGE_DECLARE_SIGNAL 1 /* a number per step, e.g. "grasp.force" in "N" */
#define SWAGE_DECLARE_METRIC 2 /* LESSON: a result, e.g. "grasp.tries" in "1" */
#define SWAGE_DECLARE_CUE 3    /* LESSON: a meaning, e.g. "grasp.good"; never a colour */
#define SWAGE_DECLARE_EVENT 4  /* COUPLING, LESSON: something that happened, e.g. "grasp.taken" */
#define SWAGE_DECLARE_PHASE 5  /* LESSON: a stage of the task, e.g. "approach" */

/* Flags of a shape. */
#define SWAGE_SHAPE_COLLIDES 1u
#define SWAGE_SHAPE_DRAWN 2u
#define SWAGE_SHAPE_USUAL 3u

/* Kinds of shape. */
#define SWAGE_SHAPE_SPHERE 1
#define SWAGE_SHAPE_CAPSULE 2
#define SWAGE_SHAPE_ARC 3    /* circular-arc capsule: the exact surface of a bent wire */
#define SWAGE_SHAPE_CONVEX 4 /* convex polyhedron given by vertices and planar faces */
#define SWAGE_SHAPE_CYLINDER 5 /* flat ends */
#define SWAGE_SHAPE_HEIGHT_FIELD 6 /* a surface over a grid; see SWAGE_HOST_HEIGHT_FIELD */
#define SWAGE_SHAPE_CHAIN 7 /* a flexible wire of many pieces, moved by its object; see SWAGE_HOST_CHAIN */

/* Mass of a dynamic body. Its frame B must sit at the centre of mass with axes along the principal axes of inertia. */
typedef struct swage_mass {
  double mass;        /* kg */
  swage_vec3 inertia; /* principal moments about B's origin, kg m2 */
} swage_mass;

/* Circular arc of angle `sweep` and radius `radius` about the z axis of frame A, from A's +x axis counter-clockwise,
 * thickened to a tube of radius `wire_radius`, with spherical ends. Arc coordinate 0 is the start, 1 the end. */
typedef struct swage_arc {
  swage_pose X_BA;
  double radius;      /* m, of the centre line */
  double sweep;       /* rad, (0, 2 pi) */
  double wire_radius; /* m */
} swage_arc;

/* Convex polyhedron. Face i has the vertices face_vertex[face_start[i] .. face_start[i + 1]), counter-clockwise seen from
 * outside; face_start has n_face + 1 entries. */
typedef struct swage_convex {
  uint32_t n_vertex, n_face;
  const double* vertex; /* 3 n_vertex, in B, m */
  const uint32_t* face_start;
  const uint32_t* face_vertex;
} swage_convex;

/* One angle about `axis`, through `anchor`, both in the parent's frame; angle 0 is the declared start pose of the child.
 * Each step the object writes a swage_drive (object.h). */
typedef struct swage_hinge {
  uint32_t parent, child; /* bodies; the child has SWAGE_MOTION_HINGED */
  swage_vec3 anchor;      /* m, in the parent */
  swage_vec3 axis;        /* unit, in the parent */
  double inertia;         /* kg m2 about the axis, reflected mass of the handle included */
  double min, max;        /* rad */
} swage_hinge;

struct swage_builder {
  uint32_t struct_size, reserved;
  void* host_data;
  /* X_OB: start pose in the object's frame. mass: for DYNAMIC bodies, NULL otherwise. */
  uint32_t (*body)(swage_builder*, int32_t motion, const swage_pose* X_OB, const swage_mass* mass, const char* name);
  /* n point masses integrated by the host; 3 n positions in O [m], n masses [kg]; returns the first index. */
  uint32_t (*particles)(swage_builder*, uint32_t n, const double* p_O, const double* mass, double radius);
  uint32_t (*sphere)(swage_builder*, uint32_t body, swage_vec3 centre, double radius, uint32_t flags);
  uint32_t (*capsule)(swage_builder*, uint32_t body, swage_vec3 a, swage_vec3 b, double radius, uint32_t flags);
  uint32_t (*cylinder)(swage_builder*, uint32_t body, swage_vec3 a, swage_vec3 b, double radius, uint32_t flags);
  uint32_t (*arc)(swage_builder*, uint32_t body, const swage_arc* arc, uint32_t flags);
  uint32_t (*convex)(swage_builder*, uint32_t body, const swage_convex* convex, uint32_t flags);
  uint32_t (*hinge)(swage_builder*, const swage_hinge* hinge);
  /* n private doubles, kept, saved, restored and hashed by the host, passed as `state` to every [rt] call. */
  uint32_t (*state)(swage_builder*, uint32_t n);
  /* what: SWAGE_DECLARE_*; id: dotted lower case; unit: SI, "1" for a pure number; doc: one sentence. */
  uint32_t (*declare)(swage_builder*, int32_t what, const char* id, const char* unit, const char* doc);
  /* Reports a problem with a parameter ("" for the whole instance); several may be reported before configure fails. */
  void (*error)(swage_builder*, const char* param_id, const char* message);
};

/* Surface over a grid in frame H: vertex (i, j) at (i dx, j dy, height[j nx + i]), outside +z. Each cell is cut from its
 * vertex (i, j) to (i + 1, j + 1) into two triangles. A surface that changes keeps its heights in nx ny of the instance's
 * private doubles: declare them with state(), name the first here, and write them in reset and whenever they change;
 * contacts are found on the present heights. */
typedef struct swage_height_field {
  swage_pose X_BH;
  uint32_t nx, ny;      /* vertices, 2 to 129 */
  double dx, dy;        /* m, sides of a cell */
  double below;         /* m, > 0: thickness of the solid under the surface; a centre line deeper than that has no contact */
  const double* height; /* nx ny, m: for drawing, and for contacts where `state` is SWAGE_NONE */
  uint32_t state;       /* first of nx ny private doubles with the heights, or SWAGE_NONE */
  uint32_t reserved;
} swage_height_field;

/* Declares height fields. A table that the host offers, see swage_host.get_extension. */
#define SWAGE_HOST_HEIGHT_FIELD "swage.host.height_field/1"
typedef struct swage_host_height_field {
  uint32_t (*declare)(swage_builder*, uint32_t body, const swage_height_field*, uint32_t flags); /* [main] in configure */
} swage_host_height_field;

/* Capacities of a step of this scene. What exceeds them is counted in the health record of the loop: contacts beyond `points`
 * of one flexible body share the nearest point; beyond `rows` of one island the shallowest contacts bear no force. */
typedef struct swage_capacities {
  uint32_t struct_size;
  uint32_t contacts; /* of a step */
  uint32_t ties;     /* of all couplings in a step (swage_tie) */
  uint32_t points;   /* contact points of one object with swage.object.solver */
  uint32_t rows;     /* contacts and ties of one island with such an object */
  uint32_t bodies;   /* of the scene */
} swage_capacities;

/* Reads the capacities of the scene and reserves contact points. A table that the host offers, see swage_host.get_extension. */
#define SWAGE_HOST_CAPACITIES "swage.host.capacities/1"
typedef struct swage_host_capacities {
  /* Reserves room for so many contact points of this object at once, up to 256. Returns the number that each of its bodies gets,
   * 0 on failure. [main] in configure */
  uint32_t (*reserve_points)(swage_builder*, uint32_t points);
  /* Capacities of the whole scene; final from activate on. Writes at most struct_size bytes. [any] */
  void (*read)(const swage_host*, swage_capacities* out);
} swage_host_capacities;

SWAGE_STATIC_ASSERT(sizeof(swage_capacities) == 24, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_host_capacities) == 16, "frozen layout");
/* A flexible wire (thread, rubber band): pieces between neighbouring vertices, thickened, with round joints and ends.
 *
 * Its present shape lies in 8 n_vertex of the instance's private doubles, declared with state(); `state` is the first of them:
 *   [3 n] positions in W, m        [3 n] velocities in W, m/s        [n] arc lengths s, m        [n] radii, m
 * reset() finds them as declared, at rest; the object writes them in its solver calls. Velocity times dt is the displacement of the
 * vertex over the step. s is the material coordinate: it increases along the chain, identifies the material at a vertex, and
 * changes where an object moves its vertices along its material; friction stores its anchors by s. The radius is
 * that of the piece that begins at the vertex; 0: there is no piece, as where a thread is cut. */
#define SWAGE_CHAIN_SEGMENTS 1 /* straight pieces; circular arcs will be another kind */
typedef struct swage_chain {
  uint32_t kind;          /* SWAGE_CHAIN_SEGMENTS */
  uint32_t n_vertex;      /* 2 to 513 */
  const double* p_B;      /* 3 n_vertex, m: start positions in B; neighbours are distinct */
  const double* s;        /* n_vertex, m, increasing; NULL: the arc length along p_B */
  const double* radius;   /* n_vertex - 1, m, >= 0: of each piece */
  double bend_radius;     /* m, > 0: least radius of curvature of the chain. Two places have no contact with each other if they are
                           * nearer along the chain than half a circle of this radius or of the wire's, the larger */
  uint32_t state;         /* first of 8 n_vertex private doubles */
  uint32_t reserved;
} swage_chain;

/* Declares chains. A table that the host offers, see swage_host.get_extension. The body must have SWAGE_MOTION_FLEXIBLE. Contacts
 * of a chain with itself are found where a coupling joins the object with itself. */
#define SWAGE_HOST_CHAIN "swage.host.chain/1"
typedef struct swage_host_chain {
  uint32_t (*declare)(swage_builder*, uint32_t body, const swage_chain*, uint32_t flags); /* [main] in configure */
} swage_host_chain;

SWAGE_STATIC_ASSERT(sizeof(swage_mass) == 32, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_arc) == 80, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_convex) == 32, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_hinge) == 80, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_builder) == 104, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_height_field) == 104, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_host_height_field) == 8, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_chain) == 48, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_host_chain) == 8, "frozen layout");

#endif
