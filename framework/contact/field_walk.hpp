// SPDX-License-Identifier: Apache-2.0
//
// A curve over a height field: all places where its distance to the surface has a local minimum, along the curve and on the
// surface alike, and the ends of the parts that lie flat. Room-internal; README.md states the method.
#pragma once

#include <algorithm>
#include <array>

#include "contact/walk.hpp"
#include "toolkit/height_field.hpp"

namespace swage::contact {

/// The closest feature of a height field, and its index within the field.
struct FieldFeature {
  Region::Kind kind = Region::kFace;
  uint32_t index = 0;     // face: the triangle. edge: 3 x vertex + 0, 1, 2. vertex: its number
  Vec3 p = Vec3::Zero();  // face: a corner. edge: its start. vertex: itself
  Vec3 u = Vec3::Zero();  // face: its normal, unit. edge: end - start
};

/// The part of a curve over one triangle.
template <class Curve>
struct FieldPiece {
  typename Curve::Place from{}, to{};
  Border at_from = Border::kEnd, at_to = Border::kEnd;
  uint32_t triangle = 0;
  Vec3 n = Vec3::UnitZ(), corner = Vec3::Zero();
  typename Curve::Height height;  // of the curve over the triangle's plane
  int next = -1;           // piece over the next triangle, where both lie in about one plane; -1: none
  bool continues = false;  // this piece is `next` of another one
  bool under = false;      // the curve is under the surface
};

/// Calls dip(feature, place, range, branch) at each local minimum nearer than `reach` and flat_end(feature, place, run) at the
/// ends of each run over triangles in about one plane. Frame H of the field.
template <class Curve>
class FieldWalk {
 public:
  using Place = typename Curve::Place;
  using Height = typename Curve::Height;
  using Piece = FieldPiece<Curve>;
  using Pieces = toolkit::FixedVector<Piece, 256>;

  /// `below`: how far under the surface the solid reaches, m.
  FieldWalk(const Curve& curve, const toolkit::HeightField& field, double radius, double reach, double below)
      : curve_(curve), field_(field), radius_(radius), reach_(reach), below_(below) {}

  template <class Dip, class FlatEnd>
  void walk(Dip&& dip, FlatEnd&& flat_end) {
    find_pieces([&](uint32_t i, uint32_t j) {
      add_faces(i, j);
      for (uint32_t k = 0; k < 3; ++k) walk_edge(i, j, k, dip);
      walk_vertex(i, j, dip);
    });
    link();
    for (int k = 0; k < piece_.size(); ++k)
      if (!piece_[k].continues) walk_run(k, dip, flat_end);
  }
  /// Number of pieces that the table had no room for.
  int dropped() const { return dropped_; }
  const Piece& piece(int k) const { return piece_[k]; }

 private:
  /// Triangles tilted against each other by less than this are one face: their common edge is no feature. 0.03 rad: a wire
  /// of 50 um across such a ridge lies 6 nm too deep.
  static constexpr double kSmooth = 0.03;
  /// Overlap of neighbouring regions, in sides of a cell: a wire along their border lies in one of them.
  static constexpr double kOverlap = 1e-9;

  static constexpr uint32_t kNone = 0xFFFFFFFFu;
  using Corners = toolkit::HeightField::Corners;

  struct Span {
    double low = 1e300, high = -1e300;
  };
  /// The range of the stretches along a direction.
  Span span(const Stretches<Curve>& list, const Vec3& axis) const {
    const Height up = curve_.height(axis, 0), down = curve_.height(-axis, 0);
    Span s;
    for (const auto& part : list) {
      s.low =
          std::min({s.low, up.at(part.from), up.at(part.to), up.at(Curve::valley(up, part.from, part.to))});
      s.high = std::max(
          {s.high, up.at(part.from), up.at(part.to), -down.at(Curve::valley(down, part.from, part.to))});
    }
    return s;
  }
  struct Rows {
    uint32_t first = 1, last = 0;
  };
  /// Vertices whose cells begin within reach of the span.
  Rows rows(Span s, double side, uint32_t n) const {
    const double low = std::floor((s.low - reach_) / side), high = std::floor((s.high + reach_) / side);
    if (high < -1 || low > n) return {};
    return {static_cast<uint32_t>(std::max(low, 0.0)),
            static_cast<uint32_t>(std::clamp(high, 0.0, static_cast<double>(n) - 1))};
  }
  void cut(Stretches<Curve>& list, const Vec3& axis, double low, double high) const {
    clip<Curve>(list, curve_.height(axis, high));
    clip<Curve>(list, curve_.height(-axis, -low));
  }

  /// Visits each vertex (i, j) whose cell has some of the curve above it or within reach; near_ is that part of the curve.
  template <class Visit>
  void find_pieces(Visit&& visit) {
    Stretches<Curve> all;
    fill(all, curve_);
    const Rows row = rows(span(all, Vec3::UnitY()), field_.dy, field_.ny);
    for (uint32_t j = row.first; j <= row.last; ++j) {
      Stretches<Curve> in_row = all;
      cut(in_row, Vec3::UnitY(), j * field_.dy - reach_, (j + 1) * field_.dy + reach_);
      if (in_row.empty()) continue;
      const Rows column = rows(span(in_row, Vec3::UnitX()), field_.dx, field_.nx);
      for (uint32_t i = column.first; i <= column.last; ++i) {
        near_ = in_row;
        cut(near_, Vec3::UnitX(), i * field_.dx - reach_, (i + 1) * field_.dx + reach_);
        if (!near_.empty() && within_height(i, j)) visit(i, j);
      }
    }
  }
  bool within_height(uint32_t i, uint32_t j) const {
    double low = 1e300, high = -1e300;
    for (uint32_t b = j; b <= std::min(j + 1, field_.ny - 1); ++b)
      for (uint32_t a = i; a <= std::min(i + 1, field_.nx - 1); ++a)
        low = std::min(low, field_.height(a, b)), high = std::max(high, field_.height(a, b));
    const Span s = span(near_, Vec3::UnitZ());
    return s.low <= high + reach_ && s.high >= low - below_;
  }

  bool has_cell(uint32_t i, uint32_t j) const { return i + 1 < field_.nx && j + 1 < field_.ny; }
  uint32_t triangle(uint32_t i, uint32_t j, uint32_t half) const { return 2 * (j * field_.nx + i) + half; }
  Vec3 normal(uint32_t t) const { return field_.corners(t).normal().normalized(); }

  // --- faces

  /// Above the surface a face owns the places nearest to it, under the surface those straight below it.
  void add_faces(uint32_t i, uint32_t j) {
    if (!has_cell(i, j)) return;
    for (uint32_t half = 0; half < 2; ++half) {
      Piece p;
      p.triangle = triangle(i, j, half);
      const auto c = field_.corners(p.triangle);
      p.n = c.normal().normalized(), p.corner = c.a;
      p.height = curve_.height(p.n, p.n.dot(c.a));
      add_above(c, p);
      add_under(c, p);
    }
  }
  void add_above(const Corners& c, Piece& p) {
    Stretches<Curve> over = near_;
    clip<Curve>(over, curve_.height(p.n, p.n.dot(c.a) + reach_));
    if (over.empty()) return;
    const Vec3* corner[3] = {&c.a, &c.b, &c.c};
    for (uint32_t k = 0; k < 3 && !over.empty(); ++k) {
      const Vec3 side = border(*corner[(k + 1) % 3] - *corner[k], p, k);
      clip<Curve>(over, curve_.height(side, side.dot(*corner[k]) + kOverlap * field_.dx), Border::kJoined);
    }
    clip<Curve>(over, curve_.height(-p.n, -p.n.dot(c.a)), Border::kJoined);
    p.under = false;
    add_pieces(over, p);
  }
  void add_under(const Corners& c, Piece& p) {
    Stretches<Curve> under = near_;
    clip<Curve>(under, curve_.height(p.n, p.n.dot(c.a)), Border::kJoined);
    if (under.empty()) return;
    const Vec3* corner[3] = {&c.a, &c.b, &c.c};
    for (int k = 0; k < 3 && !under.empty(); ++k) {
      const Vec3 side = (*corner[(k + 1) % 3] - *corner[k]).cross(Vec3::UnitZ()).normalized();
      clip<Curve>(under, curve_.height(side, side.dot(*corner[k]) + kOverlap * field_.dx), Border::kJoined);
    }
    clip<Curve>(under, curve_.height(-p.n, -p.n.dot(c.a) + below_));
    p.under = true;
    add_pieces(under, p);
  }
  void add_pieces(const Stretches<Curve>& list, Piece& p) {
    for (const auto& s : list) {
      p.from = s.from, p.to = s.to, p.at_from = s.at_from, p.at_to = s.at_to;
      dropped_ += !piece_.add(p);
    }
  }
  /// Normal of the plane that bounds the places above a face at its side k, `along`: perpendicular to the face or, at a ridge that is no
  /// feature, midway between the two faces, where both are equally far.
  Vec3 border(const Vec3& along, const Piece& p, uint32_t k) const {
    const Vec3 side = along.cross(p.n).normalized();
    const uint32_t other = neighbour(p.triangle, k);
    if (other == kNone) return side;
    const Vec3 m = normal(other);
    if (side.dot(m) <= 0 || !smooth(p.n, m)) return side;
    return along.cross(p.n + m).normalized();
  }
  static bool smooth(const Vec3& n, const Vec3& m) { return (n - m).squaredNorm() < kSmooth * kSmooth; }
  /// The triangle beyond side k, from corner k to the next; kNone at the border of the field.
  uint32_t neighbour(uint32_t t, uint32_t k) const {
    const uint32_t i = t / 2 % field_.nx, j = t / 2 / field_.nx;
    if (t % 2 == 0) {
      if (k == 0) return j > 0 ? triangle(i, j - 1, 1) : kNone;
      if (k == 1) return i + 2 < field_.nx ? triangle(i + 1, j, 1) : kNone;
      return triangle(i, j, 1);
    }
    if (k == 0) return triangle(i, j, 0);
    if (k == 1) return j + 2 < field_.ny ? triangle(i, j + 1, 0) : kNone;
    return i > 0 ? triangle(i - 1, j, 0) : kNone;
  }

  /// Orders the pieces along the curve and links each to the piece that continues it.
  void link() {
    std::sort(piece_.begin(), piece_.end(), [](const Piece& a, const Piece& b) {
      const double x = Curve::order(a.from), y = Curve::order(b.from);
      return x != y ? x < y : a.triangle < b.triangle;
    });
    for (int k = 1; k < piece_.size(); ++k)
      for (int m = k - 1; m >= 0 && !piece_[k].continues; --m)
        if (piece_[m].next < 0 && follows(piece_[m], piece_[k])) {
          piece_[m].next = k;
          piece_[k].continues = true;
        }
  }
  bool follows(const Piece& a, const Piece& b) const {
    if (a.at_to != Border::kJoined || b.at_from != Border::kJoined || !touch(a.triangle, b.triangle)) return false;
    const bool under = a.under && b.under;
    if (!under && !smooth(a.n, b.n)) return false;
    const double apart = (under ? 0 : 2 * kSmooth * (radius_ + reach_)) + 1e-6 * field_.dx;
    return (curve_.point(a.to) - curve_.point(b.from)).squaredNorm() < apart * apart;
  }
  /// Whether the cells of two triangles are the same or neighbours.
  bool touch(uint32_t a, uint32_t b) const {
    const auto near = [](uint32_t p, uint32_t q) { return p <= q + 1 && q <= p + 1; };
    return near(a / 2 % field_.nx, b / 2 % field_.nx) && near(a / 2 / field_.nx, b / 2 / field_.nx);
  }

  template <class Dip, class FlatEnd>
  void walk_run(int head, Dip& dip, FlatEnd& flat_end) {
    bool falling = piece_[head].at_from == Border::kEnd;
    int tail = head;
    for (int k = head; k >= 0; k = piece_[k].next) {
      const Piece& p = piece_[k];
      const RegionDistance<Curve> distance(curve_, p.height);
      const auto visit = [&](Place at) {
        if (p.height.at(at) < reach_) dip(face(p), at, curve_.around(at, p.from, p.to), 0);
      };
      for_each_dip(distance, p.from, p.to, distance.level(radius_), falling, visit);
      if (p.next < 0 && p.at_to == Border::kEnd && falling) visit(p.to);
      const double step = step_after(p);
      if (step > 0 && falling) visit(p.to);
      falling = step < 0 || (falling && step == 0);
      tail = k;
    }
    const Piece &first = piece_[head], &last = piece_[tail];
    const auto middle = curve_.middle(first.from, last.to);
    const Piece* under = &first;
    for (int k = head; k >= 0; k = piece_[k].next)
      if (Curve::order(piece_[k].from) <= Curve::order(middle)) under = &piece_[k];
    const Run run{curve_.length(first.from, last.to), first.height.at(first.from), under->height.at(middle),
                  last.height.at(last.to)};
    if (first.at_from != Border::kClipped) flat_end(face(first), first.from, run);
    if (last.at_to != Border::kClipped) flat_end(face(last), last.to, run);
  }
  /// Jump of the distance [m] where the nearest face changes under a fold; 0 where there is none.
  double step_after(const Piece& p) const {
    if (p.next < 0 || !p.under || smooth(p.n, piece_[p.next].n)) return 0;
    const double step = piece_[p.next].height.at(piece_[p.next].from) - p.height.at(p.to);
    return std::abs(step) > kOverlap * field_.dx ? step : 0;
  }
  static FieldFeature face(const Piece& p) { return {Region::kFace, p.triangle, p.corner, p.n}; }

  // --- edges and vertices, where they are convex

  template <class Dip>
  void walk_edge(uint32_t i, uint32_t j, uint32_t k, Dip& dip) {
    const uint32_t i1 = i + (k != 1), j1 = j + (k != 0);
    if (i1 >= field_.nx || j1 >= field_.ny) return;
    // the triangles beside it, as sides of a cell: 0 along x, 1 along y, 2 the diagonal
    uint32_t beside[2] = {kNone, kNone};
    if (k == 0 && j + 1 < field_.ny) beside[0] = triangle(i, j, 0);
    if (k == 0 && j > 0) beside[1] = triangle(i, j - 1, 1);
    if (k == 1 && i + 1 < field_.nx) beside[0] = triangle(i, j, 1);
    if (k == 1 && i > 0) beside[1] = triangle(i - 1, j, 0);
    if (k == 2) beside[0] = triangle(i, j, 0), beside[1] = triangle(i, j, 1);

    const Vec3 v0 = field_.vertex(i, j), d = field_.vertex(i1, j1) - v0;
    const double length = d.norm(), overlap = kOverlap * field_.dx;
    const Vec3 u = d / length;
    Stretches<Curve> part = near_;
    clip<Curve>(part, curve_.height(-u, -u.dot(v0) + overlap));
    clip<Curve>(part, curve_.height(u, u.dot(v0) + length + overlap));
    Vec3 n[2] = {Vec3::Zero(), Vec3::Zero()};
    for (int s = 0; s < 2 && !part.empty(); ++s) {
      if (beside[s] == kNone) continue;
      const auto c = field_.corners(beside[s]);
      n[s] = c.normal().normalized();
      // away from the triangle, whose centre lies on the other side of the edge
      Vec3 out = u.cross(n[s]);
      if (out.dot((c.a + c.b + c.c) / 3 - v0) > 0) out = -out;
      clip<Curve>(part, curve_.height(-out, -out.dot(v0) + overlap));
      clip<Curve>(part, curve_.height(-n[s], -n[s].dot(v0)));
    }
    const bool border = beside[0] == kNone || beside[1] == kNone;
    if (part.empty() || (!border && smooth(n[0], n[1]))) return;
    const FieldFeature feature{Region::kEdge, 3 * (j * field_.nx + i) + k, v0, d};
    visit_dips(RegionDistance<Curve>(curve_, v0, u), part, feature, dip);
  }

  /// From a vertex to those around it.
  static constexpr int kAround[6][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 0}, {-1, -1}, {0, -1}};

  template <class Dip>
  void walk_vertex(uint32_t i, uint32_t j, Dip& dip) {
    const Vec3 v = field_.vertex(i, j);
    Stretches<Curve> part = near_;
    for (const auto& step : kAround) {
      const uint32_t i1 = i + static_cast<uint32_t>(step[0]), j1 = j + static_cast<uint32_t>(step[1]);
      if (i1 >= field_.nx || j1 >= field_.ny) continue;  // -1 has wrapped around to the largest number
      const Vec3 u = field_.vertex(i1, j1) - v;
      clip<Curve>(part, curve_.height(u, u.dot(v)));
      if (part.empty()) return;
    }
    clip<Curve>(part, curve_.height(-Vec3::UnitZ(), -v.z()));
    if (part.empty() || is_round(i, j)) return;
    const FieldFeature feature{Region::kVertex, j * field_.nx + i, v, Vec3::Zero()};
    visit_dips(RegionDistance<Curve>(curve_, v, Vec3::Zero()), part, feature, dip);
  }

  /// Whether only smooth ridges meet at a vertex: every place near it then belongs to a face.
  bool is_round(uint32_t i, uint32_t j) const {
    if (i == 0 || j == 0 || !has_cell(i, j)) return false;
    const uint32_t around[6] = {triangle(i, j, 0),         triangle(i, j, 1),         triangle(i - 1, j, 0),
                                triangle(i - 1, j - 1, 1), triangle(i - 1, j - 1, 0), triangle(i, j - 1, 1)};
    for (uint32_t k = 0; k < 6; ++k) {
      const Vec3 n = normal(around[(k + 5) % 6]), m = normal(around[k]);
      const Vec3 u = field_.vertex(i + static_cast<uint32_t>(kAround[k][0]), j + static_cast<uint32_t>(kAround[k][1])) -
                     field_.vertex(i, j);
      if (!smooth(n, m) || n.cross(m).dot(u) > 0) return false;
    }
    return true;
  }

  template <class Dip>
  void visit_dips(const RegionDistance<Curve>& distance, const Stretches<Curve>& part,
                  const FieldFeature& feature, Dip& dip) {
    for (const auto& s : part) {
      bool falling = s.at_from == Border::kEnd;
      const auto visit = [&](Place at) {
        if (distance.at(at) < reach_) dip(feature, at, curve_.around(at), distance.branch(at));
      };
      for_each_dip(distance, s.from, s.to, distance.level(radius_), falling, visit);
      if (s.at_to == Border::kEnd && falling) visit(s.to);
    }
  }

 public:
  /// A run over triangles in about one plane: its length and the distance at its ends and in the middle.
  struct Run {
    double length, d0, d, d1;
  };

 private:
  const Curve& curve_;
  const toolkit::HeightField& field_;
  double radius_, reach_, below_;
  Stretches<Curve> near_;
  Pieces piece_;
  int dropped_ = 0;
};

}  // namespace swage::contact
