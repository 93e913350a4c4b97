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

/// What of a and b is nearest, remembered from look to look.
class Nearest {
 public:
  Nearest(const Solid& a, const Solid& b, double tolerance, Separation& memory, Manifold& work)
      : a_(a), b_(b), tolerance_(tolerance), memory_(memory), work_(work) {
    query_.flatness = 0;  // the least gap is all that counts
  }

  /// How near they are to be expected from what was nearest last time; without that, touching.
  double expected(const Frame& X_WA, const Frame& X_WB) const {
    return known_ ? 1.01 * reevaluate(candidate_, X_WA, X_WB).gap : tolerance_;
  }
  /// Whether anything is nearer than the margin, or the tolerance.
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

  Nearest nearest(a, b, tolerance, memory, work);
  double t = 0;
  for (int i = 0; i < kMaxAdvances && t < 1; ++i) {
    const Pose X_a = motion_a.at(t), X_b = motion_b.at(t);
    const Frame X_WA(X_a), X_WB(X_b);
    const RelativeMotion motion(a, motion_a, X_a, motion_b, X_b);
    const double rest = speed * (1 - t);
    // how long the slab across n, which turns with b, stays open at least; 0 when there is none
    const auto open_for = [&](const Vec3& n) {
      const double width = slab(a, X_WA, b, X_WB, n), closing = motion.closing(n);
      return width <= tolerance ? 0.0 : closing * (1 - t) <= width ? 1.0 : width / closing;
    };

    // touching? If not even near, a plane between them holds for a while, and without one the distance says how long
    const double margin = std::min(rest, nearest.expected(X_WA, X_WB));
    if (!nearest.look(X_WA, X_WB, margin)) {
      const double advance = memory.n_B.isZero() ? 0.0 : open_for(X_WB.turn(memory.n_B));
      t += advance;
      if (advance > 0) continue;
      if (margin >= rest || !nearest.look(X_WA, X_WB, rest)) return {};
    }
    // the longer it takes, the closer they slide along each other: accept a little more
    if (nearest.gap() <= tolerance * std::max(1, i - 8)) return {true, t};

    // two safe advances: gap over speed, and the slab across the nearest normal over the speed across it
    t += std::max(nearest.gap() / speed, open_for(nearest.normal()));
  }
  return {t < 1, std::min(t, 1.0)};
}

}  // namespace swage::contact
