// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/visual_marks.hpp"

#include <QQuaternion>
#include <algorithm>

namespace swage::console {

namespace {

constexpr double kLine_px = 1.5;  // least width of a line: narrower, it would be broken by the picture's pixels
constexpr double kFlat = 0.02;    // half the thickness of a disc over its radius: enough to be seen over a surface on which it lies

void append_disc(const swage_visual& v, double radius, Mesh& out) {
  snapshot::CardShape disc;
  disc.kind = SWAGE_SHAPE_CYLINDER;
  const QVector3D normal(static_cast<float>(v.direction.x), static_cast<float>(v.direction.y), static_cast<float>(v.direction.z));
  const QQuaternion q = normal.isNull() ? QQuaternion() : QQuaternion::rotationTo({0, 0, 1}, normal);
  disc.X_BS = {v.a, {q.scalar(), q.x(), q.y(), q.z()}};
  disc.radius = radius;
  disc.half_length = kFlat * radius;
  append_shape(disc, out);
}

}  // namespace

bool append_marks(const snapshot::Snapshot& s, double mm_per_pixel, std::span<Mesh* const, SWAGE_TONES> by_tone) {
  bool any = false;
  for (uint32_t i = 0; i < s.n_visual; ++i) {
    const swage_visual& v = s.visual[i].visual;
    if (v.kind < SWAGE_VISUAL_LINE || v.strength <= 0 || v.tone >= SWAGE_TONES) continue;
    Mesh& out = *by_tone[v.tone];
    const double radius = v.strength * v.radius, points[] = {v.a.x, v.a.y, v.a.z, v.b.x, v.b.y, v.b.z};
    if (v.kind == SWAGE_VISUAL_LINE) append_thread(points, 2, std::max(radius, 0.5 * kLine_px * mm_per_pixel / kMmPerM), out);
    if (v.kind == SWAGE_VISUAL_TUBE) append_thread(points, 2, radius, out);
    if (v.kind == SWAGE_VISUAL_DISC) append_disc(v, radius, out);
    any = true;
  }
  return any;
}

}  // namespace swage::console
