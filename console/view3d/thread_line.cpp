// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/thread_line.hpp"

#include <algorithm>
#include <cmath>

#include "console/view3d/wire_chain.hpp"

namespace swage::console {
namespace {

// greatest stretch of a piece before it counts as broken: nylon breaks at about 1.2
constexpr double kMostStretch = 1.5;
// angle between neighbouring segments [rad], 4 degrees; a larger one shows as corners under the microscope
constexpr double kTurn_rad = 0.07;
constexpr double kUponItself = 5;  // segments along the thread between two places that touch; a bend is not a crossing
constexpr int kMostPoints = 12;  // in a piece

Vec at(std::span<const double> line, size_t i) { return {line[3 * i], line[3 * i + 1], line[3 * i + 2]}; }

void put(const Vec& p, std::vector<double>& line) { line.insert(line.end(), {p.x, p.y, p.z}); }

double distance(const Vec& a, const Vec& b) { return norm(a - b); }

double angle(const Vec& a, const Vec& b) { return std::atan2(norm(cross(a, b)), dot(a, b)); }

}  // namespace

std::vector<double> smooth_line(std::span<const double> line) {
  const size_t n = line.size() / 3;
  std::vector<double> out;
  if (n < 3) return {line.begin(), line.end()};
  // linear extrapolation beyond an end
  const auto p = [&](size_t i, int by) {
    if (by < 0 && i == 0) return at(line, 0) * 2 - at(line, 1);
    if (by > 0 && i + 1 == n) return at(line, n - 1) * 2 - at(line, n - 2);
    return at(line, by < 0 ? i - 1 : i + static_cast<size_t>(by));
  };
  for (size_t i = 0; i + 1 < n; ++i) {
    const Vec a = p(i, -1), b = at(line, i), c = at(line, i + 1), d = p(i + 1, 1);
    const double turns = angle(b - a, c - b) + angle(c - b, d - c);
    const int points = std::clamp(static_cast<int>(std::ceil(0.5 * turns / kTurn_rad)), 1, kMostPoints);
    for (int k = 0; k < points; ++k) {
      const double t = static_cast<double>(k) / points, tt = t * t, ttt = tt * t;
      put(a * (0.5 * (2 * tt - t - ttt)) + b * (0.5 * (3 * ttt - 5 * tt + 2)) + c * (0.5 * (4 * tt + t - 3 * ttt)) +
              d * (0.5 * (ttt - tt)),
          out);
    }
  }
  put(at(line, n - 1), out);
  return out;
}

Vec nearest_on(std::span<const double> line, const Vec& p) {
  Vec best = p;
  double least = HUGE_VAL;
  for (size_t i = 0; i + 1 < line.size() / 3; ++i) {
    const Vec a = at(line, i), way = at(line, i + 1) - a;
    const double t = std::clamp(dot(p - a, way) / std::max(dot(way, way), 1e-30), 0.0, 1.0);
    const Vec here = a + way * t;
    if (distance(here, p) >= least) continue;
    least = distance(here, p);
    best = here;
  }
  return best;
}

double ThreadLine::length() const {
  double sum = 0;
  for (size_t i = 1; i < vertices(); ++i) sum += distance(at(start, i), at(start, i - 1));
  return sum;
}

std::optional<QVector3D> ThreadLine::crossing() const {
  const size_t n = vertices();
  if (n < 3) return {};
  const double near = length() / static_cast<double>(n - 1);  // vertices of strands that touch are no further apart than those of one strand
  std::vector<double> s(n);                                   // m, along the thread
  for (size_t i = 1; i < n; ++i) s[i] = s[i - 1] + distance(at(start, i), at(start, i - 1));
  Vec sum{0, 0, 0};
  int found = 0;
  for (size_t i = 0; i < n; ++i)
    for (size_t j = i + 1; j < n; ++j)
      if (s[j] - s[i] > kUponItself * near && distance(at(start, i), at(start, j)) < near) sum = sum + at(start, i) + at(start, j), found += 2;
  if (found == 0) return {};
  const double to_mm = 1e3 / found;
  return QVector3D(static_cast<float>(to_mm * sum.x), static_cast<float>(to_mm * sum.y), static_cast<float>(to_mm * sum.z));
}

Mesh ThreadLine::mesh(std::span<const double> p_W, double least) const {
  Mesh out;
  const size_t n = p_W.size() / 3;
  for (size_t begin = 0, i = 1; i <= n; ++i) {
    if (i < n && distance(at(p_W, i), at(p_W, i - 1)) <= longest) continue;
    const std::vector<double> line = smooth_line(p_W.subspan(3 * begin, 3 * (i - begin)));
    append_thread(line.data(), static_cast<uint32_t>(line.size() / 3), std::max(radius, least), out);
    begin = i;
  }
  return out;
}

Mesh ThreadLine::part(std::span<const double> p_W, double least, double from, double to, double grow) const {
  Mesh out;
  const std::vector<double> line = part_of_line(smooth_line(p_W), from, to);
  append_thread(line.data(), static_cast<uint32_t>(line.size() / 3), grow * std::max(radius, least), out);
  return out;
}

std::vector<ThreadLine> find_threads(const snapshot::SceneCard& card) {
  std::vector<ThreadLine> out;
  uint32_t next = 0;
  for (const snapshot::CardObject& object : card.objects) next += object.n_particle;
  for (const snapshot::CardShape& s : card.shapes) {
    if (s.kind != SWAGE_SHAPE_CHAIN) continue;
    ThreadLine thread;
    thread.object = s.object, thread.body = s.body, thread.radius = s.radius, thread.first = next;
    next += static_cast<uint32_t>(s.vertex.size());
    if (!(s.flags & SWAGE_SHAPE_DRAWN) || s.body >= card.start.size()) continue;
    for (const swage_vec3& p_B : s.vertex) put(transform(card.start[s.body], transform(s.X_BS, p_B)), thread.start);
    for (size_t i = 1; i < s.vertex.size(); ++i)
      thread.longest = std::max(thread.longest, kMostStretch * distance(at(thread.start, i), at(thread.start, i - 1)));
    out.push_back(std::move(thread));
  }
  return out;
}

}  // namespace swage::console
