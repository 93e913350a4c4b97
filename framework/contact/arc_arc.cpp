// SPDX-License-Identifier: Apache-2.0
#include "contact/arc_arc.hpp"

#include <algorithm>

#include "contact/wire_feature.hpp"

namespace swage::contact {
namespace {

using toolkit::Arc;

/// Samples along a are this share of the thinner wire's radius apart: minima closer together than this are one contact.
constexpr double kSpacing = 0.5;

/// A sample of the distance along arc a.
struct Sample {
  Turn at;
  double d = 1e300;
};

class ArcPairSearch {
 public:
  ArcPairSearch(const Solid& a, const Frame& X_WA, const Solid& b, const Frame& X_WB, const Query& query,
                Manifold& out)
      : a_(a),
        b_(b),
        X_WA_(X_WA),
        X_WB_(X_WB),
        query_(query),
        out_(out),
        arc_(a.arc),
        reach_(a.radius + b.radius + query.margin) {
    const Frame X_BA = X_WB.inverse_times(X_WA);
    arc_.centre = X_BA * arc_.centre, arc_.x = X_BA.turn(arc_.x), arc_.y = X_BA.turn(arc_.y);
  }

  /// Samples the distance along arc a. The distance changes by no more than the step, so a large distance allows a large step.
  void search() {
    const double spacing = kSpacing * std::min(a_.radius, b_.radius);
    const int last = std::max(2, static_cast<int>(arc_.length() / spacing) + 1);
    const double way = arc_.length() / last;
    // between two samples the distance is at most half a step below the smaller of theirs
    const double near = reach_ + 0.5 * way;
    Sample before, middle;
    for (int i = 0; i <= last;) {
      const Sample now = sample(static_cast<double>(i) / last);
      if (middle.d < near && middle.d <= now.d && middle.d < before.d) refine(middle.at);
      const int skip = now.d > near ? static_cast<int>((now.d - near) / way) : 0;
      before = skip > 0 ? Sample{} : middle;
      middle = skip > 0 ? Sample{} : now;
      i += std::max(1, skip);
    }
    if (middle.d < near && middle.d < before.d) refine(middle.at);
  }

 private:
  Sample sample(double s) const {
    const Turn e = arc_.at(s);
    const Vec3 p = arc_.point(e);
    return {e, (p - b_.arc.point(closest(b_.arc, p))).norm()};
  }

  /// Contact at the local minimum of the distance near a place of arc a.
  void refine(Turn start) {
    const Turn on_b = closest(b_.arc, arc_.point(start));
    const Vec3 w = arc_.point(start) - b_.arc.point(on_b);
    const double d = w.norm();
    Candidate found;
    set_wire_stretch(a_, start, ArcCurve(a_.arc).around(start), found.a);
    set_wire_stretch(b_, on_b, ArcCurve(b_.arc).around(on_b), found.b);
    found.n_B = d > 1e-6 * (a_.radius + b_.radius) ? Vec3(w / d) : b_.arc.normal();
    found.feature = (uint64_t{8} << 40) | static_cast<uint64_t>(out_.count);  // counted along a
    found.touch = reevaluate(found, X_WA_, X_WB_);
    if (!(found.touch.gap <= query_.margin)) return;
    if (Candidate* c = out_.add(found.touch.gap)) *c = found;
  }

  const Solid &a_, &b_;
  const Frame &X_WA_, &X_WB_;
  const Query& query_;
  Manifold& out_;
  Arc arc_;  // a in the frame of b
  double reach_;
};

}  // namespace

void collide_arc_arc(const Solid& a, const Frame& X_WA, const Solid& b, const Frame& X_WB, const Query& query,
                     Manifold& out) noexcept {
  ArcPairSearch(a, X_WA, b, X_WB, query, out).search();
}

}  // namespace swage::contact
