// SPDX-License-Identifier: Apache-2.0
//
// Learning curves and bands of experts. Pure functions. [any]
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace swage::judge {

/// Least number of attempts for a curve: three parameters and a spread need more than a handful.
inline constexpr std::size_t kFewestForCurve = 8;

enum class Law : uint8_t {
  kExponential,  // y = a + b exp(-(n - 1) / c), n = 1, 2, ...
  kPower         // y = a + b n^-c
};

/// A fit by least squares; of the two laws the one with the lower corrected Akaike criterion is chosen.
struct Curve {
  bool fitted = false;
  std::string why_not;  // a sentence where it is not fitted
  Law law = Law::kExponential;
  double a = 0, b = 0, c = 0;
  double low = 0, high = 0;  // 95 % interval of the asymptotic level a; infinite where the data do not bound it
  double spread = 0;         // standard deviation of the attempts about the curve
  double half_way = 0;       // number of attempts after which half of b is gone
  double aicc = 0;
  double at(double n) const;  // n = 1: the first attempt
};
/// `numbers`: attempt number 1, 2, ... of each value, where attempts are left out; empty: values are consecutive.
Curve fit_curve(std::span<const double> values, std::span<const double> numbers = {});
Curve fit_curve(Law law, std::span<const double> values, std::span<const double> numbers = {});

/// The median of the last five values with its interval (order statistics, 94 %), for fewer than eight attempts or a poor fit.
struct Recent {
  std::size_t n = 0;
  double median = 0, low = 0, high = 0;
};
Recent recent(std::span<const double> values);

/// The band of experts: median, and the 10 and 90 % quantiles (linear between order statistics, "type 7").
struct Band {
  std::size_t people = 0, attempts = 0;
  double p10 = 0, median = 0, p90 = 0;
  std::vector<std::size_t> left_out;  // suggested outliers: indices of people whose mean is beyond 1.96 standard deviations
};
/// One list per expert. People and attempts without a value are not counted; empty lists give a band of NaN.
Band expert_band(std::span<const std::vector<double>> experts);

/// The quantile of a share of the values; NaN for no values.
double quantile(std::vector<double> values, double share);

}  // namespace swage::judge
