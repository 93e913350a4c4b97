// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/soft_surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace swage::console {
namespace {

constexpr int kMostRounds = 12;  // of edge halving: from a wall of 20 mm to 5 um
constexpr float kStill_mm =
    0.05F;  // a smaller change of a dent does not change the mesh, so that the lighting does not flicker

QVector3D at(const float v[3]) { return {v[0], v[1], v[2]}; }

void put(const QVector3D& p, const QVector3D& n, Mesh& out) {
  out.vertex.push_back({{p.x(), p.y(), p.z()}, {n.x(), n.y(), n.z()}});
}

// Halves long edges and splits their triangles into two, three or four. False when no edge was halved.
template <class TooLong>
bool halve_edges(Mesh& mesh, const TooLong& too_long) {
  std::vector<uint32_t> parted;
  parted.reserve(2 * mesh.index.size());
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
  const auto middle = [&](uint32_t a, uint32_t b) {
    const auto [it, fresh] =
        middles.try_emplace(std::minmax(a, b), static_cast<uint32_t>(mesh.vertex.size()));
    if (fresh) {
      const Vertex va = mesh.vertex[a], vb = mesh.vertex[b];
      put(0.5F * (at(va.p) + at(vb.p)), (at(va.n) + at(vb.n)).normalized(), mesh);
    }
    return it->second;
  };
  for (size_t i = 0; i + 2 < mesh.index.size(); i += 3) {
    uint32_t v[3];
    bool cut[3];
    for (size_t k = 0; k < 3; ++k) v[k] = mesh.index[i + k];
    for (size_t k = 0; k < 3; ++k) cut[k] = too_long(mesh.vertex[v[k]], mesh.vertex[v[(k + 1) % 3]]);
    const int n = cut[0] + cut[1] + cut[2];
    // rotates the triangle so that the odd edge comes first: the only one halved, or, of two, the only one kept
    size_t first = 0;
    while (n > 0 && n < 3 && cut[first] != (n == 1)) ++first;
    const uint32_t a = v[first], b = v[(first + 1) % 3], c = v[(first + 2) % 3];
    if (n == 0) {
      parted.insert(parted.end(), {a, b, c});
    } else if (n == 1) {
      const uint32_t m = middle(a, b);
      parted.insert(parted.end(), {a, m, c, m, b, c});
    } else if (n == 2) {
      const uint32_t p = middle(b, c), q = middle(c, a);
      parted.insert(parted.end(), {a, b, p, a, p, q, q, p, c});
    } else {
      const uint32_t m = middle(a, b), p = middle(b, c), q = middle(c, a);
      parted.insert(parted.end(), {a, m, q, m, b, p, q, p, c, m, p, q});
    }
  }
  mesh.index.swap(parted);
  return !middles.empty();
}

}  // namespace

// Whether an edge is halved depends on the edge alone, so that both its triangles agree and no gap opens between them.
Mesh refined(const Mesh& mesh, const QMatrix4x4& X_WB, const std::vector<Dent>& dents, float share) {
  const QMatrix4x4 X_BW = X_WB.inverted();
  std::vector<Dent> near;
  for (const Dent& d : dents) {
    const QVector3D p = X_BW.map(d.p) / kStill_mm;
    near.push_back(
        {kStill_mm * QVector3D(std::round(p.x()), std::round(p.y()), std::round(p.z())), {}, d.radius});
  }
  const auto too_long = [&](const Vertex& a, const Vertex& b) {
    const QVector3D middle = 0.5F * (at(a.p) + at(b.p));
    const float length = (at(a.p) - at(b.p)).length();
    return std::any_of(near.begin(), near.end(), [&](const Dent& d) {
      return length > share * std::max((middle - d.p).length() - kStill_mm, d.radius);
    });
  };
  Mesh out = mesh;
  for (int round = 0; round < kMostRounds && halve_edges(out, too_long); ++round) {
  }
  return out;
}

QVector3D displacement(const std::vector<Dent>& dents, const QVector3D& p) {
  QVector3D sum;
  for (const Dent& d : dents) sum += d.u / std::sqrt(1 + (p - d.p).lengthSquared() / (d.radius * d.radius));
  return sum;
}

// With f(r) = 1/sqrt(1 + (r/R)^2), grad f = -(p - p0)/R^2 f^3. A surface with normal n that is displaced by u f has, to first
// order, the normal n - (u.n) grad_t f, grad_t the part of the gradient in the surface.
void displace(const Mesh& rest, const QMatrix4x4& X_WB, const std::vector<Dent>& dents, Mesh& out) {
  out.index = rest.index;
  out.vertex.resize(rest.vertex.size());
  const QMatrix4x4 X_BW = X_WB.inverted();
  for (size_t i = 0; i < rest.vertex.size(); ++i) {
    const QVector3D p = X_WB.map(at(rest.vertex[i].p)), n = X_WB.mapVector(at(rest.vertex[i].n));
    QVector3D moved = p, bent = n;
    for (const Dent& d : dents) {
      const QVector3D from = p - d.p;
      const float r2 = d.radius * d.radius, f = 1 / std::sqrt(1 + from.lengthSquared() / r2);
      moved += f * d.u;
      const QVector3D gradient = -f * f * f / r2 * from;
      bent -= QVector3D::dotProduct(d.u, n) * (gradient - QVector3D::dotProduct(gradient, n) * n);
    }
    const QVector3D p_B = X_BW.map(moved), n_B = X_BW.mapVector(bent).normalized();
    out.vertex[i] = {{p_B.x(), p_B.y(), p_B.z()}, {n_B.x(), n_B.y(), n_B.z()}};
  }
}

}  // namespace swage::console
