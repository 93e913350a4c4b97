// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/needle_circle.hpp"

#include <algorithm>
#include <cmath>

namespace swage::console {
namespace {

constexpr int kPoints = 33;         // of an arc: 0.1 mm apart on a needle of 3 mm
constexpr float kStraight = 1e-3F;  // height over chord below which a wire counts as straight
constexpr float kClosed = 1e-4F;  // square of the gap between both ends over that to the middle: a ring is no needle, and has no point to lead

using Line = std::vector<QVector3D>;  // mm, world, from the point to the swage

Line line_of(const snapshot::CardShape& arc, const swage_pose& X) {
  Line out;
  for (int i = 0; i < kPoints; ++i) {
    const double a = arc.sweep * i / (kPoints - 1);
    const QVector3D p_S(static_cast<float>(kMmPerM * arc.arc_radius * std::cos(a)),
                        static_cast<float>(kMmPerM * arc.arc_radius * std::sin(a)), 0);
    out.push_back(to_mm(X.p) +
                  to_qt(X.q).rotatedVector(to_mm(arc.X_BS.p) + to_qt(arc.X_BS.q).rotatedVector(p_S)));
  }
  return out;
}

Line line_of(const WireChain& chain, std::span<const swage_pose> X_WB) {
  Line out;
  const std::vector<double> xyz = chain.centre_line(X_WB);
  for (size_t i = 0; i + 2 < xyz.size(); i += 3) out.push_back(to_mm({xyz[i], xyz[i + 1], xyz[i + 2]}));
  return out;
}

float distance(const Line& line, const QVector3D& p) {
  float least = 1e30F;
  for (const QVector3D& q : line) least = std::min(least, (q - p).length());
  return least;
}

// of the triangle of a, b, c, from a: ((|v|^2 u - |u|^2 v) x ...) / 2 |u x v|^2, u and v from a to b and c
std::optional<NeedleCircle> through(const QVector3D& a, const QVector3D& b, const QVector3D& c) {
  const QVector3D u = b - a, v = c - a, w = QVector3D::crossProduct(u, v);
  if (v.lengthSquared() < kClosed * u.lengthSquared() || w.length() < kStraight * v.lengthSquared()) return {};
  const QVector3D to_centre = (QVector3D::crossProduct(w, u) * v.lengthSquared() +
                               QVector3D::crossProduct(v, w) * u.lengthSquared()) /
                              (2 * w.lengthSquared());
  // right-handed about w the order is a, b, c; the axis is reversed, as the point, a, must lead
  return NeedleCircle{a + to_centre, -w.normalized(), to_centre.length()};
}

}  // namespace

std::vector<std::vector<QVector3D>> wire_lines(const snapshot::SceneCard& card, const SceneParts& parts,
                        std::span<const swage_pose> X_WB) {
  std::vector<Line> out;
  for (const WireChain& chain : parts.chains) out.push_back(line_of(chain, X_WB));
  for (const snapshot::CardShape& s : card.shapes) {
    const bool chained = std::any_of(parts.chains.begin(), parts.chains.end(),
                                     [&](const WireChain& chain) { return chain.object == s.object; });
    if (s.kind == SWAGE_SHAPE_ARC && !chained && s.body < X_WB.size() &&
        role_of(card, s.object) == Role::kWork)
      out.push_back(line_of(s, X_WB[s.body]));
  }
  return out;
}

std::optional<NeedleCircle> needle_circle(const snapshot::SceneCard& card, const SceneParts& parts,
                                          std::span<const swage_pose> X_WB, const QVector3D& tips,
                                          float reach) {
  std::optional<NeedleCircle> out;
  for (const Line& line : wire_lines(card, parts, X_WB)) {
    const float far = distance(line, tips);
    if (far > reach || line.size() < 3) continue;
    if (const auto circle = through(line.front(), line[line.size() / 2], line.back())) {
      reach = far;
      out = circle;
    }
  }
  return out;
}

}  // namespace swage::console
