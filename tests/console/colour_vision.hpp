// SPDX-License-Identifier: Apache-2.0
//
// Difference of two colours: CIEDE2000, also as seen with a full colour-vision deficiency.
#pragma once

#include <QColor>
#include <array>
#include <cmath>
#include <numbers>

namespace swage::test {

struct Lab {
  double L, a, b;
};

enum class Vision { kUsual, kRedBlind, kGreenBlind, kBlueBlind };

inline double to_linear(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }

/// Machado, Oliveira, Fernandes: A physiologically-based model for simulation of color vision deficiency, 2009,
/// severity 1.0, on linear sRGB.
inline std::array<double, 3> seen(const QColor& colour, Vision vision) {
  static constexpr double kMatrix[4][9] = {
      {1, 0, 0, 0, 1, 0, 0, 0, 1},
      {0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998},
      {0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881},
      {1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900}};
  const double* m = kMatrix[static_cast<int>(vision)];
  const double in[3] = {to_linear(colour.redF()), to_linear(colour.greenF()), to_linear(colour.blueF())};
  std::array<double, 3> out{};
  for (size_t i = 0; i < 3; ++i) {
    for (size_t k = 0; k < 3; ++k) out[i] += m[3 * i + k] * in[k];
    out[i] = std::clamp(out[i], 0.0, 1.0);
  }
  return out;
}

/// Linear sRGB to CIELAB, white D65.
inline Lab to_lab(const std::array<double, 3>& c) {
  const double x = (0.4124564 * c[0] + 0.3575761 * c[1] + 0.1804375 * c[2]) / 0.95047;
  const double y = 0.2126729 * c[0] + 0.7151522 * c[1] + 0.0721750 * c[2];
  const double z = (0.0193339 * c[0] + 0.1191920 * c[1] + 0.9503041 * c[2]) / 1.08883;
  const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; };
  return {116 * f(y) - 16, 500 * (f(x) - f(y)), 200 * (f(y) - f(z))};
}

/// Sharma, Wu, Dalal: The CIEDE2000 color-difference formula, 2005.
inline double delta_e2000(const Lab& p, const Lab& q) {
  constexpr double kPi = std::numbers::pi, k25to7 = 6103515625.0;
  const double mean_c = 0.5 * (std::hypot(p.a, p.b) + std::hypot(q.a, q.b)), c7 = std::pow(mean_c, 7);
  const double g = 0.5 * (1 - std::sqrt(c7 / (c7 + k25to7)));
  const double a1 = (1 + g) * p.a, a2 = (1 + g) * q.a;
  const double c1 = std::hypot(a1, p.b), c2 = std::hypot(a2, q.b);
  const auto hue = [](double b, double a) {
    const double h = a == 0 && b == 0 ? 0 : std::atan2(b, a);
    return h < 0 ? h + 2 * kPi : h;
  };
  const double h1 = hue(p.b, a1), h2 = hue(q.b, a2);
  const bool grey = c1 * c2 == 0;
  double dh = grey ? 0 : h2 - h1;
  if (dh > kPi) dh -= 2 * kPi;
  if (dh < -kPi) dh += 2 * kPi;
  const double dL = q.L - p.L, dC = c2 - c1, dH = 2 * std::sqrt(c1 * c2) * std::sin(0.5 * dh);
  const double L = 0.5 * (p.L + q.L), C = 0.5 * (c1 + c2);
  double h = h1 + h2;
  if (!grey) h = std::abs(h1 - h2) <= kPi ? 0.5 * h : h < 2 * kPi ? 0.5 * h + kPi : 0.5 * h - kPi;
  const double deg = kPi / 180;
  const double t = 1 - 0.17 * std::cos(h - 30 * deg) + 0.24 * std::cos(2 * h) +
                   0.32 * std::cos(3 * h + 6 * deg) - 0.20 * std::cos(4 * h - 63 * deg);
  const double c7m = std::pow(C, 7), rc = 2 * std::sqrt(c7m / (c7m + k25to7));
  const double turn = 30 * deg * std::exp(-std::pow((h / deg - 275) / 25, 2));
  const double l50 = (L - 50) * (L - 50);
  const double sL = 1 + 0.015 * l50 / std::sqrt(20 + l50), sC = 1 + 0.045 * C, sH = 1 + 0.015 * C * t;
  const double rT = -std::sin(2 * turn) * rc;
  return std::sqrt(std::pow(dL / sL, 2) + std::pow(dC / sC, 2) + std::pow(dH / sH, 2) +
                   rT * (dC / sC) * (dH / sH));
}

inline double difference(const QColor& p, const QColor& q, Vision vision) {
  return delta_e2000(to_lab(seen(p, vision)), to_lab(seen(q, vision)));
}

}  // namespace swage::test
