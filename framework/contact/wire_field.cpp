// SPDX-License-Identifier: Apache-2.0
#include "contact/wire_field.hpp"

#include "contact/cap.hpp"
#include "contact/field_walk.hpp"
#include "contact/wire_feature.hpp"

namespace swage::contact {
namespace {

/// Two contacts nearer together than this share of the wire's radius, with one normal, are one.
constexpr double kSame = 1e-4;

/// Writes the contacts of a walk over a height field. Point contacts at the minima; where the wire lies flat its two ends, too,
/// so that it rests on both and not on the lower one in turn.
template <class Curve>
class FieldWriter {
 public:
  using Place = typename Curve::Place;

  FieldWriter(const Curve& curve, const Solid& a, const Solid& b, const Frame& X_WB, const Query& query,
              Manifold& out)
      : curve_(curve), a_(a), b_(b), X_WH_(X_WB * b.X_BH), query_(query), out_(out) {}

  void write() {
    FieldWalk<Curve> walk(curve_, b_.field, a_.radius, a_.radius + query_.margin, b_.below);
    walk.walk(
        [&](const FieldFeature& f, Place at, const Stretch<Place>& range, int branch) {
          if (Candidate* c = add(f, at, branch, 0, 1)) set_wire_stretch(a_, at, range, c->a);
        },
        [&](const FieldFeature& f, Place at, const auto& run) {
          const double weight = 1 - sharpness(run);
          if (weight <= 0) return;
          if (Candidate* c = add(f, at, 0, 1, weight)) set_wire_point(a_, at, c->a);
        });
    out_.dropped += walk.dropped();
  }

 private:
  /// 0 for a run that is straight, as seen from the surface, to within the flatness and longer than the wire is thick.
  template <class Run>
  double sharpness(const Run& run) const {
    if (query_.flatness <= 0) return 1;
    const double flat = query_.flatness * query_.length;
    const double bend = std::abs(run.d - 0.5 * (run.d0 + run.d1));
    return std::max(1 - ramp(run.length, 0.25 * a_.radius, a_.radius), ramp(bend, 0.01 * flat, flat));
  }

  Candidate* add(const FieldFeature& f, Place place, int branch, int point, double weight) {
    const Vec3 p = curve_.point(place);
    Vec3 n = f.u;
    double distance;
    if (f.kind == Region::kFace) {
      distance = n.dot(p - f.p);
    } else {
      Vec3 w = p - f.p;
      if (f.kind == Region::kEdge) w -= w.dot(f.u) / f.u.squaredNorm() * f.u;
      distance = w.norm();
      n = distance > 1e-6 * a_.radius ? Vec3(w / distance) : Vec3::UnitZ();
    }
    Touch touch{distance - a_.radius, {}, X_WH_.turn(n)};
    if (!(touch.gap <= query_.margin)) return nullptr;
    touch.p_W = X_WH_ * Vec3(p - (a_.radius + 0.5 * touch.gap) * n);
    if (is_there(touch)) return nullptr;

    Candidate* c = out_.add(touch.gap);
    if (!c) return nullptr;
    const Vec3 p_B = b_.X_BH * f.p, u_B = b_.X_BH.turn(f.u);
    c->b.kind = f.kind == Region::kFace   ? Feature::kPlane
                : f.kind == Region::kEdge ? Feature::kSegment
                                          : Feature::kPoint;
    c->b.tube = 0;
    c->b.p = p_B, c->b.u = u_B;
    c->n_B = b_.X_BH.turn(n);
    c->feature = feature_id({f.kind, f.index}, branch, point);
    c->weight = weight;
    c->touch = touch;
    return c;
  }
  /// Whether a neighbouring feature gave the same contact before.
  bool is_there(const Touch& touch) const {
    for (int i = 0; i < out_.count; ++i) {
      const Touch& other = out_.candidate[static_cast<size_t>(i)].touch;
      if ((other.p_W - touch.p_W).norm() < kSame * a_.radius && (other.n_W - touch.n_W).norm() < 0.02)
        return true;
    }
    return false;
  }

  const Curve& curve_;
  const Solid &a_, &b_;
  const Frame X_WH_;
  const Query& query_;
  Manifold& out_;
};

}  // namespace

void collide_wire_field(const Solid& a, const Frame& X_WA, const Solid& b, const Frame& X_WB,
                        const Query& query, Manifold& out) noexcept {
  if (b.field.z == nullptr) return;
  const Frame X_HA = (X_WB * b.X_BH).inverse_times(X_WA);
  if (a.kind == SWAGE_SHAPE_ARC) {
    toolkit::Arc arc = a.arc;
    arc.centre = X_HA * arc.centre, arc.x = X_HA.turn(arc.x), arc.y = X_HA.turn(arc.y);
    const ArcCurve curve(arc);
    FieldWriter<ArcCurve>(curve, a, b, X_WB, query, out).write();
  } else {
    const LineCurve curve(X_HA * a.axis.a, X_HA * a.axis.b);
    FieldWriter<LineCurve>(curve, a, b, X_WB, query, out).write();
    if (a.kind == SWAGE_SHAPE_SPHERE && query.flatness > 0)
      spread_caps(a, X_WB.inverse_times(X_WA), X_WB, out);
  }
}

}  // namespace swage::contact
