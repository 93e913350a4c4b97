// SPDX-License-Identifier: Apache-2.0
//
// The grasp as thesis 5.2.1 finds it: not from forces but from how far both jaws go into one particle of the needle. Kept
// to be compared with the contacts.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "toolkit/math.hpp"

namespace swage::coupling_grasp {

using toolkit::Vec3;

/// The gripping face of one jaw as its contacts show it: their mean, weighted by overlap.
struct Face {
  Vec3 p_W = Vec3::Zero(), n_W = Vec3::Zero();  // m, on the face; from the wire into the jaw
  double weight = 0;

  void add(const Vec3& p, const Vec3& n, double overlap) {
    // what only just touches still shows where the face is
    const double w = std::max(overlap, 1e-9);
    p_W += w * p;
    n_W += w * n;
    weight += w;
  }
  void finish() {
    if (weight > 0) p_W /= weight, n_W.normalize();
  }
};

/// One particle of the wire between both jaws.
struct Particle {
  double left = 0, right = 0;  // m, how far each face is inside it
  double overall() const { return left + right; }
  double imbalance() const { return std::abs(left - right) / std::max(left, right); }
};

/// A particle of radius r at p, or nothing when a jaw does not reach it. `skin`: jaws of the thesis went into the needle
/// before anything resisted; ours stop at it, so a face counts as inside a particle from so far outside on.
inline std::optional<Particle> particle(const Face& left, const Face& right, const Vec3& p_W, double radius,
                                        double skin) {
  const Particle out{radius + skin - left.n_W.dot(left.p_W - p_W),
                     radius + skin - right.n_W.dot(right.p_W - p_W)};
  return out.left > 0 && out.right > 0 ? std::optional(out) : std::nullopt;
}

/// Keeps the particle that the thesis grasps by: of those that both jaws enter evenly the one entered deepest; while there
/// is none, the most even one, so that there is something to say.
struct Choice {
  Particle best;
  int index = -1;
  bool even = false;

  void offer(const Particle& p, int i, double balance) {
    const bool is_even = p.imbalance() <= balance;
    const bool better =
        index < 0 || (is_even && !even) ||
        (is_even == even && (even ? p.overall() > best.overall() : p.imbalance() < best.imbalance()));
    if (!better) return;
    best = p;
    index = i;
    even = is_even;
  }
};

}  // namespace swage::coupling_grasp
