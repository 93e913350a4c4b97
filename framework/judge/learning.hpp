// SPDX-License-Identifier: Apache-2.0
//
// Learning curves and bands of experts. Pure functions of what is given. [any]
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace swage::judge {

/// Attempts below which no curve is fitted: three parameters and a spread need more than a handful.
inline constexpr std::size_t kFewestForCurve = 8;

enum class Law : uint8_t {
  kExponential,  // y = a + b exp(-(n - 1) / c), n = 1, 2, ...
  kPower         // y = a + b n^-c
};

/// A fit by least squares; of the two laws the one with the lower corrected Akaike criterion.
struct Curve {
  bool fitted = false;
  std::string why_not;  // a sentence when it is not
  Law law = Law::kExponential;
  double a = 0, b = 0, c = 0;
  double low = 0, high = 0;  // 95 % interval of the level a that is being reached; infinite where the data do not bound it
  double spread = 0;         // standard deviation of an attempt about the curve
  double half_way = 0;       // attempts after which half of b is gone
  double aicc = 0;
  double at(double n) const;  // n = 1: the first attempt
};
/// `numbers`: 1, 2, ... of each value, for attempts that are left out; empty: values follow each other.
Curve fit_curve(std::span<const double> values, std::span<const double> numbers = {});
Curve fit_curve(Law law, std::span<const double> values, std::span<const double> numbers = {});

/// The median of the last five with its interval (order statistics, 94 %), for less than eight attempts or a poor fit.
struct Recent {
  std::size_t n = 0;
  double median = 0, low = 0, high = 0;
};
Recent recent(std::span<const double> values);

/// The band of experts: median and the values below which 10 and 90 % lie (linear between order statistics, "type 7").
struct Band {
  std::size_t people = 0, attempts = 0;
  double p10 = 0, median = 0, p90 = 0;
  std::vector<std::size_t> left_out;  // indices of people whose mean lies beyond 1.96 standard deviations: a suggestion
};
/// One list per expert. People and attempts without a value are not counted; empty lists give a band of NaN.
Band expert_band(std::span<const std::vector<double>> experts);

/// The value below which a share of the values lies; NaN for none.
double quantile(std::vector<double> values, double share);

}  // namespace swage::judge
