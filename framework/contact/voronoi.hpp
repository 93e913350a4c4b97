// SPDX-License-Identifier: Apache-2.0
//
// The Voronoi regions of a convex polyhedron: where a face, edge or vertex is the closest feature, and, inside, which
// face is the least deep. All borders are planes. Room-internal.
#pragma once

#include <cstdint>

#include "toolkit/convex.hpp"

namespace swage::contact {

using toolkit::Convex;
using toolkit::Vec3;

struct Region {
  enum Kind : uint8_t { kFace, kInside, kEdge, kVertex };
  Kind kind = kFace;
  uint32_t index = 0;

  bool operator==(const Region&) const = default;
};

/// Calls visit(n, d, next) for each border of a region: outside it, n . p > d, and beyond lies `next`.
template <class Visit>
void for_each_border(const Convex& c, Region region, Visit&& visit) {
  switch (region.kind) {
    case Region::kFace: {
      const Convex::Face& f = c.face[region.index];
      for (size_t i = 0; i < f.edge.size(); ++i)
        visit(f.side[i], f.side_d[i], Region{Region::kEdge, f.edge[i]});
      visit(-f.n, -f.d, Region{Region::kInside, region.index});
      return;
    }
    case Region::kInside: {
      const Convex::Face& f = c.face[region.index];
      visit(f.n, f.d, Region{Region::kFace, region.index});
      for (uint32_t j = 0; j < c.face.size(); ++j)
        if (j != region.index) visit(c.face[j].n - f.n, c.face[j].d - f.d, Region{Region::kInside, j});
      return;
    }
    case Region::kEdge: {
      const Convex::Edge& e = c.edge[region.index];
      const Vec3 &v0 = c.vertex[e.v0], &v1 = c.vertex[e.v1];
      visit(-e.side_left, -e.side_left.dot(v0), Region{Region::kFace, e.face_left});
      visit(-e.side_right, -e.side_right.dot(v0), Region{Region::kFace, e.face_right});
      visit(-e.u, -e.u.dot(v0), Region{Region::kVertex, e.v0});
      visit(e.u, e.u.dot(v1), Region{Region::kVertex, e.v1});
      return;
    }
    case Region::kVertex: {
      const Vec3& v = c.vertex[region.index];
      for (const uint32_t k : c.edges_at[region.index]) {
        const Vec3 u = c.edge[k].v0 == region.index ? c.edge[k].u : Vec3(-c.edge[k].u);
        visit(u, u.dot(v), Region{Region::kEdge, k});
      }
      return;
    }
  }
}

/// The region that p lies in. On a border, any of its neighbours.
inline Region locate(const Convex& c, const Vec3& p) {
  // start at the highest face and cross the most violated border until none is
  Region region{Region::kInside, 0};
  double highest = -1e300;
  for (uint32_t i = 0; i < c.face.size(); ++i) {
    const double h = c.face[i].n.dot(p) - c.face[i].d;
    if (h > highest) highest = h, region.index = i;
  }
  if (highest <= 0 && !c.face.empty()) return region;
  region.kind = !c.face.empty() ? Region::kFace : !c.edge.empty() ? Region::kEdge : Region::kVertex;
  for (size_t hop = 0; hop < 4 + c.edge.size(); ++hop) {
    Region next = region;
    double most = 0;
    for_each_border(c, region, [&](const Vec3& n, double d, Region beyond) {
      const double violation = n.dot(p) - d;
      if (violation > most && beyond.kind != Region::kInside) most = violation, next = beyond;
    });
    if (next == region) return region;
    region = next;
  }

  // rounding made the search cycle: p is at a border, and any region there is as good
  double least = 1e300;
  for (uint32_t k = 0; k < c.edge.size(); ++k) {
    const Convex::Edge& e = c.edge[k];
    const double t = e.u.dot(p - c.vertex[e.v0]);
    const double inside = std::clamp(t, 0.0, e.length);
    const double d = (p - c.vertex[e.v0] - inside * e.u).squaredNorm();
    if (d >= least) continue;
    least = d;
    region = t < 0          ? Region{Region::kVertex, e.v0}
             : t > e.length ? Region{Region::kVertex, e.v1}
                            : Region{Region::kEdge, k};
  }
  return region;
}

}  // namespace swage::contact
