// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/wire_chain.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "console/view3d/vec.hpp"

namespace swage::console {
namespace {

constexpr double kStation_rad = 0.05;  // arc angle between two points of the line: 3 degrees
constexpr int kLeastStations = 3;      // per piece

Vec on_arc(const snapshot::CardShape& arc, const swage_pose& X_WB, double share) {
  const double a = share * arc.sweep;
  return transform(X_WB,
                   transform(arc.X_BS, {arc.arc_radius * std::cos(a), arc.arc_radius * std::sin(a), 0}));
}

double apart(const Vec& a, const Vec& b) {
  const Vec d = a - b;
  return std::sqrt(dot(d, d));
}

// each piece begins at the end of the one before; the first is the one that begins at no other's end
void put_in_order(std::vector<snapshot::CardShape>& pieces, const std::vector<swage_pose>& X_WB) {
  std::vector<snapshot::CardShape> rest = std::move(pieces);
  pieces.clear();
  const auto begin = [&](const snapshot::CardShape& s) { return on_arc(s, X_WB[s.body], 0); };
  const auto end = [&](const snapshot::CardShape& s) { return on_arc(s, X_WB[s.body], 1); };
  const auto gap_before = [&](const snapshot::CardShape& s) {
    double least = 1e9;
    for (const snapshot::CardShape& other : rest) {
      if (&other != &s) least = std::min(least, apart(begin(s), end(other)));
    }
    return least;
  };
  auto first = std::max_element(rest.begin(), rest.end(),
                                [&](const auto& a, const auto& b) { return gap_before(a) < gap_before(b); });
  while (first != rest.end()) {
    pieces.push_back(*first);
    rest.erase(first);
    first = std::min_element(rest.begin(), rest.end(), [&](const auto& a, const auto& b) {
      return apart(begin(a), end(pieces.back())) < apart(begin(b), end(pieces.back()));
    });
  }
}

Vec at(const std::vector<double>& line, size_t i) { return {line[3 * i], line[3 * i + 1], line[3 * i + 2]}; }

void append(const Vec& p, std::vector<double>& line) { line.insert(line.end(), {p.x, p.y, p.z}); }

}  // namespace

std::vector<WireChain> find_chains(const snapshot::SceneCard& card) {
  std::vector<WireChain> out;
  for (uint32_t o = 0; o < card.objects.size(); ++o) {
    WireChain chain;
    chain.object = o;
    std::set<uint32_t> bodies;
    for (const snapshot::CardShape& s : card.shapes) {
      if (s.object != o || s.kind != SWAGE_SHAPE_ARC || !(s.flags & SWAGE_SHAPE_DRAWN) ||
          s.body >= card.start.size())
        continue;
      chain.piece.push_back(s);
      chain.radius = std::max(chain.radius, s.radius);
      bodies.insert(s.body);
    }
    if (bodies.size() < 2) continue;
    put_in_order(chain.piece, card.start);
    out.push_back(std::move(chain));
  }
  return out;
}

std::vector<double> WireChain::centre_line(std::span<const swage_pose> X_WB) const {
  std::vector<double> line;
  for (size_t k = 0; k < piece.size(); ++k) {
    const snapshot::CardShape& arc = piece[k];
    if (arc.body >= X_WB.size()) continue;
    const int n = std::max(kLeastStations, static_cast<int>(std::ceil(arc.sweep / kStation_rad)));
    if (k == 0) append(on_arc(arc, X_WB[arc.body], 0), line);
    for (int i = 0; i < n; ++i) append(on_arc(arc, X_WB[arc.body], (i + 0.5) / n), line);
    if (k + 1 == piece.size()) append(on_arc(arc, X_WB[arc.body], 1), line);
  }
  return line;
}

std::vector<double> part_of_line(const std::vector<double>& line, double from, double to) {
  const size_t n = line.size() / 3;
  if (n < 2 || !(to > from)) return {};
  std::vector<double> along(n, 0);
  for (size_t i = 1; i < n; ++i) along[i] = along[i - 1] + apart(at(line, i), at(line, i - 1));
  const double a = std::clamp(from, 0.0, 1.0) * along.back(), b = std::clamp(to, 0.0, 1.0) * along.back();
  const auto place = [&](double s) {
    const auto next = std::clamp<size_t>(
        static_cast<size_t>(std::upper_bound(along.begin(), along.end(), s) - along.begin()), 1, n - 1);
    const double span = along[next] - along[next - 1];
    const double u = span > 0 ? (s - along[next - 1]) / span : 0;
    return at(line, next - 1) + (at(line, next) - at(line, next - 1)) * u;
  };
  std::vector<double> out;
  append(place(a), out);
  for (size_t i = 0; i < n; ++i) {
    if (along[i] > a && along[i] < b) append(at(line, i), out);
  }
  append(place(b), out);
  return out;
}

}  // namespace swage::console
