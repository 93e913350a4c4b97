// SPDX-License-Identifier: Apache-2.0
//
// Specimens of lesson 134: knots that are laid, drawn tight and let go (pull.hpp), then closed to a loop. Prints the start shapes of
// a thread ("nodes"), one a line: square, granny, sliding, loose first throw.
//
// Frame: the loop lies about two posts, the left one in the origin, the other one on +x; the knot and its tails towards +y, z to who
// looks. 8-0 nylon.
#include <cmath>
#include <cstdio>
#include <numbers>
#include <stdexcept>

#include "pull.hpp"

namespace swage::test {
namespace {

constexpr double kDiameter = 45e-6, kSegment = 3 * kDiameter;  // m
constexpr int kSegments = 124;
constexpr double kWide = 3.864 * kDiameter;  // m, radius of throws that are not drawn tight
constexpr double kRound = 0.24e-3;   // m, of the thread about a post of 0.4 mm: its chords stay clear
constexpr double kWanted = 1.2e-3;   // m, half the distance of the posts, at most
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
  t.pretension = 220e-3, t.unit = 2.5 * kDiameter, t.shape.spacing = 4.5, t.tail = 30;
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

/// The way from `a` about both posts to `b`, in the plane of z of both: `side` is 1 where the leg that ends in `a` goes to the right.
std::vector<Vec3> band(const Vec3& a, const Vec3& b, double side, double w) {
  const Vec3 middle = 0.5 * (a + b), down(0, -kRound, 0);
  std::vector<Vec3> way{a};
  for (const double s : {side, -side})
    for (int k = 0; k <= 16; ++k) {
      const double turn = std::numbers::pi * k / 16, up = s == side ? std::cos(turn) : -std::cos(turn);
      way.push_back(middle + down + Vec3(s * (w + kRound * std::sin(turn)), kRound * up, 0));
    }
  way.push_back(b);
  return way;
}

/// Nodes one chord apart along a way, `n` in all without its first point. Returns what is left of the way behind the last one [m].
double walk(const std::vector<Vec3>& way, int n, double chord, std::vector<Vec3>& out) {
  Vec3 from = way.front();
  size_t k = 0;
  for (out.clear(); static_cast<int>(out.size()) < n && k + 1 < way.size();) {
    const Vec3 p = way[k] - from, d = way[k + 1] - way[k];
    const double A = d.squaredNorm(), B = p.dot(d), C = p.squaredNorm() - chord * chord, D = B * B - A * C;
    const double share = D >= 0 ? (-B + std::sqrt(D)) / A : 2;
    if (share > 1 || share < 0)
      ++k;
    else
      out.push_back(from = way[k] + share * d);
  }
  if (static_cast<int>(out.size()) < n) return -1;
  double left = (way[k + 1] - from).norm();
  for (++k; k + 1 < way.size(); ++k) left += (way[k + 1] - way[k]).norm();
  return left;
}

/// Half the distance of the posts about which a loop of so many segments from a to b is neither stretched nor slack.
double half_distance(const Vec3& a, const Vec3& b, double side, int closing, double chord, std::vector<Vec3>& loop) {
  double low = 0, high = 10e-3;
  for (int i = 0; i < 60; ++i) {
    const double w = 0.5 * (low + high);
    (walk(band(a, b, side, w), closing - 1, chord, loop) > chord ? high : low) = w;
  }
  return low;
}

/// Knot and legs as they rest, the loop closed about two posts, tails cut to what is left of all segments. Origin: the left post.
std::vector<Vec3> specimen(const PullTest& test, int leg) {
  const PullResult r = pull(test);
  if (r.rested.empty()) throw std::runtime_error(text(test.word) + " was not tied");
  std::vector<Vec3> node = r.rested;
  for (Vec3& p : node) p = Vec3(p.x(), p.z(), -p.y());
  const int n = static_cast<int>(node.size());
  const auto falling = in_knot(node, 0, r.loop - 1), rising = in_knot(node, r.loop + 2, n);
  const int a = std::min(falling.second + leg, r.loop - 1), b = std::max(rising.first - leg, r.loop + 1);
  const Vec3 pa = node[static_cast<size_t>(a)], pb = node[static_cast<size_t>(b)];
  const double side = pa.x() > node[static_cast<size_t>(a - 2)].x() ? 1 : -1;
  std::vector<Vec3> loop;
  int closing = 12;
  while (half_distance(pa, pb, side, closing + 1, test.segment, loop) < kWanted) ++closing;
  const double w = half_distance(pa, pb, side, closing, test.segment, loop);
  const int tails = kSegments + 1 - (closing - 1) - (a + 1 - falling.first) - (rising.second + 1 - b);
  const int first = falling.first - tails / 2, last = rising.second + tails - tails / 2;
  std::fprintf(stderr, "%s: knot %d-%d, %d-%d, legs to %d, %d, loop %d of %d, closed by %d; %d for the tails, %d to %d; posts %.4f mm apart; passages %d\n",
               text(test.word).c_str(), falling.first, falling.second, rising.first, rising.second, a, b, r.loop, n, closing, tails, first, last, 2e3 * w,
               r.tighten.passages + r.rest.passages);
  if (tails < 0 || first < 0 || last >= n) throw std::runtime_error(text(test.word) + " is too long");
  std::vector<Vec3> all(node.begin() + first, node.begin() + a + 1);
  all.insert(all.end(), loop.begin(), loop.end());
  all.insert(all.end(), node.begin() + b, node.begin() + last + 1);
  const Vec3 post = 0.5 * (pa + pb) - Vec3(w, kRound, 0);
  for (Vec3& p : all) p -= post;
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
  print("square", specimen(tied({1, -1}), 5));
  print("granny", specimen(tied({1, 1}), 5));
  print("sliding", specimen(sliding(), 5));
  print("loose first throw", specimen(loose(), 5));
  return 0;
}
