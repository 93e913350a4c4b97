// SPDX-License-Identifier: Apache-2.0
//
// Displacement of the surface of an incompressible elastic half space, under a thin stiffer skin, at one place due to a force
// at another; and its creep as a standard linear solid. Derivations: tissue.md.
//
// Units: m, N. Frame: n along the surface's normal, then two axes along the surface. [rt] unless said otherwise.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "toolkit/math.hpp"

namespace swage::tissue {

using toolkit::Mat3;
using toolkit::Vec3;

struct Layers {
  double shear = 3.3e5;   // Pa, of the half space, instantaneous
  double spread = 50e-6;  // m, radius over which the force of a touch is distributed
  double skin = 0;        // m, thickness; 0: no skin
  double skin_young = 0;  // Pa
};

class Compliance {
 public:
  Compliance() = default;
  /// Tabulates the normal response when there is a skin. [main]
  explicit Compliance(const Layers& layers);

  /// Displacement per force [m/N] along the normal at a distance r.
  double normal(double r) const noexcept;
  /// Displacement per force between places that are (x, y) apart along the surface: rows and columns n, 1, 2.
  Mat3 between(double x, double y) const noexcept;
  /// The same by its parts: a force f displaces by (n f_n, t f_1 + c x (x f_1 + y f_2), t f_2 + c y (x f_1 + y f_2)).
  struct Give {
    double n, t, c;  // m/N, m/N, 1/(N m)
    Vec3 of(double x, double y, const Vec3& f) const {
      const double along = c * (x * f[1] + y * f[2]);
      return {n * f[0], t * f[1] + along * x, t * f[2] + along * y};
    }
  };
  Give give(double x, double y) const noexcept {
    const double rr = x * x + y * y, r_e = std::sqrt(rr + e_ * e_), sum = r_e + e_;
    const double both = point_ / (r_e * sum);  // shared factor: a single division
    return {table_.empty() ? both * sum : normal(std::sqrt(rr)), both * (2 * sum - r_e),
            both * both * r_e / point_};
  }
  double spread() const noexcept { return e_; }  // m, e of the kernel: dents of this radius have its shape

 private:
  double shear_ = 1, e_ = 1, point_ = 1;  // Pa; m; m2/N, 1/(4 pi G)
  double reach_ = 0, scale_ = 0;          // m, of the table
  std::vector<double> table_;             // entries equally spaced in r / (r + scale)
};

/// Creep of a standard linear solid whose force is constant within a step: displacement = C (f + v), exact for any dt.
///   G(t) / G(0) = relaxed + (1 - relaxed) exp(-t/relaxation_time)
struct Creep {
  double keep = 1;  // factor of v per step: exp(-dt/tau), tau = relaxation_time / relaxed
  double gain = 0;  // v gains gain * f in a step
  Creep() = default;
  Creep(double relaxed, double relaxation_time, double dt);
  double at_once() const {
    return 1 + gain;
  }  // displacement over C f at the end of the step in which f is applied
};

}  // namespace swage::tissue
