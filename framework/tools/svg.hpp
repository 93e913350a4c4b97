// SPDX-License-Identifier: Apache-2.0
//
// Styles and ticks of the figures of this room. [main]
#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

namespace swage::tools::svg {

/// Colour and mark of the i-th series: distinct for colour-blind readers (Okabe and Ito), and by the form of the mark alone.
struct Style {
  const char* colour;
  const char* path;  // SVG path of the mark, centred at 0 0, about 12 wide
};
inline constexpr Style kStyles[] = {{"#0072b2", "M-5 0a5 5 0 1 0 10 0a5 5 0 1 0 -10 0Z"},
                                    {"#d55e00", "M0 -6L6 5L-6 5Z"},
                                    {"#009e73", "M-5 -5H5V5H-5Z"},
                                    {"#cc79a7", "M0 -7L7 0L0 7L-7 0Z"},
                                    {"#555555", "M0 6L6 -5L-6 -5Z"}};
inline const Style& style(std::size_t i) { return kStyles[i % std::size(kStyles)]; }

/// Distance of two ticks: the least of 1, 2, 5 times a power of ten that is not below x.
inline double round_up(double x) {
  const double power = std::pow(10, std::floor(std::log10(std::max(x, 1e-12))));
  for (const double k : {1.0, 2.0, 5.0})
    if (k * power >= x) return k * power;
  return 10 * power;
}

inline std::string escape(const std::string& s) {
  std::string out;
  for (const char c : s)
    out += c == '<' ? "&lt;" : c == '&' ? "&amp;" : c == '>' ? "&gt;" : std::string(1, c);
  return out;
}

}  // namespace swage::tools::svg
