// SPDX-License-Identifier: Apache-2.0
//
// The contacts of one step, in a fixed order, and the memory of each from step to step.
#pragma once

#include <cstdint>
#include <vector>

#include "contact/candidate.hpp"
#include "scene/chain.hpp"
#include "scene/world.hpp"
#include "toolkit/math.hpp"

namespace swage::contact {

using toolkit::Vec3;

/// Law of the touching surfaces.
struct Law {
  double friction = 0.3;  // Coulomb coefficient
  double stiffness =
      1e6;  // N/m, normal, at one contact of weight 1 (Hertz scale of a 0.1 mm steel wire: 7e5)
  double restitution = 0.0;  // 0..1
};

/// Two objects that may touch, because a coupling says so. Order = order of the couplings in the lesson file.
struct Pair {
  uint32_t object_a = scene::kNone, object_b = scene::kNone;
  Law law;
};

using scene::ChainPlace;

/// One contact point between surface a and surface b.
struct Contact {
  uint32_t pair = 0;
  uint32_t shape_a = 0, shape_b = 0;  // global
  uint32_t body_a = 0, body_b = 0;    // global
  /// A particle instead of a body and its shape (then kNone): global. Its candidate's frame is at the particle, along the axes of W.
  uint32_t particle_a = scene::kNone, particle_b = scene::kNone;
  ChainPlace place_a, place_b;  // on shape a and b, where those are chains
  uint64_t feature = 0;      // which features and which quadrature point; equal while the touch lasts
  Vec3 p_W = Vec3::Zero();   // m, midway between the surfaces
  Vec3 n_W = Vec3::UnitZ();  // unit, from b into a
  double gap = 0;            // m, negative when overlapping
  double weight = 1;         // share of a line contact that this point stands for, 0..1
  Law law;
  // --- memory, part of the saved state
  Vec3 bristle_W = Vec3::Zero();  // m, elastic tangential displacement of a against b
  // --- results of the last solve
  Vec3 f_a_W = Vec3::Zero();  // N on a
  double slip = 0;            // m/s, tangential speed
};

/// All contacts of a step: pair by pair, shape by shape, feature by feature. Capacity is reserved on [main].
struct ContactSet {
  std::vector<Contact> contact;
  std::vector<Candidate> candidate;   // one per contact: finds its gap again at trial poses (candidate.hpp)
  std::vector<scene::Range> of_pair;  // one per Pair
  uint64_t dropped = 0;  // contacts of this step beyond the capacity, counted and reported, never silently lost
};

}  // namespace swage::contact
