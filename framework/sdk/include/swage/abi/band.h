/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Swage ABI: an object with one chain whose mechanics is a band. C11 and C++.
 */
#ifndef SWAGE_ABI_BAND_H
#define SWAGE_ABI_BAND_H

#include <swage/abi/object.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Beside swage.object.solver/2, of an object with one chain (SWAGE_HOST_CHAIN) on its one flexible body. Each of the n vertices has four
 * unknowns: its displacement [m], and the rotation [rad] about itself of the segment that begins there. The host then solves
 * contacts, ties, rigid bodies and the chain together, each contact with the weights of its place (swage_chain_place); mobility
 * and apply_impulses are not called. What it costs grows with the contacts and not with their square.
 *
 * Per step: advance, as ever; then, where something is near, linearise and displace. linearise answers the step that begins
 * where advance began, linear about where advance has left the chain: with the change q from there,
 *
 *     stiffness q + gradient = forces of contacts          stiffness = M/h^2 + K, gradient = M/h^2 (x - x_free) + dE/dx
 *
 * stiffness: 4 n columns of SWAGE_BAND_COLUMN numbers; entry k of column j couples the unknowns j and j + k, k up to
 * SWAGE_BAND_REACH (what is beyond the last unknown, and the last number of a column, are 0). It is positive definite: where the
 * host cannot factor it, it asks again with `stiffer` = 1, 2 .. SWAGE_BAND_STIFFER, each of which should be nearer to it. An
 * unknown that stays where it is has a diagonal of 0; so has the rotation at the last vertex. All numbers are 0 on entry.
 * displace hands over the change q and, for the eyes of the object, the impulses at the points, 3 each [N s], that are in it
 * already: write final vertices, velocities, poses and twists. */
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
