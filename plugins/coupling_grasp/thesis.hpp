// SPDX-License-Identifier: Apache-2.0
//
// The grasp as thesis 5.2.1 detects it: not from forces but from how deep both jaws are in one particle of the needle. Kept
// for comparison with the contacts.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "toolkit/math.hpp"

namespace swage::coupling_grasp {

using toolkit::Vec3;

/// The gripping face of one jaw, estimated from its contacts: their mean, weighted by overlap.
struct Face {
  Vec3 p_W = Vec3::Zero(), n_W = Vec3::Zero();  // m, on the face; from the wire into the jaw
  double weight = 0;

  void add(const Vec3& p, const Vec3& n, double overlap) {
    // a contact that only just touches still shows where the face is
    const double w = std::max(overlap, 1e-9);
    p_W += w * p;
    n_W += w * n;
    weight += w;
  }
  void finish() {
    if (weight > 0) p_W /= weight, n_W.normalize();
  }
};

/// One particle of the wire, between both jaws.
struct Particle {
  double left = 0, right = 0;  // m, depth of each face in it
  double overall() const { return left + right; }
  double imbalance() const { return std::abs(left - right) / std::max(left, right); }
};

/// A particle of radius r at p_W, or nothing when a jaw does not reach it. `skin` [m]: jaws of the thesis entered the needle
/// before anything resisted; ours stop at its surface, so a face counts as inside a particle from this distance outside on.
inline std::optional<Particle> particle(const Face& left, const Face& right, const Vec3& p_W, double radius,
                                        double skin) {
  const Particle out{radius + skin - left.n_W.dot(left.p_W - p_W),
                     radius + skin - right.n_W.dot(right.p_W - p_W)};
  return out.left > 0 && out.right > 0 ? std::optional(out) : std::nullopt;
}

/// Keeps the particle by which the thesis grasps: of those that both jaws enter evenly, the one entered deepest; while there
/// is none, the most even one, so that there is a value to report.
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
