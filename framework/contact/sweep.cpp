// SPDX-License-Identifier: Apache-2.0
#include "contact/sweep.hpp"

#include <algorithm>

namespace swage::contact {
namespace {

/// Each advance closes a fixed share of the gap when bodies approach head on: 3 or 4 are usual. Sliding ones take more.
constexpr int kMaxAdvances = 48;

/// How points of a move against b from time t on, per step: no faster than v + anything of length `spin` + `bend`.
///   v(p) = v(c) + (w_a - w_b) x (p - c), c the centre of a, so spin = |w_a - w_b| bound(a);
///   v(c) changes by less than bend = |w_a|^2 r + |w_b| (|d_a - d_b| + |w_a| r), r the arm of c in its body.
struct RelativeMotion {
  Vec3 v = Vec3::Zero();  // m
  double spin = 0, bend = 0;

  RelativeMotion(const Solid& a, const Motion& motion_a, const Pose& X_WA, const Motion& motion_b,
                 const Pose& X_WB) {
    const Vec3 r = X_WA.q * a.centre;
    v = motion_a.d + motion_a.turn.cross(r) - motion_b.d - motion_b.turn.cross(X_WA.p + r - X_WB.p);
    const double w_a = motion_a.turn.norm(), w_b = motion_b.turn.norm(), arm = r.norm();
    spin = (motion_a.turn - motion_b.turn).norm() * a.bound;
    bend = w_a * w_a * arm + w_b * ((motion_a.d - motion_b.d).norm() + w_a * arm);
  }
  double speed() const { return v.norm() + spin + bend; }
  double closing(const Vec3& n) const { return -n.dot(v) + spin + bend; }
};

/// Width of the empty slab across n between b (below) and a (above); negative when they overlap along n.
double slab(const Solid& a, const Frame& X_WA, const Solid& b, const Frame& X_WB, const Vec3& n) {
  return n.dot(X_WA.p - X_WB.p) - support(a, -X_WA.turn_back(n)) - support(b, X_WB.turn_back(n));
}

}  // namespace

double relative_motion(const Solid& a, const Motion& motion_a, const Motion& motion_b) noexcept {
  return RelativeMotion(a, motion_a, motion_a.X0, motion_b, motion_b.X0).speed();
}

FirstTouch first_touch(const Solid& a, const Motion& motion_a, const Solid& b, const Motion& motion_b,
                       double tolerance, Separation& memory, Manifold& work) noexcept {
  // apart by more than they move
  const double speed = relative_motion(a, motion_a, motion_b);
  const Vec3 centres = motion_a.X0 * a.centre - motion_b.X0 * b.centre;
  const double reach = a.bound + b.bound + std::max(speed, tolerance);
  if (centres.squaredNorm() > reach * reach) return {};

  Query query;
  query.flatness = 0;  // the least gap is all that counts
  Candidate nearest;
  double t = 0, expected = speed;  // the gap to be expected from what was nearest last time
  for (int i = 0; i < kMaxAdvances; ++i) {
    const Pose X_a = motion_a.at(t), X_b = motion_b.at(t);
    const Frame X_WA(X_a), X_WB(X_b);
    if (i > 0) expected = reevaluate(nearest, X_WA, X_WB).gap;

    // look no further than the rest of the way, nor than needed to see what is expected
    const double rest = speed * (1 - t);
    query.margin = std::max(std::min(rest, 1.01 * expected), tolerance);
    double gap = query.margin;
    const bool found = collide(a, X_WA, b, X_WB, query, memory, work) > 0;
    if (!found && query.margin >= rest) return {};
    for (int k = 0; k < work.count; ++k) {
      const Candidate& c = work.candidate[static_cast<size_t>(k)];
      if (c.touch.gap < gap) gap = c.touch.gap, nearest = c;
    }
    // the longer it takes, the closer they slide along each other: accept a little more
    if (found && gap <= tolerance * std::max(1, i - 8)) return {true, t};

    // two safe advances: gap over speed, and the slab across the nearest normal over the speed across it
    double advance = gap / speed;
    const Vec3& n = nearest.touch.n_W;
    const double width = found ? slab(a, X_WA, b, X_WB, n) : 0;
    if (width > 0) {
      const double closing = RelativeMotion(a, motion_a, X_a, motion_b, X_b).closing(n);
      if (closing * (1 - t) <= width) return {};
      advance = std::max(advance, width / closing);
    }
    t += advance;
    if (t >= 1) return {};
  }
  return {true, t};
}

}  // namespace swage::contact
