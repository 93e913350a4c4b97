/* SPDX-License-Identifier: Apache-2.0
 *
 * swage/abi/spheres.h - a chain that is touched at its vertices only.
 */
#ifndef SWAGE_ABI_SPHERES_H
#define SWAGE_ABI_SPHERES_H

/* A kind of chain (swage_chain, builder.h) beside SWAGE_CHAIN_SEGMENTS: point masses, each with a sphere of the radius of the piece that
 * begins there. Nothing is touched between them, and what goes farther in a step than they are thick passes. A radius of 0 takes the piece
 * away; its vertices belong to the pieces beside it. For models that are compared with others: the thesis's suture (4.2.1) is such a chain. */
#define SWAGE_CHAIN_SPHERES 2

#endif
