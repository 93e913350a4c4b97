// SPDX-License-Identifier: Apache-2.0
#include "wound.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "circle.hpp"

namespace swage::coupling_pierce {
namespace {

constexpr double kFine = 0.02;    // of the radius: smaller motions are ignored
constexpr double kCorner = 0.05;  // of the radius: largest deviation of one capsule from the path that it represents

Vec2 vec2(const double* a) { return {a[0], a[1]}; }

double distance(const Vec2& p, const Capsule& c) { return std::sqrt(Line(c).distance2(p)); }

/// Number of points on a circle of radius 1.
constexpr int kAround = 24;
const std::array<Vec2, kAround> kCircle = [] {
  std::array<Vec2, kAround> place;
  for (size_t i = 0; i < place.size(); ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / kAround;
    place[i] = {std::cos(angle), std::sin(angle)};
  }
  return place;
}();

/// How far a capsule extends beyond all others but `own` [m], 0 when covered: maximum over points on its border, a quarter of the radius
/// apart round its ends, half a radius along its sides (at most kAlong of them, then wider apart). Returns early with a value
/// above `enough`.
double sticks_out(const Wound& w, const Capsule& capsule, uint32_t own, double enough) {
  constexpr int kAlong = 24;
  const Line line(capsule);
  Line other[Wound::kCapsules];
  uint32_t m = 0;
  for (uint32_t i = 0; i < static_cast<uint32_t>(w.count); ++i)
    if (i != own) other[m++] = Line(w.capsule[i]);
  double far2 = w.radius * w.radius;
  const double enough2 = (w.radius + enough) * (w.radius + enough);
  const auto look = [&](const Vec2& p) {
    double near2 = HUGE_VAL;
    for (uint32_t i = 0; i < m && near2 > far2; ++i) near2 = std::min(near2, other[i].distance2(p));
    far2 = std::max(far2, near2);
    return far2 > enough2;
  };
  const auto out = [&] { return std::sqrt(far2) - w.radius; };
  for (const Vec2& at : kCircle)
    if (look(line.from + w.radius * at) || look(line.from + line.along + w.radius * at)) return out();
  const double length = line.along.norm();
  const Vec2 side = length > 0 ? Vec2(w.radius / length * Vec2(-line.along.y(), line.along.x())) : Vec2(0, 0);
  const int steps = std::min(kAlong, static_cast<int>(2 * length / w.radius));
  for (int k = 1; k < steps; ++k) {
    const Vec2 at = line.from + line.along * (static_cast<double>(k) / steps);
    if (look(at + side) || look(at - side)) return out();
  }
  return out();
}

void forget(Wound& w, uint32_t i) {
  std::copy(w.capsule + i + 1, w.capsule + static_cast<uint32_t>(w.count), w.capsule + i);
  w.count -= 1;
}

/// Drops capsules that the others cover, else the one that extends beyond them least; the first, of the puncture, is kept.
void make_room(Wound& w) {
  const double fine = kFine * w.radius;
  for (auto i = static_cast<uint32_t>(w.count); i-- > 1;)
    if (sticks_out(w, w.capsule[i], i, fine) < fine) forget(w, i);
  if (w.count < Wound::kCapsules) return;
  double least = HUGE_VAL;
  uint32_t least_at = 1;
  for (uint32_t i = 1; i < Wound::kCapsules; ++i) {
    const double out = sticks_out(w, w.capsule[i], i, least);
    if (out < least) least = out, least_at = i;
  }
  forget(w, least_at);
}

/// Tries to lengthen the last capsule by the path from a to b, which starts where it ends; true if done.
bool lengthen(Wound& w, const Vec2& a, const Vec2& b) {
  Capsule& last = w.capsule[static_cast<uint32_t>(w.count) - 1];
  if ((vec2(last.b) - a).norm() >= kFine * w.radius) return false;
  Capsule whole = last;
  whole.b[0] = b.x(), whole.b[1] = b.y();
  const double corner = w.bend + distance(vec2(last.b), whole);
  if (corner >= kCorner * w.radius) return false;
  last = whole, w.bend = corner;
  return true;
}

/// Radius of the smallest circle around the wound.
double half_width(const Wound& w) {
  Vec2 end[2 * Wound::kCapsules];
  uint32_t n = 0;
  for (uint32_t i = 0; i < static_cast<uint32_t>(w.count); ++i)
    end[n++] = vec2(w.capsule[i].a), end[n++] = vec2(w.capsule[i].b);
  return smallest_circle(end, n).radius + w.radius;
}

/// Adds the capsule from a to b; `goes_on`: a path that may lengthen the last capsule.
void cover(Wound& w, Outline& settled, const Vec2& a, const Vec2& b, bool goes_on) {
  const double fine = kFine * w.radius;
  const auto n = static_cast<uint32_t>(w.count);
  for (uint32_t i = 0; i < n; ++i)
    if (distance(a, w.capsule[i]) < fine && distance(b, w.capsule[i]) < fine) return;
  if (!goes_on || !lengthen(w, a, b)) {
    const Capsule next{{a.x(), a.y()}, {b.x(), b.y()}};
    if (sticks_out(w, next, n, fine) < fine) return;
    if (n == Wound::kCapsules) make_room(w);
    w.capsule[static_cast<uint32_t>(w.count)] = next;
    w.count += 1;
    w.bend = 0;
  }
  const uint32_t before = static_cast<uint32_t>(w.count) - 1;
  settled.follow(w.capsule, before, w.radius);
  w.area = std::max(w.area, settled.area() + settled.added(w.capsule[before], w.radius));
  w.reach = std::max({w.reach, a.norm() + w.radius, b.norm() + w.radius});
  w.wide = std::max(w.wide, half_width(w));
}

/// Sets the direction into the tissue: along the needle, whichever of its ends is inside.
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
  // the section of an inclined wire is longer by 1/cosine; at most five times, as a needle that lies flat has no section
  const Vec2 lean(axis(w, 1).dot(along_O), axis(w, 2).dot(along_O));
  const double length = lean.norm(), longer = w.radius * (1 / std::max(cosine, 0.2) - 1);
  if (length > 1e-9 && longer > 2 * fine) {
    const Vec2 d = longer / length * lean;
    cover(w, settled, centre - d, centre + d, false);
  }
}

}  // namespace swage::coupling_pierce
