// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/soft_surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace swage::console {
namespace {

constexpr int kRound = 12;        // corners of half a disc: 1 um off a circle of 50 um
constexpr int kMostPieces = 160;  // of one edge: a patch of 20 mm in pieces of an eighth of a millimetre

QVector3D at(const float v[3]) { return {v[0], v[1], v[2]}; }

void put(const QVector3D& p, const QVector3D& n, Mesh& out) {
  out.vertex.push_back({{p.x(), p.y(), p.z()}, {n.x(), n.y(), n.z()}});
}

// any direction in the plane
QVector3D across(const QVector3D& n) {
  return QVector3D::crossProduct(n, std::abs(n.x()) < 0.9F ? QVector3D(1, 0, 0) : QVector3D(0, 1, 0))
      .normalized();
}

}  // namespace

// every triangle in n x n alike pieces, n the same for all, so that shared edges stay shared
Mesh subdivided(const Mesh& mesh, float longest_mm) {
  float longest = 0;
  for (size_t i = 0; i + 2 < mesh.index.size(); i += 3) {
    for (size_t k = 0; k < 3; ++k) {
      const QVector3D a = at(mesh.vertex[mesh.index[i + k]].p),
                      b = at(mesh.vertex[mesh.index[i + (k + 1) % 3]].p);
      longest = std::max(longest, (a - b).length());
    }
  }
  const int n = std::clamp(static_cast<int>(std::ceil(longest / longest_mm)), 1, kMostPieces);
  Mesh out;
  for (size_t i = 0; i + 2 < mesh.index.size(); i += 3) {
    const Vertex &a = mesh.vertex[mesh.index[i]], &b = mesh.vertex[mesh.index[i + 1]],
                 &c = mesh.vertex[mesh.index[i + 2]];
    const auto first = static_cast<uint32_t>(out.vertex.size());
    // rows from the side a-b towards c
    for (int row = 0; row <= n; ++row) {
      for (int k = 0; k <= n - row; ++k) {
        const float v = static_cast<float>(k) / static_cast<float>(n),
                    w = static_cast<float>(row) / static_cast<float>(n);
        const float u = 1 - v - w;
        put(u * at(a.p) + v * at(b.p) + w * at(c.p), (u * at(a.n) + v * at(b.n) + w * at(c.n)).normalized(),
            out);
      }
    }
    uint32_t row_start = first;
    for (int row = 0; row < n; ++row) {
      const auto width = static_cast<uint32_t>(n - row + 1);
      for (uint32_t k = 0; k + 1 < width; ++k) {
        const uint32_t p = row_start + k, q = row_start + width + k;
        out.index.insert(out.index.end(), {p, p + 1, q});
        if (k + 2 < width) out.index.insert(out.index.end(), {p + 1, q + 1, q});
      }
      row_start += width;
    }
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

void append_tears(const std::vector<Tear>& tears, const std::vector<Dent>& dents, float grow, float lift,
                  Mesh& out) {
  for (const Tear& t : tears) {
    QVector3D along = t.b - t.a;
    along -= QVector3D::dotProduct(along, t.normal) * t.normal;
    along = along.length() > 1e-6F ? along.normalized() : across(t.normal);
    const QVector3D side = QVector3D::crossProduct(t.normal, along);
    const auto first = static_cast<uint32_t>(out.vertex.size());
    const auto corner = [&](const QVector3D& p) {
      put(p + displacement(dents, p) + lift * t.normal, t.normal, out);
    };
    corner(0.5F * (t.a + t.b));
    // round b, then round a, counter-clockwise seen from outside
    for (int end = 0; end < 2; ++end) {
      for (int k = 0; k <= kRound; ++k) {
        const float angle = static_cast<float>(std::numbers::pi) *
                            (static_cast<float>(k) / kRound + static_cast<float>(end) - 0.5F);
        const QVector3D out_from = std::cos(angle) * along + std::sin(angle) * side;
        corner((end == 0 ? t.b : t.a) + (t.radius + grow) * out_from);
      }
    }
    const uint32_t n = 2 * (kRound + 1);
    for (uint32_t k = 0; k < n; ++k)
      out.index.insert(out.index.end(), {first, first + 1 + k, first + 1 + (k + 1) % n});
  }
}

}  // namespace swage::console
