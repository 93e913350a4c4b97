// SPDX-License-Identifier: Apache-2.0
//
// The thread as the thesis has its suture: point masses with springs between neighbours (the particles of 4.1.6), moved explicitly as
// in 4.1, force by force. It stretches, and does not bend or twist.
//
// Speeds are changed before places (symplectic Euler): the order of the thesis, places first, gains energy at every step. Even so a
// step is stable only below 2 / w, w = 2 sqrt(k/m) the highest frequency of the chain, in which neighbours swing against each other:
// dt < sqrt(m/k) = l sqrt(line mass / EA), 0.42 us for 0.6 mm pieces of 10-0. A step of 1 ms is therefore divided.
// Units SI, frame W. Header-only, [rt]: nothing allocates.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "toolkit/rod.hpp"

namespace swage::thread {

/// m, spring constant of a piece and mass of a node between two pieces.
struct Springs {
  double rest = 0;       // m
  double stiffness = 0;  // N/m
  double mass = 0;       // kg; the ends have half of it
  double diameter = 0;   // m

  Springs() = default;
  Springs(const toolkit::RodSection& section, double length)
      : rest(length), stiffness(section.stretching / length), mass(section.mass * length), diameter(2 * section.radius) {}

  /// s, above which an explicit step is unstable.
  double limit() const { return std::sqrt(mass / stiffness); }
  /// Equal parts of a step of h [s], each below the limit by a tenth.
  int parts(double h) const {
    constexpr double kMargin = 0.9;
    return std::max(1, static_cast<int>(std::ceil(h / (kMargin * limit()))));
  }
};

/// Moves n nodes (x, v: 3 n) by one explicit step of dt [s]. `held(i)`: node i stays; `there(j)`: piece j has not parted. `force`: 3 n N, or
/// empty. Drag is taken at the end of the step, which keeps it stable.
template <class Held, class There>
void explicit_step(const Springs& s, int n, double* x, double* v, double dt, const toolkit::Vec3& gravity, double borne, std::span<const double> drag,
                   std::span<const double> force, double* room, const Held& held, const There& there) {
  using toolkit::Vec3;
  std::fill_n(room, 3 * n, 0.0);
  for (int j = 0; j + 1 < n; ++j) {
    if (!there(j)) continue;
    const Vec3 e = Eigen::Map<const Vec3>(x + 3 * j + 3) - Eigen::Map<const Vec3>(x + 3 * j);
    const double length = e.norm();
    const Vec3 f = s.stiffness * (length - s.rest) / length * e;
    Eigen::Map<Vec3>(room + 3 * j) += f, Eigen::Map<Vec3>(room + 3 * j + 3) -= f;
  }
  for (int i = 0; i < n; ++i) {
    const double m = i == 0 || i == n - 1 ? 0.5 * s.mass : s.mass;
    Eigen::Map<Vec3> speed(v + 3 * i);
    Vec3 a = borne * gravity + Eigen::Map<const Vec3>(room + 3 * i) / m;
    if (!force.empty()) a += Eigen::Map<const Vec3>(force.data() + 3 * i) / m;
    const double c = drag.empty() ? 0.0 : drag[static_cast<size_t>(i)];
    speed = held(i) ? Vec3(Vec3::Zero()) : Vec3((speed + dt * a) / (1 + dt * c / m));
    Eigen::Map<Vec3>(x + 3 * i) += dt * speed;
  }
}

}  // namespace swage::thread
