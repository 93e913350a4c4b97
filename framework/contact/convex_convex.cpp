// SPDX-License-Identifier: Apache-2.0
#include "contact/convex_convex.hpp"

#include <algorithm>

#include "contact/wire_feature.hpp"
#include "toolkit/fixed_vector.hpp"

namespace swage::contact {
namespace {

/// A pair of edges counts only if it is farther apart than any face by this share of the flatness: 40 nm for a 1 mm
/// scene. Two faces that meet almost level touch in a polygon, not in one of its corners after the other.
constexpr double kFaceFirst = 0.02;

/// Difference that counts as none at any flatness, as a share of the scene's length: 0.1 nm for a 1 mm scene. Edges that are aligned
/// with each other lead a face by rounding only, and may be a side apart from each other.
constexpr double kRounding = 1e-7;

/// Sine squared below which two edges are parallel: a face then gives the same axis.
constexpr double kParallel = 1e-10;

/// The direction along which the two are farthest apart, or overlap least, and the features that define it.
struct Axis {
  enum Kind : uint8_t { kFaceOfB, kFaceOfA, kEdges, kClosest } kind = kFaceOfB;
  double apart = -1e300;   // m, negative when they overlap
  Vec3 n = Vec3::UnitZ();  // unit, from b to a, in B
  uint32_t a = 0, b = 0;   // face, or edges
};

/// A vertex of the contact polygon and the feature it comes from.
struct Corner {
  Vec3 p = Vec3::Zero();
  uint32_t id = 0;
};
using Polygon = toolkit::FixedVector<Corner, 32>;

class ConvexPair {
 public:
  ConvexPair(const Solid& a, const Frame& X_WA, const Solid& b, const Frame& X_WB, const Query& query,
             Manifold& out)
      : a_(a.convex),
        b_(b.convex),
        X_WA_(X_WA),
        X_WB_(X_WB),
        X_BA_(X_WB.inverse_times(X_WA)),
        query_(query),
        out_(out) {}

  void collide(Separation& memory) {
    if (!memory.n_B.isZero() && lowest_a(memory.n_B) - b_.support(memory.n_B) > query_.margin) return;
    if (!find_axis()) {
      memory.n_B = axis_.n;
      return;
    }
    const int before = out_.count;
    if (axis_.kind == Axis::kEdges)
      add_edges(axis_.a, axis_.b, axis_.n);
    else
      add_polygon();
    // neither a face nor a pair of edges separates them: a vertex is closest
    double least = 1e300;
    for (int i = before; i < out_.count; ++i)
      least = std::min(least, out_.candidate[static_cast<size_t>(i)].touch.gap);
    if (axis_.apart > 0 && least > axis_.apart + tolerance()) add_closest(least);
  }

 private:
  double tolerance() const { return std::max(kFaceFirst * query_.flatness, kRounding) * query_.length; }
  double lowest_a(const Vec3& n) const {
    // n . (X_BA v) = n . p + (R' n) . v
    const Vec3 m = X_BA_.turn_back(n);
    double least = 1e300;
    for (const Vec3& v : a_.vertex) least = std::min(least, m.dot(v));
    return n.dot(X_BA_.p) + least;
  }

  /// False: apart along axis_.n by more than the margin.
  bool find_axis() {
    for (uint32_t f = 0; f < b_.face.size(); ++f)
      if (!consider(Axis::kFaceOfB, b_.face[f].n, lowest_a(b_.face[f].n) - b_.face[f].d, 0, f)) return false;
    for (uint32_t f = 0; f < a_.face.size(); ++f) {
      const Vec3 n = -X_BA_.turn(a_.face[f].n);
      // height of b's nearest vertex over the face of a
      const double apart = -b_.support(n) - a_.face[f].d + n.dot(X_BA_.p);
      if (!consider(Axis::kFaceOfA, n, apart, f, 0)) return false;
    }
    for (uint32_t i = 0; i < a_.edge.size(); ++i)
      for (uint32_t j = 0; j < b_.edge.size(); ++j)
        if (!consider_edges(i, j)) return false;
    return true;
  }
  bool consider(Axis::Kind kind, const Vec3& n, double apart, uint32_t a, uint32_t b) {
    const double lead = kind == Axis::kEdges && axis_.kind != Axis::kEdges ? tolerance() : 0;
    if (apart > axis_.apart + lead || apart > query_.margin) axis_ = {kind, apart, n, a, b};
    return apart <= query_.margin;
  }
  /// Only pairs whose arcs cross on the sphere of normals touch along their common normal (Gregorius, GDC 2013).
  bool consider_edges(uint32_t i, uint32_t j) {
    const Convex::Edge &e = a_.edge[i], &f = b_.edge[j];
    const Vec3 u = X_BA_.turn(e.u);
    const Vec3 cross = u.cross(f.u);
    const double sine2 = cross.squaredNorm();
    if (sine2 < kParallel) return true;
    const Vec3 p = X_BA_.turn(a_.face[e.face_left].n), q = X_BA_.turn(a_.face[e.face_right].n);
    const Vec3 r = -b_.face[f.face_left].n, s = -b_.face[f.face_right].n;
    const double rpq = r.dot(u) * sign(p, q, u), spq = s.dot(u) * sign(p, q, u);
    const double prs = p.dot(f.u) * sign(r, s, f.u), qrs = q.dot(f.u) * sign(r, s, f.u);
    if (rpq * spq >= 0 || prs * qrs >= 0 || rpq * qrs <= 0) return true;
    Vec3 n = cross / std::sqrt(sine2);
    if (n.dot(p + q) > 0) n = -n;
    const double apart = n.dot(X_BA_ * a_.vertex[e.v0] - b_.vertex[f.v0]);
    return consider(Axis::kEdges, n, apart, i, j);
  }
  /// 1 where u points along p x q, -1 where it points against it.
  static double sign(const Vec3& p, const Vec3& q, const Vec3& u) {
    return p.cross(q).dot(u) < 0 ? -1.0 : 1.0;
  }

  // --- faces

  /// Adds the corners of the incident face of the other polyhedron, clipped to the reference face.
  void add_polygon() {
    const bool of_b = axis_.kind == Axis::kFaceOfB;
    const Convex &base = of_b ? b_ : a_, &other = of_b ? a_ : b_;
    const uint32_t f = of_b ? axis_.b : axis_.a;
    const Convex::Face& face = base.face[f];
    // from the frame of the incident polyhedron to that of the reference polyhedron
    const Frame X = of_b ? X_BA_ : X_WA_.inverse_times(X_WB_);
    const uint32_t facing = most_facing(other, X.turn_back(face.n));
    Polygon polygon;
    for (const uint32_t v : other.face[facing].vertex) polygon.add({X * other.vertex[v], v & 0x1Fu});
    for (uint32_t k = 0; k < face.side.size(); ++k) cut(polygon, face.side[k], face.side_d[k], k);
    int touching = 0;
    for (const Corner& c : polygon) touching += face.n.dot(c.p) - face.d <= query_.margin;
    for (const Corner& c : polygon) {
      if (face.n.dot(c.p) - face.d > query_.margin) continue;
      Candidate* found = out_.add(face.n.dot(c.p) - face.d);
      if (!found) continue;
      Feature &plane = of_b ? found->b : found->a, &point = of_b ? found->a : found->b;
      plane.kind = Feature::kPlane, plane.tube = 0, plane.p = face.d * face.n, plane.u = face.n;
      point.kind = Feature::kPoint, point.tube = 0, point.p = X.inverse_times(c.p);
      finish(*found, axis_.kind, uint64_t{f} << 12 | facing, c.id, 1.0 / touching);
    }
  }
  /// Face at the lowest vertex along n whose normal is most opposed to n.
  static uint32_t most_facing(const Convex& c, const Vec3& n) {
    uint32_t lowest = 0, best = 0;
    for (uint32_t v = 1; v < c.vertex.size(); ++v)
      if (n.dot(c.vertex[v]) < n.dot(c.vertex[lowest])) lowest = v;
    double least = 1e300;
    for (uint32_t f = 0; f < c.face.size(); ++f) {
      const auto& loop = c.face[f].vertex;
      if (c.face[f].n.dot(n) >= least || std::find(loop.begin(), loop.end(), lowest) == loop.end()) continue;
      least = c.face[f].n.dot(n), best = f;
    }
    return best;
  }
  /// Clips the polygon by side k of the face (Sutherland and Hodgman).
  static void cut(Polygon& polygon, const Vec3& side, double d, uint32_t k) {
    Polygon kept;
    for (int i = 0; i < polygon.size(); ++i) {
      const Corner &c = polygon[i], &next = polygon[i + 1 < polygon.size() ? i + 1 : 0];
      const double h = side.dot(c.p) - d, h_next = side.dot(next.p) - d;
      if (h <= 0) kept.add(c);
      if ((h <= 0) != (h_next <= 0))
        kept.add({c.p + h / (h - h_next) * (next.p - c.p), (((k + 1) & 7u) << 5) | (c.id & 0x1Fu)});
    }
    polygon = kept;
  }

  // --- edges and corners

  static void set_edge(const Convex& c, uint32_t edge, Feature& f) {
    f.kind = Feature::kSegment, f.tube = 0;
    f.p = c.vertex[c.edge[edge].v0], f.u = c.vertex[c.edge[edge].v1] - f.p;
  }
  void add_edges(uint32_t i, uint32_t j, const Vec3& n) {
    Candidate* found = out_.add(axis_.apart);
    if (!found) return;
    set_edge(a_, i, found->a), set_edge(b_, j, found->b);
    found->n_B = n;
    finish(*found, Axis::kEdges, uint64_t{i} << 12 | j, 0, 1);
  }

  /// Adds the closest pair of edges, end points included, of two separated polyhedra, where it is nearer than `least`, the distance that
  /// vertices over faces give.
  void add_closest(double least) {
    Candidate best;
    uint64_t name = 0;
    const auto nearer = [&](const Vec3& p_a, const Vec3& p_b, uint64_t id) {
      const double d = (p_a - p_b).norm();
      if (d >= least || d <= 0) return false;
      least = d, name = id;
      best.n_B = (p_a - p_b) / d;
      return true;
    };
    for (uint32_t i = 0; i < a_.edge.size(); ++i) {
      const toolkit::Segment p{X_BA_ * a_.vertex[a_.edge[i].v0], X_BA_ * a_.vertex[a_.edge[i].v1]};
      for (uint32_t j = 0; j < b_.edge.size(); ++j) {
        const toolkit::Segment q{b_.vertex[b_.edge[j].v0], b_.vertex[b_.edge[j].v1]};
        const toolkit::SegmentPair at = closest(p, q);
        if (nearer(p.point(at.s), q.point(at.t), uint64_t{i} << 12 | j))
          set_edge(a_, i, best.a), set_edge(b_, j, best.b);
      }
    }
    if (best.a.kind == Feature::kPoint) return;  // nothing is nearer
    if (Candidate* found = least <= query_.margin ? out_.add(least) : nullptr) {
      *found = best;
      finish(*found, Axis::kClosest, name, 0, 1);
    }
  }

  void finish(Candidate& c, Axis::Kind kind, uint64_t index, uint32_t point, double weight) {
    if (kind == Axis::kFaceOfA || kind == Axis::kFaceOfB) c.n_B = axis_.n;
    c.feature = (static_cast<uint64_t>(4 + kind) << 40) | (index << 8) | point;
    c.weight = weight;
    c.touch = reevaluate(c, X_WA_, X_WB_);
  }

  const Convex &a_, &b_;
  const Frame &X_WA_, &X_WB_;
  const Frame X_BA_;
  const Query& query_;
  Manifold& out_;
  Axis axis_;
};

}  // namespace

void collide_convex_convex(const Solid& a, const Frame& X_WA, const Solid& b, const Frame& X_WB,
                           const Query& query, Separation& memory, Manifold& out) noexcept {
  ConvexPair(a, X_WA, b, X_WB, query, out).collide(memory);
}

}  // namespace swage::contact
