// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/mesh.hpp"

#include <swage/abi/builder.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "console/view3d/vec.hpp"

namespace swage::console {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kAround =
    28;  // facets around a wire: the outline of a wire 60 px thick deviates by less than half a pixel
constexpr int kCapRings = 7;

// a ring of a surface of revolution: its position along the axis, its radius, and the slope of its normal
struct Ring {
  double along, radius, n_along, n_out;
};

// half circle from the pole to the equator (sign -1), or back (sign +1)
void cap_profile(std::vector<Ring>& profile, double at, double radius, int sign) {
  for (int i = 0; i <= kCapRings; ++i) {
    const double step = sign < 0 ? i : kCapRings - i;
    const double a = 0.5 * kPi * step / kCapRings;  // 0 at the pole
    profile.push_back(
        {at + sign * radius * std::cos(a), radius * std::sin(a), sign * std::cos(a), std::sin(a)});
  }
}

void put_vertex(Mesh& mesh, const Vec& p_m, const Vec& n) {
  Vertex v{};
  for (int k = 0; k < 3; ++k) {
    v.p[k] = static_cast<float>(p_m[k] * kMmPerM);
    v.n[k] = static_cast<float>(n[k]);
  }
  mesh.vertex.push_back(v);
}

// two triangles between each pair of neighbouring rings; every ring has kAround + 1 vertices
void stitch(Mesh& mesh, uint32_t first, uint32_t rings) {
  constexpr uint32_t kRing = kAround + 1;
  for (uint32_t r = 0; r + 1 < rings; ++r) {
    for (uint32_t j = 0; j < kAround; ++j) {
      const uint32_t a = first + r * kRing + j, b = a + kRing;
      mesh.index.insert(mesh.index.end(), {a, a + 1, b, a + 1, b + 1, b});
    }
  }
}

// a surface of revolution about z of frame S
void revolve(Mesh& mesh, const swage_pose& X_BS, const std::vector<Ring>& profile) {
  const auto first = static_cast<uint32_t>(mesh.vertex.size());
  for (const Ring& ring : profile) {
    for (int j = 0; j <= kAround; ++j) {
      const double a = 2 * kPi * j / kAround, c = std::cos(a), s = std::sin(a);
      put_vertex(mesh, transform(X_BS, {ring.radius * c, ring.radius * s, ring.along}),
                 rotate(X_BS.q, {ring.n_out * c, ring.n_out * s, ring.n_along}));
    }
  }
  stitch(mesh, first, static_cast<uint32_t>(profile.size()));
}

void append_cylinder(const snapshot::CardShape& s, Mesh& mesh) {
  const double h = s.half_length, r = s.radius;
  // flat ends and the side do not share normals
  revolve(mesh, s.X_BS, {{-h, 0, -1, 0}, {-h, r, -1, 0}});
  revolve(mesh, s.X_BS, {{-h, r, 0, 1}, {h, r, 0, 1}});
  revolve(mesh, s.X_BS, {{h, r, 1, 0}, {h, 0, 1, 0}});
}

constexpr double kPoint = 0.12;  // of the wire's radius: radius at the very tip of a pointed wire

// one ring of a tube: centre, tangent, and two directions across it
struct Station {
  Vec centre, tangent, out, side;
};

// a tube with round ends through the stations, tapered over the length `taper` at its start; normals point away from the centre line
void tube(Mesh& mesh, const std::vector<Station>& line, double radius, double taper = 0) {
  const auto first = static_cast<uint32_t>(mesh.vertex.size());
  uint32_t rings = 0;
  const auto ring = [&](const Station& st, const Ring& shape) {
    for (int j = 0; j <= kAround; ++j) {
      const double a = 2 * kPi * j / kAround;
      const Vec across = st.out * std::cos(a) + st.side * std::sin(a);
      put_vertex(mesh, st.centre + st.tangent * shape.along + across * shape.radius,
                 st.tangent * shape.n_along + across * shape.n_out);
    }
    ++rings;
  };
  std::vector<Ring> start, end;
  cap_profile(start, 0, taper > 0 ? kPoint * radius : radius, -1);
  cap_profile(end, 0, radius, +1);
  for (const Ring& r : start) ring(line.front(), r);
  double along = 0;
  for (size_t i = 1; i + 1 < line.size(); ++i) {
    along += norm(line[i].centre - line[i - 1].centre);
    ring(line[i], {0, radius * (along < taper ? std::max(along / taper, kPoint) : 1), 0, 1});
  }
  for (const Ring& r : end) ring(line.back(), r);
  stitch(mesh, first, rings);
}

void append_convex(const snapshot::CardShape& s, Mesh& mesh) {
  for (const std::vector<uint32_t>& face : s.face) {
    if (face.size() < 3) continue;
    const auto at = [&](size_t i) { return transform(s.X_BS, Vec(s.vertex[face[i]])); };
    const Vec n = normalized(cross(at(1) - at(0), at(2) - at(0)));
    const auto first = static_cast<uint32_t>(mesh.vertex.size());
    for (size_t i = 0; i < face.size(); ++i) put_vertex(mesh, at(i), n);
    for (uint32_t i = 1; i + 1 < face.size(); ++i) {
      mesh.index.insert(mesh.index.end(), {first, first + i, first + i + 1});
    }
  }
}

// part of an arc; one ring every 3 degrees keeps its outline smooth
void arc_tube(const snapshot::CardShape& arc, double from, double to, double grow, Mesh& mesh,
              double taper = 0) {
  const int steps = std::max(2, static_cast<int>(std::ceil(arc.sweep * (to - from) / (kPi / 60))));
  std::vector<Station> line;
  for (int i = 0; i <= steps; ++i) {
    const double a = arc.sweep * (from + (to - from) * i / steps), c = std::cos(a), s = std::sin(a);
    // tangent, out and side are right-handed with side = -z
    line.push_back({transform(arc.X_BS, {arc.arc_radius * c, arc.arc_radius * s, 0}),
                    rotate(arc.X_BS.q, {-s, c, 0}), rotate(arc.X_BS.q, {c, s, 0}),
                    rotate(arc.X_BS.q, {0, 0, -1})});
  }
  tube(mesh, line, arc.radius * grow, taper);
}

}  // namespace

void append_range(const snapshot::CardShape& wire, double from, double to, double grow, Mesh& mesh) {
  if (wire.kind == SWAGE_SHAPE_ARC) return arc_tube(wire, from, to, grow, mesh);
  // a straight wire: a shorter piece of the same axis
  snapshot::CardShape piece = wire;
  piece.kind = SWAGE_SHAPE_CYLINDER;
  piece.half_length = wire.half_length * (to - from);
  piece.radius = wire.radius * grow;
  const Vec middle = transform(wire.X_BS, {0, 0, wire.half_length * (from + to - 1)});
  piece.X_BS.p = {middle.x, middle.y, middle.z};
  append_shape(piece, mesh);
}

void append_thread(const double* points, uint32_t n, double radius, Mesh& mesh, double taper) {
  if (n < 2) return;
  const auto at = [&](uint32_t i) { return Vec(points[3 * i], points[3 * i + 1], points[3 * i + 2]); };
  std::vector<Station> line;
  Vec out{0, 0, 0};
  for (uint32_t i = 0; i < n; ++i) {
    const Vec tangent = normalized(at(std::min(i + 1, n - 1)) - at(i > 0 ? i - 1 : 0));
    // parallel transport of the cross direction, so that the tube does not twist
    if (i == 0) out = any_perpendicular(tangent);
    out = normalized(out - tangent * dot(out, tangent));
    line.push_back({at(i), tangent, out, cross(tangent, out)});
  }
  tube(mesh, line, radius, taper);
}

void append_shape(const snapshot::CardShape& s, Mesh& mesh, double taper) {
  std::vector<Ring> profile;
  switch (s.kind) {
    case SWAGE_SHAPE_SPHERE:
      cap_profile(profile, 0, s.radius, -1);
      cap_profile(profile, 0, s.radius, +1);
      return revolve(mesh, s.X_BS, profile);
    case SWAGE_SHAPE_CAPSULE:
      cap_profile(profile, -s.half_length, s.radius, -1);
      cap_profile(profile, s.half_length, s.radius, +1);
      return revolve(mesh, s.X_BS, profile);
    case SWAGE_SHAPE_CYLINDER:
      return append_cylinder(s, mesh);
    case SWAGE_SHAPE_ARC:
      return arc_tube(s, 0, 1, 1, mesh, taper);
    case SWAGE_SHAPE_CONVEX:
    case SWAGE_SHAPE_HEIGHT_FIELD:
      return append_convex(s, mesh);
    default:
      return;
  }
}

}  // namespace swage::console
