// SPDX-License-Identifier: Apache-2.0
//
// The independent judge: libhomfly on a diagram made here, in plain doubles, from the whole closed polygon.
extern "C" {
#include <homfly.h>
}

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "ties.hpp"

namespace swage::test {

namespace {

struct Hit {
  double at;
  int crossing, over;
};

/// One component: crossing and over (1) or under (-1) in order, then the hand of each crossing.
std::string ask(const std::vector<Hit>& code, const std::vector<int>& hand) {
  if (code.empty()) return "1";
  std::string link = "1 " + std::to_string(code.size());
  for (const Hit& h : code) link += " " + std::to_string(h.crossing) + " " + std::to_string(h.over);
  for (size_t k = 0; k < hand.size(); ++k) link += " " + std::to_string(k) + " " + std::to_string(hand[k]);
  const char* answer = homfly_str(link.data());  // collected by the library
  std::string out = answer;
  return out;
}

bool see(const std::vector<Vec3>& p, const toolkit::Quat& q, size_t most, std::vector<Hit>& code, std::vector<int>& hand) {
  const size_t n = p.size();
  std::vector<Vec3> s(n);
  for (size_t i = 0; i < n; ++i) s[i] = q * p[i];
  code.clear(), hand.clear();
  const auto cross = [](const Vec3& a, const Vec3& b) { return a.x() * b.y() - a.y() * b.x(); };
  for (size_t i = 0; i < n; ++i)
    for (size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      const Vec3 &a = s[i], &c = s[j], u = s[(i + 1) % n] - a, v = s[(j + 1) % n] - c, w = c - a;
      const double turn = cross(u, v);
      if (turn == 0) continue;
      const double x = cross(w, v) / turn, y = cross(w, u) / turn;
      if (x < 0 || x >= 1 || y < 0 || y >= 1) continue;
      if (hand.size() == most) return false;
      const bool first_over = a.z() + x * u.z() > c.z() + y * v.z();
      const int k = static_cast<int>(hand.size());
      code.push_back({static_cast<double>(i) + x, k, first_over ? 1 : -1});
      code.push_back({static_cast<double>(j) + y, k, first_over ? -1 : 1});
      hand.push_back((turn > 0) == first_over ? 1 : -1);
    }
  std::sort(code.begin(), code.end(), [](const Hit& a, const Hit& b) { return a.at < b.at; });
  return true;
}

}  // namespace

std::string homfly(const std::vector<Vec3>& closed, int crossings, uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<Hit> code;
  std::vector<int> hand;
  for (int tries = 0; tries < 12; ++tries) {
    // one after the other: compilers evaluate arguments in different orders
    double at[4];
    for (double& a : at) a = normal(random);
    const toolkit::Quat q = toolkit::Quat(at[0], at[1], at[2], at[3]).normalized();
    if (!see(closed, q, static_cast<size_t>(crossings), code, hand)) continue;
    // no knot's polynomial is 0, as that of every knot is 1 at v = 1, z = 0: the library says so when it has failed
    if (const std::string said = ask(code, hand); said != "0") return said;
  }
  return "";
}

std::string homfly(const toolkit::KnotDiagram& diagram) {
  toolkit::KnotDiagram d = diagram;
  d.number_anew();
  std::vector<Hit> code;
  std::vector<int> hand;
  for (int i = 0; i < d.visits(); ++i) code.push_back({0, d.visit(i).crossing, d.visit(i).over ? 1 : -1});
  for (int k = 0; k < d.crossings(); ++k) hand.push_back(d.sign(k));
  return ask(code, hand);
}

std::string homfly(const Word& word) {
  std::vector<Hit> code;
  std::vector<int> hand, first;
  const auto add = [&](size_t i, bool second) {
    for (int k = 0; k <= 2 * std::abs(word[i]); ++k)
      code.push_back({0, first[i] + k, (k % 2 == 0) == second ? 1 : -1});
  };
  for (const int t : word) {
    first.push_back(static_cast<int>(hand.size()));
    hand.insert(hand.end(), static_cast<size_t>(2 * std::abs(t) + 1), t > 0 ? 1 : -1);
  }
  for (size_t i = word.size(); i-- > 0;) add(i, false);
  for (size_t i = 0; i < word.size(); ++i) add(i, true);
  return ask(code, hand);
}

}  // namespace swage::test
