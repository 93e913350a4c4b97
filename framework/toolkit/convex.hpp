// SPDX-License-Identifier: Apache-2.0
//
// Convex polyhedra: vertices, outward planes, edges, and the planes between their Voronoi regions.
// Header-only.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "toolkit/math.hpp"

namespace swage::toolkit {

/// Convex polyhedron in its own frame S. Built on [main] by build_convex, read on [rt].
struct Convex {
  struct Face {
    Vec3 n = Vec3::UnitZ();        // unit, outward
    double d = 0;                  // m: n . p = d on the face
    std::vector<uint32_t> vertex;  // counter-clockwise from outside
    std::vector<uint32_t> edge;    // edge[i] leads from vertex[i] to the next
    std::vector<Vec3> side;        // unit, in the face, across edge[i], outward
    std::vector<double> side_d;    // m: side[i] . p = side_d[i] on edge[i]

    /// True above or below the face, beside none of its edges.
    bool covers(const Vec3& p) const {
      for (size_t i = 0; i < side.size(); ++i)
        if (side[i].dot(p) > side_d[i]) return false;
      return true;
    }
  };
  struct Edge {
    uint32_t v0 = 0, v1 = 0;
    uint32_t face_left = 0, face_right = 0;  // the left face has v0 -> v1 counter-clockwise
    Vec3 u = Vec3::UnitX();                  // unit, v0 to v1
    double length = 0;                       // m
    Vec3 side_left = Vec3::UnitY();          // unit, in the left face, across the edge, outward
    Vec3 side_right = Vec3::UnitZ();         // the same in the right face
  };
  std::vector<Vec3> vertex;  // m
  std::vector<Face> face;
  std::vector<Edge> edge;
  std::vector<std::vector<uint32_t>> edges_at;  // per vertex

  /// Height above the highest face: negative inside, a lower bound of the distance outside.
  double height(const Vec3& p) const {
    double highest = -1e300;
    for (const Face& f : face) highest = std::max(highest, f.n.dot(p) - f.d);
    return highest;
  }
  /// Largest n . p over the polyhedron.
  double support(const Vec3& n) const {
    double most = -1e300;
    for (const Vec3& v : vertex) most = std::max(most, n.dot(v));
    return most;
  }
};

namespace convex_detail {

inline Vec3 newell_normal(const Convex& c, const std::vector<uint32_t>& loop) {
  Vec3 n = Vec3::Zero();
  for (size_t i = 0; i < loop.size(); ++i)
    n += (c.vertex[loop[i]] - c.vertex[loop[0]])
             .cross(c.vertex[loop[(i + 1) % loop.size()]] - c.vertex[loop[0]]);
  return n;
}

inline double size(const Convex& c) {
  double largest = 0;
  for (const Vec3& v : c.vertex) largest = std::max(largest, (v - c.vertex[0]).norm());
  return largest;
}

/// Adds the edge from `a` to `b` to face `f`. Returns an empty text, or what is wrong with it.
inline std::string add_edge(Convex& c, uint32_t f, uint32_t a, uint32_t b) {
  for (uint32_t k = 0; k < c.edge.size(); ++k) {
    Convex::Edge& e = c.edge[k];
    if (e.v0 == a && e.v1 == b) return "two faces use one edge in the same direction";
    if (e.v0 != b || e.v1 != a) continue;
    if (e.face_right != e.face_left) return "three faces share one edge";
    e.face_right = f;
    c.face[f].edge.push_back(k);
    return {};
  }
  c.face[f].edge.push_back(static_cast<uint32_t>(c.edge.size()));
  Convex::Edge e;
  e.v0 = a, e.v1 = b, e.face_left = e.face_right = f;
  c.edge.push_back(e);
  return {};
}

/// Fills directions of edges and planes between Voronoi regions; all faces and edges are known.
inline void finish(Convex& c) {
  c.edges_at.assign(c.vertex.size(), {});
  for (uint32_t k = 0; k < c.edge.size(); ++k) {
    Convex::Edge& e = c.edge[k];
    const Vec3 d = c.vertex[e.v1] - c.vertex[e.v0];
    e.length = d.norm();
    e.u = d / e.length;
    e.side_left = e.u.cross(c.face[e.face_left].n);
    e.side_right = c.face[e.face_right].n.cross(e.u);
    c.edges_at[e.v0].push_back(k);
    c.edges_at[e.v1].push_back(k);
  }
  for (uint32_t f = 0; f < c.face.size(); ++f)
    for (const uint32_t k : c.face[f].edge) {
      const Convex::Edge& e = c.edge[k];
      const Vec3& side = e.face_left == f ? e.side_left : e.side_right;
      c.face[f].side.push_back(side);
      c.face[f].side_d.push_back(side.dot(c.vertex[e.v0]));
    }
}

}  // namespace convex_detail

/// [main] Builds a polyhedron from vertices [m] and faces: face i has the vertices
/// face_vertex[face_start[i] .. face_start[i + 1]), counter-clockwise seen from outside; face_start has one
/// entry more than there are faces. Returns an empty text, or what is wrong: the polyhedron must be closed,
/// convex and bounded by planar faces, each to 1e-6 of its size.
inline std::string build_convex(std::span<const Vec3> vertex, std::span<const uint32_t> face_start,
                                std::span<const uint32_t> face_vertex, Convex& out) {
  out = {};
  out.vertex.assign(vertex.begin(), vertex.end());
  if (vertex.size() < 4 || face_start.size() < 5) return "a polyhedron has at least 4 vertices and 4 faces";
  for (const Vec3& v : vertex)
    if (!v.allFinite()) return "a vertex is not finite";
  const double size = convex_detail::size(out), tolerance = 1e-6 * size;

  // faces with their planes
  for (size_t i = 0; i + 1 < face_start.size(); ++i) {
    if (face_start[i + 1] < face_start[i] + 3 || face_start[i + 1] > face_vertex.size())
      return "a face has fewer than 3 vertices";
    Convex::Face f;
    f.vertex.assign(face_vertex.begin() + face_start[i], face_vertex.begin() + face_start[i + 1]);
    for (const uint32_t v : f.vertex)
      if (v >= vertex.size()) return "a face names a vertex that does not exist";
    const Vec3 n = convex_detail::newell_normal(out, f.vertex);
    if (!(n.norm() > tolerance * size)) return "a face has no area";
    f.n = n.normalized();
    double sum = 0;
    for (const uint32_t v : f.vertex) sum += f.n.dot(vertex[v]);
    f.d = sum / static_cast<double>(f.vertex.size());
    for (const uint32_t v : f.vertex)
      if (std::abs(f.n.dot(vertex[v]) - f.d) > tolerance) return "a face is not planar";
    out.face.push_back(std::move(f));
  }

  // edges, each between two faces
  for (uint32_t f = 0; f < out.face.size(); ++f) {
    const std::vector<uint32_t> loop = out.face[f].vertex;
    for (size_t i = 0; i < loop.size(); ++i) {
      const uint32_t a = loop[i], b = loop[(i + 1) % loop.size()];
      if (!((vertex[a] - vertex[b]).norm() > tolerance)) return "an edge has no length";
      const std::string problem = convex_detail::add_edge(out, f, a, b);
      if (!problem.empty()) return problem;
    }
  }
  for (const Convex::Edge& e : out.edge)
    if (e.face_left == e.face_right) return "the surface is not closed";
  if (out.vertex.size() + out.face.size() != out.edge.size() + 2)
    return "a vertex is unused, or the surface is not one closed piece (V - E + F must be 2)";

  // outward and convex
  for (const Convex::Face& f : out.face)
    for (const Vec3& v : out.vertex)
      if (f.n.dot(v) > f.d + tolerance) return "not convex, or a face runs clockwise seen from outside";
  convex_detail::finish(out);
  return {};
}

/// The same polyhedron in frame F: vertices X_FS p.
inline Convex transformed(const Convex& convex, const Pose& X_FS) {
  Convex out = convex;
  for (Vec3& v : out.vertex) v = X_FS * v;
  for (Convex::Face& f : out.face) {
    f.n = X_FS.q * f.n;
    f.d += f.n.dot(X_FS.p);
    f.side.clear(), f.side_d.clear();
  }
  convex_detail::finish(out);
  return out;
}

}  // namespace swage::toolkit
