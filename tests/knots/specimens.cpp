// SPDX-License-Identifier: Apache-2.0
//
// Specimens of lesson 134: knots that are laid, drawn tight and let go (pull.hpp), then closed to a loop. Prints the start shapes of
// a thread ("nodes"), one a line: square, granny, sliding, loose first throw.
//
// Frame: the middle of the loop in the origin, the knot and its tails towards +y, z to who looks. 8-0 nylon.
#include <cmath>
#include <cstdio>
#include <numbers>
#include <stdexcept>

#include "pull.hpp"

namespace swage::test {
namespace {

constexpr double kDiameter = 45e-6, kSegment = 3 * kDiameter;  // m
constexpr int kSegments = 112;
constexpr double kWide = 3.864 * kDiameter;  // m, radius of throws that are not drawn tight
constexpr double kLeg = 0.8e-3;   // m, of each leg that is kept beyond the knot
constexpr double kNear = 2.5 * kDiameter;  // strands nearer than this are in the knot

PullTest laid(const Word& word) {
  PullTest t;
  t.word = word, t.friction = 0.4, t.load = 0;
  t.diameter = kDiameter, t.segment = kSegment, t.strength = 0.8, t.margin = 10e-6;
  t.oil = 1e5, t.thins = 0.2;
  return t;
}

/// Drawn tight.
PullTest tied(const Word& word) {
  PullTest t = laid(word);
  t.pretension = 90e-3, t.unit = 2.5 * kDiameter, t.shape.spacing = 4.5;
  return t;
}

/// First and last node of one half of the thread that touch other strands.
std::pair<int, int> in_knot(const std::vector<Vec3>& node, int from, int to) {
  int first = to, last = from;
  for (int i = from; i < to; ++i)
    for (int j = 0; j < static_cast<int>(node.size()); ++j)
      if (std::abs(i - j) > 4 && (node[static_cast<size_t>(i)] - node[static_cast<size_t>(j)]).norm() < kNear)
        first = std::min(first, i), last = std::max(last, i);
  return {first, last};
}

/// Nodes between a and b on an arc of `n` chords that bulges to where `down` points.
std::vector<Vec3> bridge(const Vec3& a, const Vec3& b, const Vec3& down, int n, double chord) {
  const Vec3 x = (b - a).normalized(), y = (down - down.dot(x) * x).normalized();
  const double across = (b - a).norm();
  // half the angle of a chord, of a circle on which n of them lead from a to b
  double low = 1e-6, high = std::numbers::pi / n - 1e-9;
  for (int i = 0; i < 60; ++i) {
    const double h = 0.5 * (low + high), R = 0.5 * chord / std::sin(h);
    (2 * R * std::sin(n * h) > across ? low : high) = h;
  }
  const double R = 0.5 * chord / std::sin(low), half = n * low;
  const Vec3 centre = 0.5 * (a + b) - R * std::cos(half) * y;
  std::vector<Vec3> out;
  for (int k = 1; k < n; ++k) {
    const double at = -half + 2 * low * k;
    out.push_back(centre + R * std::sin(at) * x + R * std::cos(at) * y);
  }
  return out;
}

/// Knot and legs as they rest, the loop closed by so many segments, tails cut to what is left of all segments.
std::vector<Vec3> specimen(const PullTest& test, int closing) {
  const PullResult r = pull(test);
  if (r.rested.empty()) throw std::runtime_error(text(test.word) + " was not tied");
  const std::vector<Vec3>& node = r.rested;
  const int n = static_cast<int>(node.size()), leg = static_cast<int>(kLeg / test.segment);
  const auto falling = in_knot(node, 0, r.loop - 1), rising = in_knot(node, r.loop + 2, n);
  const int a = std::min(falling.second + leg, r.loop - 1), b = std::max(rising.first - leg, r.loop + 1);
  const int tails = kSegments + 1 - (closing - 1) - (a + 1 - falling.first) - (rising.second + 1 - b);
  const int first = falling.first - tails / 2, last = rising.second + tails - tails / 2;
  std::fprintf(stderr, "%s: knot %d-%d, %d-%d, legs to %d, %d, loop %d of %d; %d for the tails, %d to %d\n", text(test.word).c_str(), falling.first, falling.second,
               rising.first, rising.second, a, b, r.loop, n, tails, first, last);
  if (tails < 0 || first < 0 || last >= n) throw std::runtime_error(text(test.word) + " is too long");
  std::vector<Vec3> all(node.begin() + first, node.begin() + a + 1);
  const std::vector<Vec3> loop = bridge(node[static_cast<size_t>(a)], node[static_cast<size_t>(b)], Vec3(0, 0, -1), closing, test.segment);
  all.insert(all.end(), loop.begin(), loop.end());
  all.insert(all.end(), node.begin() + b, node.begin() + last + 1);
  Vec3 middle = Vec3::Zero();
  for (const Vec3& p : loop) middle += p / static_cast<double>(loop.size());
  for (Vec3& p : all) p -= middle, p = Vec3(p.x(), p.z(), -p.y());
  std::fprintf(stderr, "%s: passages %d, tails of %d segments\n", text(test.word).c_str(), r.tighten.passages + r.rest.passages, tails / 2);
  return all;
}

/// One strand drawn straight, the other about it.
PullTest sliding() {
  PullTest t = laid({1, 1});
  t.pretension = 60e-3, t.unit = kWide, t.tail = 10;
  t.shape.core = 1, t.winds = 0.4, t.draw_for = 2;
  return t;
}

/// The second throw drawn tight while the first one has slack.
PullTest loose() {
  PullTest t = laid({1, -1});
  t.pretension = 60e-3, t.unit = kWide, t.tail = 10;
  t.shape.spacing = 8, t.legs = 0.02, t.tying_friction = 0.4, t.draw_for = 1.5;
  return t;
}

void print(const char* name, const std::vector<Vec3>& node) {
  std::printf("# %s\n", name);
  for (size_t i = 0; i < node.size(); ++i)
    std::printf("%s%.4f %.4f %.4f", i == 0 ? "" : ", ", 1e3 * node[i].x(), 1e3 * node[i].y(), 1e3 * node[i].z());
  std::printf(" mm\n");
}

}  // namespace
}  // namespace swage::test

int main() {
  using namespace swage::test;
  std::printf("# Nodes of a thread of %d segments of %.0f um, 8-0 nylon, in which a knot is tied. Made by knot_specimens (tests/knots/specimens.cpp).\n",
              kSegments, 1e6 * kSegment);
  print("square", specimen(tied({1, -1}), 42));
  print("granny", specimen(tied({1, 1}), 42));
  print("sliding", specimen(sliding(), 40));
  print("loose first throw", specimen(loose(), 26));
  return 0;
}
