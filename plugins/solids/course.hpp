// SPDX-License-Identifier: Apache-2.0
//
// The centre line of a bent wire: straight pieces and circular bends one after another, each continuing in the final direction of the one
// before it. It starts at the origin along +x, in the plane z = 0; positive bends turn to the left.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "toolkit/math.hpp"

namespace swage::solids {

using toolkit::Vec3;

/// A piece of the centre line.
struct Piece {
  Vec3 start = Vec3::Zero();  // m
  double heading = 0;         // rad from +x, at its start
  double length = 0;          // m
  double bend = 0;            // rad, to the left; 0: straight
  double from = 0;            // m, length of all pieces before it

  double radius() const { return length / std::abs(bend); }
  double side() const { return bend > 0 ? 1 : -1; }
  Vec3 forward(double l) const {
    const double a = heading + bend * l / length;
    return {std::cos(a), std::sin(a), 0};
  }
  Vec3 centre() const { return start + side() * radius() * Vec3(-std::sin(heading), std::cos(heading), 0); }
  Vec3 at(double l) const {
    if (bend == 0) return start + l * forward(0);
    const Vec3 t = forward(l);
    return centre() - side() * radius() * Vec3(-t.y(), t.x(), 0);
  }
  /// Arc length from the start to the place nearest to p, m.
  double nearest(const Vec3& p) const {
    if (bend == 0) return std::clamp((p - start).dot(forward(0)), 0.0, length);
    const Vec3 a = start - centre(), b = p - centre();
    double angle = side() * std::atan2(a.x() * b.y() - a.y() * b.x(), a.x() * b.x() + a.y() * b.y());
    // beyond the middle of the missing part of the circle, the start is nearer than the end
    if (angle < -0.5 * (2 * std::numbers::pi - std::abs(bend))) angle += 2 * std::numbers::pi;
    return std::clamp(angle * radius(), 0.0, length);
  }
};

/// Reads "2 mm, 60 deg at 2 mm, 1.5 mm": a straight of 2 mm, a bend to the left by 60 deg of radius 2 mm, a straight. Returns the fault,
/// or "".
inline std::string read_course(std::string_view text, std::vector<Piece>& pieces) {
  constexpr double kMm = 1e-3, kDeg = std::numbers::pi / 180;
  pieces.clear();
  const std::string hint = R"( it is a list like "2 mm, 60 deg at 2 mm, -60 deg at 2 mm, 2 mm")";
  const auto number = [&text](double& value, std::string_view unit) {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc()) return false;
    std::string_view rest = text.substr(static_cast<size_t>(end - text.data()));
    while (!rest.empty() && rest.front() == ' ') rest.remove_prefix(1);
    if (!rest.starts_with(unit)) return false;
    text = rest.substr(unit.size());
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    return true;
  };
  while (!text.empty()) {
    Piece piece;
    if (!pieces.empty()) {
      const Piece& last = pieces.back();
      piece.start = last.at(last.length);
      piece.heading = last.heading + last.bend;
      piece.from = last.from + last.length;
    }
    double angle = 0, mm = 0;
    if (number(angle, "deg")) {
      if (!text.starts_with("at")) return "a bend needs \"at\" and its radius;" + hint;
      text.remove_prefix(2);
      if (!number(mm, "mm")) return "a bend needs a radius in mm;" + hint;
      piece.bend = angle * kDeg;
      piece.length = std::abs(piece.bend) * mm * kMm;
      if (!(std::abs(angle) >= 1 && std::abs(angle) <= 350)) return "a bend is between 1 and 350 deg;" + hint;
    } else if (number(mm, "mm")) {
      piece.length = mm * kMm;
    } else {
      return "each piece is a length in mm or a bend in deg;" + hint;
    }
    if (!(mm >= 0.01 && mm <= 200)) return "lengths and radii are between 0.01 and 200 mm;" + hint;
    pieces.push_back(piece);
    if (!text.empty() && text.front() != ',') return "pieces have commas between them;" + hint;
    if (!text.empty()) text.remove_prefix(1);
  }
  return pieces.empty() ? "it has no piece;" + hint : "";
}

}  // namespace swage::solids
