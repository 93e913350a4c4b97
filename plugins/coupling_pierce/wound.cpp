// SPDX-License-Identifier: Apache-2.0
#include "wound.hpp"

#include <algorithm>
#include <cmath>

namespace swage::coupling_pierce {
namespace {

constexpr double kFine = 0.02;    // of the radius: what moves less has not moved
constexpr double kCorner = 0.05;  // of the radius: what one capsule may cut off the path that it stands for

Vec2 vec2(const double* a) { return {a[0], a[1]}; }

double distance(const Vec2& p, const Capsule& c) { return std::sqrt(Line(c).distance2(p)); }

/// Adds the capsule from a to b; `goes_on`: a path that may lengthen the last one.
void cover(Wound& w, Outline& settled, const Vec2& a, const Vec2& b, bool goes_on) {
  const double fine = kFine * w.radius;
  auto n = static_cast<uint32_t>(w.count);
  for (uint32_t i = 0; i < n; ++i)
    if (distance(a, w.capsule[i]) < fine && distance(b, w.capsule[i]) < fine) return;

  Capsule next{{a.x(), a.y()}, {b.x(), b.y()}};
  Capsule* last = n > 0 ? &w.capsule[n - 1] : nullptr;
  bool longer = false;
  if (goes_on && last != nullptr && (vec2(last->b) - a).norm() < fine) {
    Capsule whole = *last;
    whole.b[0] = b.x(), whole.b[1] = b.y();
    const double corner = w.bend + distance(vec2(last->b), whole);
    longer = corner < kCorner * w.radius || n == Wound::kCapsules;
    if (longer) *last = whole, w.bend = corner;
  }
  if (!longer && n == Wound::kCapsules) {  // no room: the last one reaches there
    last->b[0] = b.x(), last->b[1] = b.y();
    longer = true;
  }
  if (!longer) {
    w.settled = w.area;
    w.capsule[n] = next;
    w.count = ++n;
    w.bend = 0;
  }
  settled.follow(w.capsule, n - 1, w.radius);
  w.area = std::max(w.area, w.settled + settled.added(w.capsule[n - 1], w.radius));
  w.reach = std::max({w.reach, a.norm() + w.radius, b.norm() + w.radius});
}

/// The way into the tissue: along the needle, whichever of its ends is inside.
void lean_on(Wound& w, const Vec3& along_O) {
  const double side = axis(w, 0).dot(along_O) > 0 ? -1 : 1;
  for (int i = 0; i < 3; ++i) w.inward[i] = side * along_O[i];
}

}  // namespace

void open_wound(Wound& w, Outline& settled, const Vec3& p_O, const Vec3& normal_O, const Vec3& along_O,
                double radius) noexcept {
  w = {};
  w.open = 1;
  w.radius = radius;
  const Vec3 flat = along_O - normal_O.dot(along_O) * normal_O;
  const Vec3 first = flat.norm() > 1e-9 ? Vec3(flat.normalized()) : Vec3(normal_O.unitOrthogonal());
  for (int i = 0; i < 3; ++i) w.origin[i] = p_O[i], w.normal[i] = normal_O[i], w.first[i] = first[i];
  lean_on(w, along_O);
  cover(w, settled, Vec2::Zero(), Vec2::Zero(), false);
}

void sweep(Wound& w, Outline& settled, const Vec3& p_O, double cosine, const Vec3& along_O) noexcept {
  const Vec3 r = p_O - origin(w);
  const Vec2 centre(axis(w, 1).dot(r), axis(w, 2).dot(r)), before = vec2(w.centre);
  const double fine = kFine * w.radius;
  if ((centre - before).norm() > fine) {
    cover(w, settled, before, centre, true);
    w.centre[0] = centre.x(), w.centre[1] = centre.y();
  }
  lean_on(w, along_O);
  // the section of a leaning wire is longer by 1/cosine; a needle that lies flat is no section any more
  const Vec2 lean(axis(w, 1).dot(along_O), axis(w, 2).dot(along_O));
  const double length = lean.norm(), longer = w.radius * (1 / std::max(cosine, 0.2) - 1);
  if (length > 1e-9 && longer > 2 * fine) {
    const Vec2 d = longer / length * lean;
    cover(w, settled, centre - d, centre + d, false);
  }
}

}  // namespace swage::coupling_pierce
