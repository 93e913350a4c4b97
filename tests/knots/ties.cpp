// SPDX-License-Identifier: Apache-2.0
#include "ties.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace swage::test {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kFine = 3;  // samples of an edge, with which its sag is measured

double uniform(std::mt19937_64& random, double from, double to) {
  return from + (to - from) * static_cast<double>(random() >> 11) * 0x1p-53;
}
int whole(std::mt19937_64& random, int from, int to) {
  return from + static_cast<int>(random() % static_cast<uint64_t>(to - from + 1));
}

/// One strand through throw i, from -d L to d L along x: rising from below to above, or falling.
void add_pass(const Word& word, const TieShape& shape, int i, bool rising, std::vector<Vec3>& out) {
  const int turns = std::abs(word[static_cast<size_t>(i)]), halves = 2 * turns + 1;
  const double d = i % 2 == 0 ? 1 : -1, sense = (word[static_cast<size_t>(i)] > 0 ? 1 : -1) * d;
  const bool is_core = rising == (shape.core_swaps && i % 2 == 1);
  const double r = shape.radius * (is_core ? 1 - 0.98 * shape.core : 1 + 0.98 * shape.core),
               half_length = 0.5 * shape.pitch * halves;
  const int samples = 5 * halves;
  for (int k = 0; k <= samples; ++k) {
    const double t = static_cast<double>(k) / samples;
    const double phi = (rising ? -0.5 : 0.5) * kPi + sense * halves * kPi * t;
    out.push_back({d * half_length * (2 * t - 1), r * std::cos(phi), i * shape.spacing + r * std::sin(phi)});
  }
}

/// The way out of the last throw, of length shape.tail, and on to where all tails end.
void add_tail(const TieShape& shape, double side, std::mt19937_64& random, std::vector<Vec3>& out,
              std::vector<Vec3>& far) {
  const Vec3 from = out.back();
  const double rise = uniform(random, 0.1, 0.8), across = uniform(random, -0.4, 0.4);
  // out of the winding first
  Vec3 base = from + Vec3(side * (2.5 * shape.radius + 2 * shape.coil), 0, 0);
  out.push_back(0.5 * (from + base)), out.push_back(base);
  if (shape.tail_turns > 0) {  // up along the middle, around the other tail
    const double r = 1.2 * shape.radius, up = from.z() + 5 * shape.radius;
    out.push_back({base.x(), 0, up - 1.5 * shape.radius});
    const int samples = 5 * shape.tail_turns;
    for (int k = 0; k <= samples; ++k) {
      const double phi = kPi * shape.tail_turns * k / samples;
      out.push_back({side * r * std::cos(phi), side * r * std::sin(phi), up + 0.5 * shape.pitch * k / 5});
    }
    side *= shape.tail_turns % 2 == 0 ? 1 : -1;
    base = out.back();
  }
  const Vec3 u = Vec3(side, across, rise).normalized(), v = u.cross(Vec3(0, 1, 0)).normalized(), w = u.cross(v);
  const int samples = std::max(4, static_cast<int>(shape.tail));
  for (int k = 1; k <= samples; ++k) {
    const double l = shape.tail * k / samples;
    out.push_back(base + l * u + shape.coil * (std::sin(l / 1.5) * v + (1 - std::cos(l / 1.5)) * w));
  }
  for (int k = 1; k <= 12; ++k) far.push_back(out.back() + 6.0 * k * u);
}

Vec3 spline(const std::vector<Vec3>& p, double at) {
  const int last = static_cast<int>(p.size()) - 1, i = std::clamp(static_cast<int>(at), 0, last - 1);
  const double t = at - i;
  const auto c = [&](int k) { return p[static_cast<size_t>(std::clamp(k, 0, last))]; };
  const Vec3 a = c(i - 1), b = c(i), d = c(i + 1), e = c(i + 2);
  return 0.5 * (2 * b + t * (d - a) + t * t * (2 * a - 5 * b + 4 * d - e) + t * t * t * (3 * b - a - 3 * d + e));
}

/// n points at even distances along a curve through the points, its first and last among them, or every so many of these.
std::vector<Vec3> even(const std::vector<Vec3>& p, int n, int every = 1) {
  std::vector<double> length{0};
  const int fine = 12 * static_cast<int>(p.size());
  const double whole_curve = static_cast<double>(p.size() - 1);
  std::vector<Vec3> curve;
  for (int k = 0; k <= fine; ++k) curve.push_back(spline(p, whole_curve * k / fine));
  for (size_t k = 1; k < curve.size(); ++k) length.push_back(length.back() + (curve[k] - curve[k - 1]).norm());
  std::vector<Vec3> out;
  size_t k = 0;
  for (int i = 0; i < n; i += every) {
    const double l = length.back() * i / (n - 1);
    while (k + 2 < curve.size() && length[k + 1] < l) ++k;
    const double t = std::clamp((l - length[k]) / (length[k + 1] - length[k]), 0.0, 1.0);
    out.push_back(curve[k] + t * (curve[k + 1] - curve[k]));
  }
  return out;
}

struct Shear {
  Vec3 wave, move;
  double phase;
  Vec3 operator()(const Vec3& p) const { return p + std::sin(wave.dot(p) + phase) * move; }
};

/// A direction with even chances.
Vec3 direction(std::mt19937_64& random) {
  const double z = uniform(random, -1, 1), phi = uniform(random, 0, 2 * kPi), r = std::sqrt(1 - z * z);
  return {r * std::cos(phi), r * std::sin(phi), z};
}

double distance(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
  const Vec3 u = q - p, v = s - r, w = p - r;
  const double a = u.dot(u), b = u.dot(v), c = v.dot(v), d = u.dot(w), e = v.dot(w), n = a * c - b * b;
  double x = n > 1e-12 * a * c ? std::clamp((b * e - c * d) / n, 0.0, 1.0) : 0.0;
  const double y = std::clamp((b * x + e) / c, 0.0, 1.0);
  x = std::clamp((b * y - d) / a, 0.0, 1.0);
  return (w + x * u - y * v).norm();
}

/// The polygon is knotted as the curve is: no two pieces of it come nearer than both sag from the curve, and no corner is sharp.
bool faithful(const std::vector<Vec3>& node, const std::vector<double>& sag) {
  const size_t n = node.size();
  std::vector<Vec3> middle(n);
  std::vector<double> half(n);
  for (size_t i = 0; i < n; ++i) {
    const Vec3 e = node[(i + 1) % n] - node[i], f = node[(i + 2) % n] - node[(i + 1) % n];
    if (e.dot(f) < 0.2 * e.norm() * f.norm()) return false;
    middle[i] = node[i] + 0.5 * e, half[i] = 0.5 * e.norm();
  }
  for (size_t i = 0; i < n; ++i)
    for (size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      const double near = 2 * (sag[i] + sag[j]);
      if ((middle[i] - middle[j]).norm() > near + half[i] + half[j]) continue;
      if (distance(node[i], node[(i + 1) % n], node[j], node[(j + 1) % n]) <= near && j > i + 2 && j + 1 < n + i - 1)
        return false;
    }
  return true;
}

/// Draws the thread tight: nodes go towards the middle of their neighbours, none by more than a quarter of the way to any other
/// piece, and none nearer than a thread's thickness.
void tighten(std::vector<Vec3>& node, int fixed_from, int rounds, double thick) {
  const int n = static_cast<int>(node.size());
  std::vector<Vec3> to = node;
  std::vector<double> room(node.size());
  const auto p = [&](int i) -> const Vec3& { return node[static_cast<size_t>((i + n) % n)]; };
  for (int round = 0; round < rounds; ++round) {
    std::fill(room.begin(), room.end(), HUGE_VAL);
    for (int i = 0; i < n; ++i)
      for (int j = i + 3; j < n; ++j) {
        if (i + n - j < 3) continue;
        if ((p(i) - p(j)).squaredNorm() > 64 * thick * thick) continue;
        const double d = distance(p(i), p(i + 1), p(j), p(j + 1));
        for (const int k : {i, i + 1, j, (j + 1) % n})
          room[static_cast<size_t>(k)] = std::min(room[static_cast<size_t>(k)], d);
      }
    for (int i = 1; i < fixed_from; ++i) {
      const size_t k = static_cast<size_t>(i);
      const Vec3 move = 0.4 * (0.5 * (p(i - 1) + p(i + 1)) - p(i));
      const double most = std::max(0.0, std::min(0.2 * room[k], 0.5 * (room[k] - thick)));
      to[k] = p(i) + move * std::min(1.0, most / std::max(move.norm(), 1e-300));
    }
    node = to;
  }
}

struct Curve {
  std::vector<Vec3> thread, beyond;
};

Curve base_curve(const Word& word, const TieShape& shape, std::mt19937_64& random) {
  const int k = static_cast<int>(word.size());
  std::vector<Vec3> in, out, far_in, far_out;  // both from the loop upward
  const auto bulge = [&](std::vector<Vec3>& to, double z) {
    const double x = to.back().x();
    to.push_back({x + (x > 0 ? 1 : -1) * shape.radius * uniform(random, 0.8, 2), uniform(random, -0.3, 0.3), z});
  };
  for (int i = 0; i < k; ++i) {
    const double between = (i - 0.5) * shape.spacing;
    if (i > 0) bulge(out, between), bulge(in, between);
    add_pass(word, shape, i, true, out);
    std::vector<Vec3> falling;
    add_pass(word, shape, i, false, falling);
    in.insert(in.end(), falling.rbegin(), falling.rend());
  }
  if (k == 0) out.push_back({-2, 0, 0}), in.push_back({2, 0, 0});
  const double side = k == 0 ? -1 : out.back().x() > 0 ? 1 : -1;
  add_tail(shape, side, random, out, far_out);
  add_tail(shape, -side, random, in, far_in);
  const double deep = uniform(random, 0.6, 2) * shape.spacing, wide = std::abs(in.front().x()) + 1.5 * shape.radius;
  Curve curve;
  curve.thread.assign(in.rbegin(), in.rend());
  for (const double x : {1.0, 0.6, 0.0, -0.6, -1.0})
    curve.thread.push_back({x * wide, 0, in.front().z() - deep * (1.2 - std::abs(x))});
  curve.thread.insert(curve.thread.end(), out.begin(), out.end());
  curve.beyond = far_out;
  const Vec3 a = far_out.back(), b = far_in.back();
  for (int i = 1; i < 16; ++i) {
    const double t = i / 16.0;
    curve.beyond.push_back((1 - t) * a + t * b + Vec3(0, 0, 90 * std::sin(kPi * t)));
  }
  curve.beyond.insert(curve.beyond.end(), far_in.rbegin(), far_in.rend());
  return curve;
}

bool try_tie(const Word& word, const TieShape& shape, std::mt19937_64& random, Tie& out) {
  const Curve curve = base_curve(word, shape, random);
  std::vector<Shear> shear;
  for (int i = 0; i < shape.shears; ++i) {
    const Vec3 k = direction(random);
    const Vec3 move = k.cross(direction(random)).normalized() * uniform(random, 0.2, 1) * shape.shear;
    shear.push_back({k * uniform(random, 0.1, 1.2), move, uniform(random, 0, 2 * kPi)});
  }
  toolkit::Quat turned = toolkit::Quat::Identity();  // a tie without noise stands as it was made, throw above throw along z
  if (shape.shears > 0) turned = Eigen::AngleAxisd(uniform(random, 0, kPi), direction(random));
  const double scale = shape.shears > 0 ? std::pow(10, uniform(random, -4, 0)) : 1;
  const auto bend = [&](std::vector<Vec3>& p) {
    for (Vec3& v : p) {
      for (const Shear& s : shear) v = s(v);
      v = scale * (turned * v);
    }
  };
  const auto lay = [&](int every, std::vector<Vec3>& thread, std::vector<Vec3>& beyond) {
    thread = even(curve.thread, kFine * (shape.nodes - 1) + 1, every);
    std::vector<Vec3> ends = curve.beyond;
    ends.insert(ends.begin(), thread.back()), ends.push_back(thread.front());
    beyond = even(ends, kFine * 140 + 1, every);
    bend(thread), bend(beyond);
  };
  std::vector<Vec3> thread, beyond;
  lay(kFine, thread, beyond);
  // most are refused already for their nodes alone
  std::vector<Vec3> closed = thread;
  closed.insert(closed.end(), beyond.begin() + 1, beyond.end() - 1);
  if (!faithful(closed, std::vector<double>(closed.size(), 0.0))) return false;
  lay(1, thread, beyond);
  out.node.clear(), out.beyond.clear();
  std::vector<double> sag;
  const auto thin = [&](const std::vector<Vec3>& fine, std::vector<Vec3>& to, bool last) {
    for (size_t i = 0; i + kFine < fine.size(); i += kFine) {
      to.push_back(fine[i]);
      const Vec3 e = fine[i + kFine] - fine[i];
      double most = 0;
      for (size_t k = 1; k < kFine; ++k)
        most = std::max(most, (fine[i + k] - fine[i]).cross(e).norm() / e.norm());
      sag.push_back(most);
    }
    if (last) to.push_back(fine.back());
  };
  thin(thread, out.node, true);
  thin(beyond, out.beyond, false);
  out.beyond.erase(out.beyond.begin());
  out.word = word;
  if (!faithful(out.closed(), sag)) return false;
  if (shape.tighten > 0) {
    std::vector<Vec3> all = out.closed();
    double edge = 0;
    for (size_t i = 1; i < out.node.size(); ++i) edge += (out.node[i] - out.node[i - 1]).norm();
    tighten(all, out.nodes() - 1, shape.tighten, 0.8 * edge / (out.nodes() - 1));
    std::copy_n(all.begin(), out.node.size(), out.node.begin());
  }
  return true;
}

}  // namespace

std::vector<Vec3> Tie::closed() const {
  std::vector<Vec3> all = node;
  all.insert(all.end(), beyond.begin(), beyond.end());
  return all;
}

std::string text(const Word& word) {
  std::string out = "(";
  for (const int t : word) out += (out.size() > 1 ? ", " : "") + std::string(t > 0 ? "+" : "") + std::to_string(t);
  return out + ")";
}

std::optional<Tie> make_tie(const Word& word, const TieShape& shape, uint64_t seed) {
  std::mt19937_64 random(seed);
  TieShape tried = shape;
  Tie tie;
  // what is bent so far that a polygon of its nodes may be another knot is bent less
  for (int tries = 0; tries < 8; ++tries) {
    if (try_tie(word, tried, random, tie)) return tie;
    tried.shear *= 0.6, tried.coil *= 0.6;
    if (tries == 6) tried.shears = 0;
  }
  return std::nullopt;
}

TieShape random_shape(std::mt19937_64& random, int throws) {
  TieShape s;
  const int core = whole(random, 0, 3);
  s.core = core == 0 ? 0 : core == 1 ? 1 : uniform(random, 0, 1);
  s.core_swaps = whole(random, 0, 1) == 1;
  s.radius = uniform(random, 0.5, 1.5);
  s.pitch = s.radius * uniform(random, 1, 4);
  s.spacing = s.radius * uniform(random, 4.5, 10);
  s.tail = uniform(random, 2, 30);
  s.tail_turns = whole(random, 0, 4) == 0 ? whole(random, 1, 6) : 0;
  s.coil = whole(random, 0, 2) == 0 ? uniform(random, 0, 1.5) : 0;
  s.shears = whole(random, 0, 8);
  s.shear = uniform(random, 0.2, 3);
  s.nodes = whole(random, 60 + 40 * throws, 400);
  s.tighten = whole(random, 0, 49) == 0 ? whole(random, 20, 200) : 0;
  return s;
}

Tie random_tie(uint64_t seed, int throws) {
  std::mt19937_64 random(seed);
  Word word(static_cast<size_t>(whole(random, 0, throws)));
  for (int& t : word) t = whole(random, 1, 3) * (whole(random, 0, 1) == 0 ? 1 : -1);
  for (;;) {
    const TieShape shape = random_shape(random, static_cast<int>(word.size()));
    if (const auto tie = make_tie(word, shape, random())) return *tie;
  }
}

}  // namespace swage::test
