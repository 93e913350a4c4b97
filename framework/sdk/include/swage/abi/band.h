/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Swage ABI: an object with one chain whose stiffness matrix is a band. C11 and C++.
 */
#ifndef SWAGE_ABI_BAND_H
#define SWAGE_ABI_BAND_H

#include <swage/abi/object.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Offered beside swage.object.solver/2 by an object with one chain (SWAGE_HOST_CHAIN) on its one flexible body. Each of the n vertices
 * has four unknowns: its displacement [m], and the rotation [rad] of the segment that begins there about its own axis. The host then solves
 * contacts, ties, rigid bodies and the chain together, each contact with the weights of its place (swage_chain_place); mobility
 * and apply_impulses are not called. The cost of a step is linear in the number of contacts.
 *
 * Per step: advance, as for every solver; then, where a contact or tie is possible, linearise and displace. linearise returns the
 * equations of the same step (from the state where advance began), linearised at the vertices x that advance wrote. q: the change of x.
 *
 *     stiffness q + gradient = forces of contacts          stiffness = M/h^2 + K, gradient = M/h^2 (x - x_free) + dE/dx
 *
 * stiffness: 4 n columns of SWAGE_BAND_COLUMN numbers; entry k of column j couples the unknowns j and j + k, k up to
 * SWAGE_BAND_REACH (entries beyond the last unknown, and the last number of a column, are 0). It must be positive definite: where the
 * host cannot factor it, it calls again with `stiffer` = 1, 2 .. SWAGE_BAND_STIFFER, each time for a matrix nearer to positive definite. It may
 * begin at another number than 0, and go down as long as it can factor what it gets: the answer depends on `stiffer` and the state alone.
 * An unknown that is held fixed has a diagonal of 0; so has the rotation at the last vertex. All numbers are 0 on entry.
 * displace gets the change q and writes final vertices, velocities, poses and twists. The impulses at the points, 3 each [N s], are
 * already part of q; they are passed for the object's information. */
#define SWAGE_EXT_BAND "swage.object.band/1"
#define SWAGE_BAND_UNKNOWNS 4
#define SWAGE_BAND_REACH 10
#define SWAGE_BAND_COLUMN 12
#define SWAGE_BAND_STIFFER 14
typedef struct swage_band {
  swage_result (*linearise)(swage_instance*, const swage_object_step*, uint32_t stiffer, double* stiffness,
                            double* gradient); /* [rt] */
  swage_result (*displace)(swage_instance*, const swage_object_step*, const double* change, uint32_t n,
                           const swage_contact_point* point, const swage_chain_place* place,
                           const double* impulse); /* [rt] */
} swage_band;
SWAGE_STATIC_ASSERT(sizeof(swage_band) == 16, "frozen layout");

#ifdef __cplusplus
}
#endif
#endif
