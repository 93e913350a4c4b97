// SPDX-License-Identifier: Apache-2.0
#include "contact/sweep_wire.hpp"

#include <algorithm>

#include "contact/relative_motion.hpp"
#include "contact/walk.hpp"
#include "contact/wire_feature.hpp"

namespace swage::contact {
namespace {

/// In radii of the wire. A face farther away than this gives the safe time by its plane. Nearer to all of them the distance
/// itself is computed, because round an edge the planes of the faces are off by up to 0.4 radii.
constexpr double kClose = 0.25;

/// Conservative advancement, all in the frame of b, which moves.
template <class Curve>
class WireSweep {
 public:
  using Place = typename Curve::Place;
  using Height = typename Curve::Height;

  WireSweep(const Solid& a, const Motion& motion_a, const Solid& b, const Motion& motion_b, double tolerance)
      : a_(a),
        b_(b),
        motion_a_(motion_a),
        motion_b_(motion_b),
        tolerance_(tolerance),
        motion_(a, motion_a, motion_b) {}

  FirstTouch run(Separation& memory) {
    start();
    const double speed = motion_.fastest(X_BA_.turn(a_.centre), a_.bound);
    if (!clip(memory)) return {};
    for (int i = 0; i < kMaxAdvances; ++i) {
      Wait wait;
      if (gap_ > a_.radius) wait = until_faces();
      if (wait.width <= kClose * a_.radius) {
        if (!find_nearest(speed * (1 - t_))) return {};
        // many iterations mean that the bodies slide along each other: widen the tolerance a little
        if (gap_ <= tolerance_ * std::max(1, i - 8)) return {true, t_};
        wait.time = std::max({wait.time, until_normal(), until_nearest()});
      }
      if (!(t_ + wait.time < 1)) return {};
      advance(wait.time);
      if (touches()) return {true, t_};
      if (i == 0 && motion_.turns() && !clip_again()) return {};
    }
    return {true, t_};
  }

 private:
  /// An empty slab and the time for which it stays open.
  struct Wait {
    double width = 0;  // m
    double time = 0;   // share of the step
  };

  void start() {
    const Frame X_WA(motion_a_.X0), X_WB(motion_b_.X0);
    X_BA_ = X_WB.inverse_times(X_WA);
    motion_.look(X_WA.p, X_WB);
    curve_ = curve_of<Curve>(a_, X_BA_);
  }
  void advance(double time) {
    t_ += time;
    if (motion_.turns()) {
      const Frame X_WA(motion_a_.at(t_)), X_WB(motion_b_.at(t_));
      X_BA_ = X_WB.inverse_times(X_WA);
      motion_.look(X_WA.p, X_WB);
    } else {
      X_BA_.p += time * motion_.of_origin();
    }
    curve_ = curve_of<Curve>(a_, X_BA_);
  }

  /// Reduces the wire to the part that may reach every face before the end of the step.
  bool clip(Separation& memory) {
    const double tubes = a_.radius + b_.radius + tolerance_;
    const Vec3 u = motion_.at(X_BA_.turn(a_.centre));
    const auto reach = [&](const Vec3& n) {
      double closing = -n.dot(u);
      if (motion_.turns()) closing += n.cross(motion_.spin()).norm() * a_.bound + 0.5 * motion_.bend();
      return tubes + std::max(0.0, closing);
    };
    return clip_to_reach(stretch_, curve_, b_.convex, reach, 0, Border::kEnd, memory);
  }
  /// Repeats the reduction for the rest of the step with the smaller motion of the remaining part.
  bool clip_again() {
    const double tubes = a_.radius + b_.radius + tolerance_, rest = 1 - t_;
    for (const Convex::Face& f : b_.convex.face) {
      const double closing = 0.5 * rest * motion_.bend() - lowest<Curve>(stretch_, receding(f.n));
      const double reach = tubes + rest * std::max(0.0, closing);
      contact::clip<Curve>(stretch_, curve_.height(f.n, f.d + reach), Border::kEnd);
    }
    return !stretch_.empty();
  }

  /// Separation speed n . u = n . u_A + k . (p - p_A) of points of the wire along n, linear in p like a height.
  Height receding(const Vec3& n) const {
    const Vec3 k = n.cross(motion_.spin());
    return curve_.height(k, k.dot(X_BA_.p) - n.dot(motion_.of_origin()));
  }

  /// Lower bound of the time for which the slab between the remaining part and the plane n . p = d stays open.
  Wait until(const Vec3& n, double d) const {
    const double rest = 1 - t_, bend = motion_.bend();
    const Height h = curve_.height(n, d + a_.radius + b_.radius);
    Wait wait;
    wait.width = lowest<Curve>(stretch_, h);
    if (wait.width <= tolerance_) return wait;
    const Height away = receding(n);
    double left = wait.width;
    const double fastest = bend * rest - lowest<Curve>(stretch_, away);
    // h + s away - bend s^2 / 2 is concave in s: if it is positive at an s, it is positive for all smaller ones
    for (int k = 0; k < 3 && left > tolerance_; ++k) {
      if (fastest * (rest - wait.time) <= left) return {wait.width, 1.0};
      wait.time += left / fastest;
      if (!motion_.turns()) return wait;
      left = lowest<Curve>(stretch_, plus(h, wait.time, away)) - 0.5 * bend * wait.time * wait.time;
    }
    return wait;
  }
  Wait until_faces() const {
    Wait longest;
    for (const Convex::Face& f : b_.convex.face) {
      const Wait wait = until(f.n, f.d);
      if (wait.time > longest.time) longest = wait;
    }
    return longest;
  }
  double until_normal() const {
    const Vec3 n = offset(b_, region_, curve_.point(place_), a_.radius).n;
    return until(n, b_.convex.support(n)).time;
  }
  /// Lower bound of the time in which the remaining part covers the last distance.
  double until_nearest() const {
    const Vec3 p = curve_.point(place_);
    double far = 0;
    for (const auto& s : stretch_)
      far = std::max({far, (curve_.point(s.from) - p).norm(), (curve_.point(s.to) - p).norm()});
    const double speed = motion_.at(p - X_BA_.p).norm() + far * motion_.spin().norm();
    return gap_ / (speed + 0.5 * motion_.bend() * std::min(1 - t_, gap_ / speed));
  }

  /// Nearest point, up to a gap of `margin`.
  bool find_nearest(double margin) {
    const double tubes = a_.radius + b_.radius;
    Walk<Curve> walk(curve_, b_.convex, a_.radius, tubes + std::max(margin, tolerance_), stretch_);
    walk.walk();
    found_ = !walk.dips().empty();
    gap_ = 1e300;
    for (const Dip<Place>& dip : walk.dips()) {
      if (dip.distance - tubes >= gap_) continue;
      gap_ = dip.distance - tubes;
      place_ = dip.at;
      region_ = walk.pieces()[dip.piece].region;
    }
    return found_;
  }

  /// Whether the last nearest point is within the tolerance; its distance is an upper bound of the gap.
  bool touches() const {
    if (!found_ || region_.kind == Region::kInside) return false;
    const Vec3 p = curve_.point(place_);
    if (offset(b_, region_, p, a_.radius).distance - a_.radius - b_.radius > tolerance_) return false;
    bool over = true;
    for_each_border(b_.convex, region_, [&](const Vec3& n, double d, Region beyond) {
      over = over && (beyond.kind == Region::kInside || n.dot(p) <= d);
    });
    return over;
  }

  const Solid &a_, &b_;
  const Motion &motion_a_, &motion_b_;
  const double tolerance_;
  RelativeMotion motion_;
  double t_ = 0;
  Frame X_BA_;
  Curve curve_;  // in b
  Stretches<Curve> stretch_;
  // nearest features at the last query
  bool found_ = false;
  double gap_ = 1e300;
  Place place_{};
  Region region_;
};

}  // namespace

[[gnu::flatten]] FirstTouch first_touch_wire(const Solid& a, const Motion& motion_a, const Solid& b,
                                             const Motion& motion_b, double tolerance,
                                             Separation& memory) noexcept {
  if (a.kind == SWAGE_SHAPE_ARC) return WireSweep<ArcCurve>(a, motion_a, b, motion_b, tolerance).run(memory);
  return WireSweep<LineCurve>(a, motion_a, b, motion_b, tolerance).run(memory);
}

}  // namespace swage::contact
