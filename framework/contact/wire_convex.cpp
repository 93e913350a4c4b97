// SPDX-License-Identifier: Apache-2.0
#include "contact/wire_convex.hpp"

#include "contact/cap.hpp"
#include "contact/walk.hpp"
#include "contact/wire_feature.hpp"

namespace swage::contact {
namespace {

/// A stretch counts as level while its ends differ by less than kLevel times the flatness, as tilted from kSteep times on:
/// 4 and 40 um for a 1 mm scene. Closer to each other: a wire pinched by more than 0.2 N rocks, because its weights follow its
/// tilt one step late.
constexpr double kLevel = 2, kSteep = 20;

/// A line that would bear less than a thousandth of the force is left to the point beside it; on a piece of a chain, of which
/// each brings lines of its own, less than a fiftieth: the wire then moves by a fiftieth of an overlap, some 10 nm.
constexpr double kPoint = 0.999, kPointOfPiece = 0.98;

/// Makes contact points of the pieces and minima that a walk along the wire found.
///
/// A minimum is a point contact. A piece whose distance varies by less than the flatness lies on the polyhedron: pressure
/// spreads along it, so it becomes a line of points of equal weight at the midpoints of equal parts, which gives an even
/// pressure its friction moment. `sharp` (1: point, 0: line) fades one into the other, so that no force jumps when a
/// wire is laid down. A straight wire that is tilted over a face touches at one end of its part over the face, but may come to touch
/// at the other within the step, and would rock unless that is a contact, too: the far end.
template <class Curve>
class Writer {
 public:
  using Place = typename Curve::Place;

  Writer(const Walk<Curve>& walk, const Curve& curve, const Solid& a, const Solid& b, const Frame& X_WB,
         const Query& query, Manifold& out)
      : walk_(walk), curve_(curve), a_(a), b_(b), X_WB_(X_WB), query_(query), out_(out) {}

  void write() {
    out_.dropped += walk_.dropped();
    judge();
    int dip = 0;
    for (int k = 0; k < walk_.pieces().size(); ++k) {
      for (; dip < walk_.dips().size() && walk_.dips()[dip].piece == k; ++dip) write_dip(walk_.dips()[dip]);
      if (line_weight_[at(k)] > 0) write_line(k);
      if (Curve::kStraight) write_far_end(k);
    }
  }

 private:
  static size_t at(int i) { return static_cast<size_t>(i); }
  bool joined(int k) const { return k > 0 && k < walk_.pieces().size() && walk_.pieces()[k].joined; }

  /// Finds the pieces that lie flat, and divides the weight of a line contact among the pieces it covers.
  void judge() {
    bool any = false;
    for (int k = 0; k < walk_.pieces().size(); ++k) {
      length_[at(k)] = curve_.length(walk_.pieces()[k].from, walk_.pieces()[k].to);
      sharp_[at(k)] = sharpness(k);
      line_weight_[at(k)] = 0;
      any |= sharp_[at(k)] < 1;
    }
    for (int k = 0; any && k < walk_.pieces().size();) {
      int end = k;
      double total = 0;
      do {
        total += flat_length(end);
      } while (joined(++end));
      for (; k < end; ++k)
        if (total > 0 && sharp_[at(k)] < (query_.piece ? kPointOfPiece : kPoint))
          line_weight_[at(k)] = (1 - sharp_[at(k)]) * flat_length(k) / total;
    }
  }
  double flat_length(int k) const { return (1 - sharp_[at(k)]) * length_[at(k)]; }

  /// Length of the wire over the region of a piece [m]. Where the wire continues over a face as another solid, or as another piece of its
  /// chain, it is followed along its tangent to the border of the region, at most by a radius. By the length of the piece alone, a wire cut 30 um
  /// inside the edge of a jaw, or a thread with a vertex there, would touch at a point beside its line, at the cut or at the edge by the sign of its
  /// tilt, and rock from step to step.
  double length_over_region(int k) const {
    const Piece<Place>& piece = walk_.pieces()[k];
    double length = length_[at(k)];
    if (piece.region.kind == Region::kEdge) return length;  // across an edge, or along a segment of a thread, it is one touch
    const auto is = [](Place place, Place end) { return Curve::order(place) == Curve::order(end); };
    if ((query_.goes_on || query_.piece_before) && is(piece.from, curve_.stretch(0).from))
      length += ahead(piece.region, curve_.point(piece.from), -curve_.tangent(piece.from));
    if ((query_.goes_on_after || query_.piece_after) && is(piece.to, curve_.stretch(curve_.stretches() - 1).to))
      length += ahead(piece.region, curve_.point(piece.to), curve_.tangent(piece.to));
    return length;
  }
  /// Way from p along the unit vector u to the border of a region, at most a wire's radius [m].
  double ahead(Region region, const Vec3& p, const Vec3& u) const {
    double way = a_.radius;
    for_each_border(b_.convex, region, [&](const Vec3& n, double d, Region) {
      const double rate = n.dot(u);
      if (rate > 0) way = std::min(way, std::max(0.0, d - n.dot(p)) / rate);
    });
    return way;
  }

  /// 0 for a piece along which the distance hardly varies and that is longer than the wire is thick.
  double sharpness(int k) const {
    const Piece<Place>& piece = walk_.pieces()[k];
    if (piece.region.kind == Region::kVertex || query_.flatness <= 0) return 1;
    const double short_wire = 1 - ramp(length_over_region(k), 0.25 * a_.radius, a_.radius);
    if (short_wire >= 1) return 1;

    // minima in the piece and next to it; without one the piece is out of reach
    double low = 1e300;
    for (const Dip<Place>& dip : walk_.dips()) {
      const bool beside =
          dip.piece == k || (dip.piece == k - 1 && joined(k)) || (dip.piece == k + 1 && joined(k + 1));
      if (beside) low = std::min(low, dip.distance);
    }
    const double d0 = distance(piece.region, piece.from), d1 = distance(piece.region, piece.to);
    // a wire that continues before the curve's start leaves a minimum there to the arc before, and may rest on this arc all the same
    if (k == 0 && query_.goes_on) low = std::min(low, d0);
    if (low > a_.radius + b_.radius + query_.margin) return 1;

    // how far the distance bends away from a straight slope, and how steep that slope is. The slope counts less: points of
    // a line adapt to it by themselves, and weights that followed it closely would follow the tilt that they cause
    const double flat = query_.flatness * query_.length;
    const double tilt = std::abs(d1 - d0);
    if (tilt >= kSteep * flat || std::min(d0, d1) - low >= flat) return 1;
    const double d = distance(piece.region, curve_.middle(piece.from, piece.to));
    const double bend = std::max(std::abs(d - 0.5 * (d0 + d1)), std::min({d0, d, d1}) - low);
    return std::max({short_wire, ramp(bend, 0.01 * flat, flat), ramp(tilt, kLevel * flat, kSteep * flat)});
  }

  /// Distance from the plane of a face or the line of an edge.
  double distance(Region region, Place place) const {
    const Vec3 p = curve_.point(place);
    if (region.kind != Region::kEdge)
      return b_.convex.face[region.index].n.dot(p) - b_.convex.face[region.index].d;
    const Convex::Edge& e = b_.convex.edge[region.index];
    const Vec3 w = p - b_.convex.vertex[e.v0];
    return (w - w.dot(e.u) * e.u).norm();
  }

  void write_dip(const Dip<Place>& dip) {
    double weight = sharp_[at(dip.piece)];
    if (joined(dip.piece)) weight *= sharp_[at(dip.piece - 1)];
    if (joined(dip.piece + 1)) weight *= sharp_[at(dip.piece + 1)];
    if (weight <= 0) return;
    const Piece<Place>& piece = walk_.pieces()[dip.piece];
    Candidate* c = add(piece.region, dip.at, dip.branch, 0, weight);
    if (!c) return;
    // over a face the place may move as far as the face goes; round an edge or vertex, along the whole wire
    const bool on_face = piece.region.kind == Region::kFace || piece.region.kind == Region::kInside;
    if (far_end(dip.piece).weight > 0) return set_wire_point(a_, dip.at, c->a);
    const auto range = on_face ? curve_.around(dip.at, piece.from, piece.to) : curve_.around(dip.at);
    set_wire_stretch(a_, dip.at, range, c->a);
  }

  /// Points at the middles of `line_points` equal parts (a power of two), by halving and then by steps of one part.
  void write_line(int k) {
    const Piece<Place>& piece = walk_.pieces()[k];
    Place first_end = piece.to;
    for (int parts = query_.line_points; parts > 1; parts /= 2)
      first_end = curve_.middle(piece.from, first_end);
    Place place = curve_.middle(piece.from, first_end);
    for (int i = 0; i < query_.line_points; ++i) {
      Candidate* c = add(piece.region, place, 0, 1 + i, line_weight_[at(k)] / query_.line_points);
      if (c) set_wire_point(a_, place, c->a);
      place = Curve::moved(place, piece.from, first_end);
    }
  }

  /// The place at which a straight piece over a face is farthest from it, and the weight of a contact there: 0 where it is out of reach, or
  /// nearer to the other end than the wire is thick.
  struct FarEnd {
    Place place{};
    double weight = 0;
  };
  FarEnd far_end(int k) const {
    const Piece<Place>& piece = walk_.pieces()[k];
    if (!Curve::kStraight || piece.region.kind != Region::kFace || query_.flatness <= 0) return {};
    const double d0 = distance(piece.region, piece.from), d1 = distance(piece.region, piece.to);
    if (std::max(d0, d1) - a_.radius - b_.radius > query_.margin) return {};
    const double apart = ramp(length_[at(k)], 0.25 * a_.radius, a_.radius);
    return {d0 > d1 ? piece.from : piece.to, sharp_[at(k)] * apart};
  }
  void write_far_end(int k) {
    constexpr int kFarEnd = 9;  // after the points of a line
    const FarEnd end = far_end(k);
    if (end.weight <= 0) return;
    Candidate* c = add(walk_.pieces()[k].region, end.place, 0, kFarEnd, end.weight);
    if (c) set_wire_point(a_, end.place, c->a);
  }

  Candidate* add(Region region, Place place, int branch, int point, double weight) {
    const Vec3 p = curve_.point(place);
    Touch touch_B = touch(region, p);
    if (touch_B.gap > query_.margin) return nullptr;
    Candidate* c = out_.add(touch_B.gap);
    if (!c) return nullptr;
    set_convex_feature(b_, region, c->b);
    c->n_B = touch_B.n_W;
    c->feature = feature_id(region, branch, point);
    c->weight = weight;
    c->touch = {touch_B.gap, X_WB_ * touch_B.p_W, X_WB_.turn(touch_B.n_W)};
    return c;
  }

  /// Gap, point and normal, in the frame of b, of the wire's place p with the feature of a region.
  Touch touch(Region region, const Vec3& p) const {
    const Offset from = offset(b_, region, p, a_.radius);
    Touch t;
    t.gap = from.distance - a_.radius - b_.radius;
    t.n_W = from.n;
    t.p_W = p - (a_.radius + 0.5 * t.gap) * t.n_W;
    return t;
  }

  const Walk<Curve>& walk_;
  const Curve& curve_;
  const Solid &a_, &b_;
  const Frame& X_WB_;
  const Query& query_;
  Manifold& out_;
  std::array<double, Walk<Curve>::kPieces> length_, sharp_, line_weight_;  // per piece
};

/// Flattened: the walk is made of many small functions with arguments in memory; inlined it takes a third less time.
template <class Curve>
[[gnu::flatten]] void collide_curve(const Curve& curve, const Solid& a, const Solid& b, const Frame& X_WB,
                                    const Query& query, Separation& memory, Manifold& out) noexcept {
  const double reach = a.radius + b.radius + query.margin, slack = 2 * query.flatness * query.length;
  Stretches<Curve> stretch;
  const auto anywhere = [=](const Vec3&) { return reach; };
  if (!clip_to_reach(stretch, curve, b.convex, anywhere, slack, Border::kClipped, memory)) return;
  Walk<Curve> walk(curve, b.convex, a.radius, reach, stretch, query.goes_on);
  walk.walk();
  Writer<Curve>(walk, curve, a, b, X_WB, query, out).write();
}

}  // namespace

void collide_wire_convex(const Solid& a, const Frame& X_WA, const Solid& b, const Frame& X_WB,
                         const Query& query, Separation& memory, Manifold& out) noexcept {
  const Frame X_BA = X_WB.inverse_times(X_WA);
  if (a.kind == SWAGE_SHAPE_ARC) {
    collide_curve(curve_of<ArcCurve>(a, X_BA), a, b, X_WB, query, memory, out);
  } else {
    collide_curve(curve_of<LineCurve>(a, X_BA), a, b, X_WB, query, memory, out);
    if (a.kind == SWAGE_SHAPE_SPHERE && query.flatness > 0) spread_caps(a, X_BA, X_WB, out);
  }
}

}  // namespace swage::contact
