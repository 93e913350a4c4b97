// SPDX-License-Identifier: Apache-2.0
//
// Crossings of a thread in their order along it (signed Gauss code, each crossing twice: over and under), and
// Reidemeister's moves on it. The two ends lie far away on the outside, where they are joined. A move of such codes is sound by the
// signs and orders in it alone, whether or not a picture in the plane is at hand (Goussarov, Polyak and Viro 2000: classical knots that
// are equal as virtual knots are equal). Header-only.
//
// Threads: [rt], nothing allocates.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace swage::toolkit {

/// One of the two visits to a crossing.
struct KnotVisit {
  int16_t crossing = 0;
  bool over = false;
  double s = 0;  // place on the thread, in nodes
};

class KnotDiagram {
 public:
  static constexpr int kCrossings = 120;

  /// Removes crossings by Reidemeister's first and second move until neither applies.
  void shorten();
  /// Reidemeister's third move at a random place; false where it applies nowhere.
  bool turn_triangle(unsigned& choice);
  /// Renumbers the crossings from 0 in their order along the thread.
  void number_anew();

  int crossings() const { return n_ / 2; }
  int visits() const { return n_; }
  const KnotVisit& visit(int i) const { return code_[at(i)]; }
  int sign(int crossing) const { return sign_[at(crossing)]; }
  /// Index of the visit to a crossing over (true) or under (false).
  int place(int crossing, bool over) const { return place_[at(crossing)][over]; }
  /// Sum of the signs.
  int writhe() const;
  /// Sets the code: each crossing twice; signs are indexed by crossing.
  void set(const KnotVisit* visit, int visits, const int8_t* sign, int signs);

 private:
  static size_t at(int i) { return static_cast<size_t>(i); }
  // the ends are joined far away: after the last visit comes the first
  int after(int i) const { return i + 1 == n_ ? 0 : i + 1; }
  int before(int i) const { return i == 0 ? n_ - 1 : i - 1; }
  bool in_a_row(int i, int j) const { return after(i) == j || after(j) == i; }
  void find_places();
  void drop(int crossing_a, int crossing_b);
  bool drop_loop();
  bool drop_pair();
  bool triangle(int i, int j, int k) const;

  std::array<KnotVisit, 2 * kCrossings> code_;
  std::array<int8_t, kCrossings> sign_;
  std::array<std::array<int16_t, 2>, kCrossings> place_;  // index of both visits to a crossing, under first
  int n_ = 0;
};

inline void KnotDiagram::set(const KnotVisit* visit, int visits, const int8_t* sign, int signs) {
  n_ = visits;
  std::copy_n(visit, visits, code_.begin());
  std::copy_n(sign, signs, sign_.begin());
  find_places();
}

inline int KnotDiagram::writhe() const {
  int sum = 0;
  for (int i = 0; i < n_; ++i)
    if (code_[at(i)].over) sum += sign(code_[at(i)].crossing);
  return sum;
}

inline void KnotDiagram::find_places() {
  for (int i = 0; i < n_; ++i) place_[at(code_[at(i)].crossing)][code_[at(i)].over] = static_cast<int16_t>(i);
}

inline void KnotDiagram::drop(int a, int b) {
  int to = 0;
  for (int i = 0; i < n_; ++i)
    if (code_[at(i)].crossing != a && code_[at(i)].crossing != b) code_[at(to++)] = code_[at(i)];
  n_ = to;
  find_places();
}

/// First move: removes a crossing that is visited twice in a row.
inline bool KnotDiagram::drop_loop() {
  for (int i = 0; i < n_; ++i)
    if (code_[at(i)].crossing == code_[at(after(i))].crossing) return drop(code_[at(i)].crossing, -1), true;
  return false;
}

/// Second move: removes two crossings of opposite sign, visited in a row by the strand that is over both and in a row by the other.
inline bool KnotDiagram::drop_pair() {
  for (int i = 0; i < n_; ++i) {
    const KnotVisit &a = code_[at(i)], &b = code_[at(after(i))];
    if (!a.over || !b.over || sign(a.crossing) == sign(b.crossing)) continue;
    if (in_a_row(place_[at(a.crossing)][0], place_[at(b.crossing)][0])) return drop(a.crossing, b.crossing), true;
  }
  return false;
}

/// True for a strand over two others at i and the next visit, the second one at j (under the first, over the last), the last at k (under
/// both): three lines in a plane, of which the third move may take one past the crossing of the others.
inline bool KnotDiagram::triangle(int i, int j, int k) const {
  const KnotVisit &p = code_[at(j)], &q = code_[at(after(j))];
  const int x = p.over ? q.crossing : p.crossing, z = p.over ? p.crossing : q.crossing;
  const bool x_first = code_[at(i)].crossing == x;
  const int y = x_first ? code_[at(after(i))].crossing : code_[at(i)].crossing;
  const int first = (x_first ? 1 : -1) * sign(x) * sign(y);
  const int second = (p.crossing == x ? 1 : -1) * sign(x) * sign(z);
  const int third = (code_[at(k)].crossing == y ? 1 : -1) * sign(y) * sign(z);
  return first == -second && first == third;
}

/// Third move, at a random one of the places where it applies.
inline bool KnotDiagram::turn_triangle(unsigned& choice) {
  int found = 0, turned[3] = {};
  for (int i = 0; i < n_; ++i) {
    const KnotVisit &a = code_[at(i)], &b = code_[at(after(i))];
    if (!a.over || !b.over) continue;
    for (const auto& [x, y] : {std::pair(a.crossing, b.crossing), std::pair(b.crossing, a.crossing)}) {
      const int below_x = place_[at(x)][0], below_y = place_[at(y)][0];
      for (const int j : {before(below_x), below_x}) {
        const KnotVisit& z = code_[at(j == below_x ? after(j) : j)];
        const int below_z = place_[at(z.crossing)][0];
        if (!z.over || z.crossing == y || !in_a_row(below_y, below_z)) continue;
        const int k = after(below_y) == below_z ? below_y : below_z;
        if (!triangle(i, j, k)) continue;
        choice = choice * 1664525u + 1013904223u;
        if ((choice >> 8) % static_cast<unsigned>(++found) == 0) turned[0] = i, turned[1] = j, turned[2] = k;
      }
    }
  }
  if (found == 0) return false;
  for (const int i : turned) std::swap(code_[at(i)], code_[at(after(i))]);
  find_places();
  return true;
}

inline void KnotDiagram::shorten() {
  find_places();
  while (drop_loop() || drop_pair()) {
  }
}

inline void KnotDiagram::number_anew() {
  std::array<int16_t, kCrossings> number;
  std::array<int8_t, kCrossings> sign;
  number.fill(-1);
  int16_t next = 0;
  for (int i = 0; i < n_; ++i) {
    int16_t& k = number[at(code_[at(i)].crossing)];
    if (k < 0) k = next++, sign[at(k)] = sign_[at(code_[at(i)].crossing)];
    code_[at(i)].crossing = k;
  }
  std::copy_n(sign.begin(), next, sign_.begin());
  find_places();
}

}  // namespace swage::toolkit
