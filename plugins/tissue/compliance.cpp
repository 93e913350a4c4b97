// SPDX-License-Identifier: Apache-2.0
#include "compliance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace swage::tissue {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr uint32_t kNodes = 128;       // of the table over the distance
constexpr uint32_t kIntervals = 4096;  // of the integral over wave numbers, Simpson
constexpr double kFarthest =
    30;  // end of the table, in its scale; beyond it the skin has no effect (below 1e-4)
constexpr double kShortest = 60;  // shortest waves of the integral: wave numbers up to this over the scale

}  // namespace

Compliance::Compliance(const Layers& layers)
    : shear_(layers.shear), e_(2 * layers.spread / kPi), point_(1 / (4 * kPi * layers.shear)) {
  if (!(layers.skin > 0)) return;
  // plate of nu = 1/2 on a half space whose stiffness per area is 2 G k at the wave number k
  const double D = layers.skin_young * layers.skin * layers.skin * layers.skin / 9;
  const double skin = std::cbrt(D / (2 * shear_));
  scale_ = std::max(skin, e_);
  reach_ = kFarthest * scale_;
  table_.resize(kNodes);
  for (uint32_t i = 0; i < kNodes; ++i) {
    const double u = static_cast<double>(i) / (kNodes - 1) * reach_ / (reach_ + scale_),
                 r = scale_ * u / (1 - u);
    const double dk = kShortest / scale_ / kIntervals;
    double sum = 0;
    for (uint32_t j = 0; j <= kIntervals; ++j) {
      const double k = dk * j, weight = j == 0 || j == kIntervals ? 1 : j % 2 == 1 ? 4 : 2;
      sum += weight * ::j0(k * r) * std::exp(-k * e_) / (2 * shear_ + D * k * k * k);
    }
    table_[i] = sum * dk / 3 / (2 * kPi);
  }
}

double Compliance::normal(double r) const noexcept {
  if (table_.empty() || r >= reach_) return point_ / std::sqrt(r * r + e_ * e_);
  const double u = r / (r + scale_) / (reach_ / (reach_ + scale_)) * (kNodes - 1);
  const auto i = std::min(static_cast<uint32_t>(u), kNodes - 2);
  return table_[i] + (u - i) * (table_[i + 1] - table_[i]);
}

Mat3 Compliance::between(double x, double y) const noexcept {
  const Give g = give(x, y);
  Mat3 C = Mat3::Zero();
  C(0, 0) = g.n;
  C(1, 1) = g.t + g.c * x * x;
  C(2, 2) = g.t + g.c * y * y;
  C(1, 2) = C(2, 1) = g.c * x * y;
  return C;
}

Creep::Creep(double relaxed, double relaxation_time, double dt) {
  const double tau = relaxation_time / relaxed;
  keep = std::exp(-dt / tau);
  gain = (1 / relaxed - 1) * -std::expm1(-dt / tau);
}

}  // namespace swage::tissue
