// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/jaw_angle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "console/view3d/needle_circle.hpp"

namespace swage::console {
namespace {

constexpr float kNear_mm = 1.5F;  // from the tips to the wire: two thirds of a needle's radius. Farther away the angle is still going to change
constexpr float kOpen_mm = 0.3F;  // between the tips: three wires of 0.1 mm. Jaws that hold a needle are closer

constexpr float kTip_mm = 0.6F;   // from a jaw's outermost place to the corners of its tip: twice its thickness at the base

QVector3D placed(const swage_pose& X, const QVector3D& p_B) { return to_mm(X.p) + to_qt(X.q).rotatedVector(p_B); }

/// Corners of a jaw about its tip, mm, world; the tip itself where it has none there.
std::vector<QVector3D> corners(const SceneParts& parts, const Spot& tip, const swage_pose& X) {
  std::vector<QVector3D> out;
  for (const ScenePart& part : parts.part) {
    if (part.role != Role::kTool || part.body != tip.body || part.in_world()) continue;
    for (const Vertex& v : part.mesh.vertex) {
      const QVector3D p_B(v.p[0], v.p[1], v.p[2]);
      if ((p_B - tip.p_B).length() < kTip_mm) out.push_back(placed(X, p_B));
    }
  }
  if (out.empty()) out.push_back(placed(X, tip.p_B));
  return out;
}

/// From one jaw's face to the other's, at their tips: between the two corners that are closest, as the outermost places may be on the backs.
QVector3D between(const std::vector<QVector3D>& one, const std::vector<QVector3D>& other) {
  QVector3D out(1e9F, 0, 0);
  for (const QVector3D& a : one)
    for (const QVector3D& b : other)
      if ((b - a).lengthSquared() < out.lengthSquared()) out = b - a;
  return out;
}

/// Angle [rad] of the smallest rotation about the unit axis `c` after which `z` is perpendicular to `t`; no value where there is none.
std::optional<float> turn_about(const QVector3D& c, const QVector3D& z, const QVector3D& t) {
  // (R z) . t = A cos a + B sin a + C
  const float C = QVector3D::dotProduct(c, z) * QVector3D::dotProduct(c, t);
  const float A = QVector3D::dotProduct(z, t) - C, B = QVector3D::dotProduct(QVector3D::crossProduct(c, z), t);
  const float length = std::hypot(A, B);
  if (length <= std::abs(C)) return {};
  const float middle = std::atan2(B, A), half = std::acos(-C / length);
  const auto wrapped = [](float a) { return std::remainder(a, 2 * std::numbers::pi_v<float>); };
  const float one = wrapped(middle + half), other = wrapped(middle - half);
  return std::abs(one) < std::abs(other) ? one : other;
}

}  // namespace

std::optional<JawAngle> jaw_angle(const snapshot::SceneCard& card, const SceneParts& parts, std::span<const swage_pose> X_WB,
                                  std::span<const Spot> tips) {
  if (tips.size() != 2 || tips[0].body == tips[1].body || tips[0].body >= X_WB.size() || tips[1].body >= X_WB.size()) return {};
  const swage_pose &X0 = X_WB[tips[0].body], &X1 = X_WB[tips[1].body];
  const QVector3D apart = between(corners(parts, tips[0], X0), corners(parts, tips[1], X1));
  if (apart.length() < kOpen_mm) return {};
  JawAngle out;
  out.at = 0.5F * (placed(X0, tips[0].p_B) + placed(X1, tips[1].p_B));
  out.closing = apart.normalized();
  float least = kNear_mm;
  for (const std::vector<QVector3D>& line : wire_lines(card, parts, X_WB)) {
    for (size_t i = 0; i < line.size() && line.size() > 1; ++i) {
      const float far = (line[i] - out.at).length();
      if (far >= least) continue;
      least = far;
      out.wire = (line[std::min(i + 1, line.size() - 1)] - line[i > 0 ? i - 1 : 0]).normalized();
    }
  }
  if (out.wire.isNull()) return {};
  const float off = QVector3D::dotProduct(out.wire, out.closing);
  out.angle = std::asin(std::clamp(std::abs(off), 0.F, 1.F));
  out.faces = (out.wire - off * out.closing).normalized();
  return out;
}

std::optional<JawTurn> jaw_turn(const JawAngle& jaws, const QQuaternion& q_WC) {
  if (jaws.angle <= kAcross) return {};
  // a positive rotation about the axis of the view, and a negative one: the keys of devices/mouse
  const struct {
    QVector3D axis_C;
    int plus, minus;
  } axes[] = {{{0, 0, 1}, Qt::Key_Z, Qt::Key_X}, {{0, 1, 0}, Qt::Key_Right, Qt::Key_Left}, {{1, 0, 0}, Qt::Key_Down, Qt::Key_Up}};
  JawTurn out{0, 1e9F};
  for (const auto& a : axes) {
    const auto angle = turn_about(q_WC.rotatedVector(a.axis_C), jaws.closing, jaws.wire);
    if (angle && std::abs(*angle) < out.angle) out = {*angle > 0 ? a.plus : a.minus, std::abs(*angle)};
  }
  if (out.key == 0) return {};
  return out;
}

}  // namespace swage::console
