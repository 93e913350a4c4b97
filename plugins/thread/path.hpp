// SPDX-License-Identifier: Apache-2.0
//
// Start shapes that are written down: nodes along straight pieces between points, or each node. Header-only. Threads: [main].
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "toolkit/math.hpp"

namespace swage::thread {

using toolkit::Vec3;

/// Reads points and their unit, "0 0 0, 1 0 2.5 mm". Returns what is wrong, or "".
inline std::string read_points(std::string_view text, std::vector<Vec3>& points) {
  constexpr double kMm = 1e-3, kMost = 1;  // m
  const auto skip = [&] {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  };
  points.clear();
  for (skip(); !text.empty() && text != "mm"; skip()) {
    if (!points.empty()) {
      if (text.front() != ',') return "points have commas between them, numbers have spaces: \"0 0 0, 1 0 2.5 mm\"";
      text.remove_prefix(1);
    }
    Vec3 p;
    for (int i = 0; i < 3; ++i) {
      skip();
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), p[i]);
      if (error != std::errc()) return "a point is three numbers: \"0 0 0, 1 0 2.5 mm\"";
      p[i] *= kMm;
      if (!(std::abs(p[i]) <= kMost)) return "a point lies within 1000 mm";
      text.remove_prefix(static_cast<size_t>(end - text.data()));
    }
    points.push_back(p);
  }
  if (points.size() < 2) return "a path has at least two points: \"0 0 0, 1 0 2.5 mm\"";
  return text == "mm" ? "" : "a path ends with its unit: \"0 0 0, 1 0 2.5 mm\"";
}

/// The lines of a file of paths but those that are empty or begin with #.
inline std::vector<std::string> path_lines(std::string_view text) {
  std::vector<std::string> out;
  while (!text.empty()) {
    const size_t end = std::min(text.find('\n'), text.size());
    if (end > 0 && text.front() != '#') out.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

/// n nodes as `text` says them, one point for each of `given`; more of them on the straight pieces between. Returns what is wrong, or "".
inline std::string nodes_at(std::string_view text, int given, int n, std::vector<Vec3>& nodes) {
  std::vector<Vec3> points;
  if (const std::string wrong = read_points(text, points); !wrong.empty()) return wrong;
  if (static_cast<int>(points.size()) != given)
    return "a thread of " + std::to_string(given - 1) + " segments has " + std::to_string(given) + " nodes, not " + std::to_string(points.size());
  for (size_t i = 1; i < points.size(); ++i)
    if (!((points[i] - points[i - 1]).norm() > 0)) return "two nodes one after the other differ";
  for (int i = 0; i < n; ++i) {
    const double at = static_cast<double>(i) * (given - 1) / (n - 1);
    const auto k = std::min(static_cast<size_t>(at), points.size() - 2);
    nodes.push_back(points[k] + (at - static_cast<double>(k)) * (points[k + 1] - points[k]));
  }
  return "";
}

/// Nodes along the points that `text` says, each exactly the length [m] of a segment from the one before, so that nothing is stretched;
/// beyond the last point straight on. Returns what is wrong, or "".
inline std::string nodes_along(std::string_view text, const std::vector<double>& lengths, std::vector<Vec3>& nodes) {
  std::vector<Vec3> points;
  if (const std::string wrong = read_points(text, points); !wrong.empty()) return wrong;
  const Vec3 last = points.back() - points[points.size() - 2];
  if (!(last.norm() > 0)) return "the last two points of a path differ";
  const size_t n = lengths.size() + 1;
  points.push_back(points.back() + static_cast<double>(n) * *std::max_element(lengths.begin(), lengths.end()) * last.normalized());
  nodes.assign(1, points.front());
  for (size_t k = 0; nodes.size() < n;) {
    if (k + 1 == points.size()) return "its path leads back on itself: take shorter segments or a wider path";
    const double l = lengths[nodes.size() - 1];
    // the farther of the two places of the line at the distance l from the node
    const Vec3 a = points[k] - nodes.back(), d = points[k + 1] - points[k];
    const double A = d.squaredNorm(), B = a.dot(d), C = a.squaredNorm() - l * l, D = B * B - A * C;
    const double share = A > 0 && D >= 0 ? (-B + std::sqrt(D)) / A : 2;
    if (share > 1 || share < 0)
      ++k;
    else
      nodes.push_back(points[k] + share * d);
  }
  return "";
}

}  // namespace swage::thread
