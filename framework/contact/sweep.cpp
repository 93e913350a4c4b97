// SPDX-License-Identifier: Apache-2.0
#include "contact/sweep.hpp"

#include <algorithm>

#include "contact/relative_motion.hpp"
#include "contact/sweep_wire.hpp"

namespace swage::contact {
namespace {

/// Width of the empty slab across n between b (below) and a (above); negative when they overlap along n.
double slab(const Solid& a, const Frame& X_WA, const Solid& b, const Frame& X_WB, const Vec3& n) {
  return n.dot(X_WA.p - X_WB.p) - support(a, -X_WA.turn_back(n)) - support(b, X_WB.turn_back(n));
}

/// Nearest features of a and b, kept from one query to the next.
class Nearest {
 public:
  Nearest(const Solid& a, const Solid& b, double tolerance, Separation& memory, Manifold& work)
      : a_(a), b_(b), tolerance_(tolerance), memory_(memory), work_(work) {
    query_.flatness = 0;  // the least gap is all that counts
  }

  /// Expected distance from the last nearest features; 0 without them.
  double expected(const Frame& X_WA, const Frame& X_WB) const {
    return known_ ? 1.01 * reevaluate(candidate_, X_WA, X_WB).gap : tolerance_;
  }
  /// Finds the nearest features. False when nothing is nearer than the margin, or the tolerance where that is larger.
  bool look(const Frame& X_WA, const Frame& X_WB, double margin) {
    query_.margin = std::max(margin, tolerance_);
    if (collide(a_, X_WA, b_, X_WB, query_, memory_, work_) == 0) return false;
    gap_ = query_.margin;
    for (int k = 0; k < work_.count; ++k) {
      const Candidate& c = work_.candidate[static_cast<size_t>(k)];
      if (c.touch.gap <= gap_) gap_ = c.touch.gap, candidate_ = c, known_ = true;
    }
    return true;
  }
  double gap() const { return gap_; }
  const Vec3& normal() const { return candidate_.touch.n_W; }

 private:
  const Solid &a_, &b_;
  const double tolerance_;
  Separation& memory_;
  Manifold& work_;
  Query query_;
  Candidate candidate_;
  bool known_ = false;
  double gap_ = 0;
};

/// Whether their bounding spheres are apart by more than their centres move.
bool stay_apart(const Solid& a, const Motion& motion_a, const Solid& b, const Motion& motion_b,
                double tolerance) {
  const Vec3 centres = motion_a.X0 * a.centre - motion_b.X0 * b.centre;
  const double moved = (motion_a.d - motion_b.d).norm() + motion_a.turn.norm() * a.centre.norm() +
                       motion_b.turn.norm() * b.centre.norm();
  const double reach = a.bound + b.bound + std::max(moved, tolerance);
  return centres.squaredNorm() > reach * reach;
}

}  // namespace

double relative_motion(const Solid& a, const Motion& motion_a, const Motion& motion_b) noexcept {
  RelativeMotion motion(a, motion_a, motion_b);
  motion.look(motion_a.X0.p, Frame(motion_b.X0));
  return motion.fastest(motion_b.X0.q.conjugate() * (motion_a.X0.q * a.centre), a.bound);
}

FirstTouch first_touch(const Solid& a, const Motion& motion_a, const Solid& b, const Motion& motion_b,
                       double tolerance, Separation& memory, Manifold& work) noexcept {
  if (stay_apart(a, motion_a, b, motion_b, tolerance)) return {};
  if (is_wire(a) && has_vertices(b)) return first_touch_wire(a, motion_a, b, motion_b, tolerance, memory);
  if (is_wire(b) && has_vertices(a)) return first_touch_wire(b, motion_b, a, motion_a, tolerance, memory);

  const double speed = relative_motion(a, motion_a, motion_b);
  RelativeMotion motion(a, motion_a, motion_b);
  Nearest nearest(a, b, tolerance, memory, work);
  double t = 0;
  for (int i = 0; i < kMaxAdvances && t < 1; ++i) {
    const Frame X_WA(motion_a.at(t)), X_WB(motion_b.at(t));
    motion.look(X_WA.p, X_WB);
    const double rest = speed * (1 - t);
    // lower bound of the time for which the slab across n, turning with b, stays open; 0: there is no slab
    const auto open_for = [&](const Vec3& n) {
      const Vec3 n_B = X_WB.turn_back(n), centre_B = X_WB.turn_back(X_WA.turn(a.centre));
      const double closing = -n_B.dot(motion.at(centre_B)) + n_B.cross(motion.spin()).norm() * a.bound +
                             0.5 * (1 - t) * motion.bend();
      const double width = slab(a, X_WA, b, X_WB, n);
      return width <= tolerance ? 0.0 : closing * (1 - t) <= width ? 1.0 : width / closing;
    };

    // first the contact test; otherwise a separating plane, or without one the distance, gives a safe time
    const double margin = std::min(rest, nearest.expected(X_WA, X_WB));
    if (!nearest.look(X_WA, X_WB, margin)) {
      const double advance = memory.n_B.isZero() ? 0.0 : open_for(X_WB.turn(memory.n_B));
      t += advance;
      if (advance > 0) continue;
      if (margin >= rest || !nearest.look(X_WA, X_WB, rest)) return {};
    }
    // many iterations mean that the bodies slide along each other: widen the tolerance a little
    if (nearest.gap() <= tolerance * std::max(1, i - 8)) return {true, t};

    // two safe advances: gap over speed, and the slab across the nearest normal over the speed across it
    t += std::max(nearest.gap() / speed, open_for(nearest.normal()));
  }
  return {t < 1, std::min(t, 1.0)};
}

}  // namespace swage::contact
