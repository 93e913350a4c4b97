// SPDX-License-Identifier: Apache-2.0
//
// Reduces a diagram as far as possible: Reidemeister's moves, and strands that lie over (or under) all that they cross, which are
// rerouted through the fewest arcs between their two ends. Header-only.
//
// Threads: [rt], nothing allocates.
#pragma once

#include "toolkit/knot/faces.hpp"

namespace swage::toolkit {

class KnotStrand {
 public:
  /// Tries at most `turns` third moves where nothing else removes a crossing.
  void reduce(KnotDiagram& d, int turns = 20) {
    unsigned choice = 1;
    for (int turned = 0;; ++turned) {
      do d.shorten();
      while (lay_anew(d));
      if (turned == turns || d.crossings() < 3 || alternates(d) || !d.turn_triangle(choice)) return;
    }
  }

 private:
  static size_t at(int i) { return static_cast<size_t>(i); }
  static constexpr int kVisits = 2 * KnotDiagram::kCrossings, kFar = 1 << 20;

  /// A diagram in which over and under take turns, and that has no loops to take off, has the fewest crossings already.
  static bool alternates(const KnotDiagram& d) {
    for (int i = 0; i + 1 < d.visits(); ++i)
      if (d.visit(i).over == d.visit(i + 1).over) return false;
    return true;
  }
  bool lay_anew(KnotDiagram& d) {
    d.number_anew();
    if (d.crossings() < 3 || !faces_.find(d)) return false;
    const int n = d.visits();
    for (int first = 0; first < n;) {
      int end = first + 1;
      while (end < n && d.visit(end).over == d.visit(first).over) ++end;
      if (end - first >= 2 && lay_strand(d, first, end)) return true;
      first = end;
    }
    return false;
  }
  /// Reroutes the strand of the visits first to end - 1, whose own arcs first - 1 to end - 1 cost nothing. False where that saves nothing.
  bool lay_strand(KnotDiagram& d, int first, int end) {
    find_way(d, first, end);
    const int last_arc = end - 1;
    int to = faces_.left(last_arc);
    if (way_[at(faces_.right(last_arc))].length < way_[at(to)].length) to = faces_.right(last_arc);
    if (way_[at(to)].length >= end - first) return false;
    write(d, first, end, to);
    return true;
  }
  /// Shortest routes from the start of the strand to all faces. Its own arcs cost nothing; the arc through infinity is not crossed.
  void find_way(const KnotDiagram& d, int first, int end) {
    const int n = d.visits(), before = (first + n - 1) % n;
    std::fill_n(way_.begin(), faces_.count(), Way{kFar, -1, -1});
    for (const int face : {faces_.left(before), faces_.right(before)}) way_[at(face)].length = 0;
    for (bool changed = true; changed;) {
      changed = false;
      for (int arc = 0; arc < n; ++arc) {
        const bool own = arc == before || (arc >= first && arc < end);
        if (arc == n - 1 && !own) continue;
        const int l = faces_.left(arc), r = faces_.right(arc), cost = own ? 0 : 1;
        for (const auto& [from, to] : {std::pair(l, r), std::pair(r, l)}) {
          if (way_[at(from)].length + cost >= way_[at(to)].length) continue;
          way_[at(to)] = {way_[at(from)].length + cost, from, own ? -1 : arc};
          changed = true;
        }
      }
    }
  }
  void write(KnotDiagram& d, int first, int end, int to) {
    const int n = d.visits(), turns = way_[at(to)].length;
    const bool over = d.visit(first).over;
    std::array<bool, KnotDiagram::kCrossings> dropped{};
    for (int i = first; i < end; ++i) dropped[at(d.visit(i).crossing)] = true;
    std::fill_n(crossed_.begin(), n, -1);
    // the route is known from its end; new crossings take numbers of old ones
    std::array<int8_t, KnotDiagram::kCrossings> sign{};
    for (int k = 0; k < n / 2; ++k) sign[at(k)] = static_cast<int8_t>(d.sign(k));
    for (int face = to, k = turns; way_[at(face)].from >= 0; face = way_[at(face)].from) {
      const int arc = way_[at(face)].arc;
      if (arc < 0) continue;
      const int crossing = d.visit(first + --k).crossing;
      crossed_[at(arc)] = crossing;
      const bool rightward = way_[at(face)].from == faces_.left(arc);
      sign[at(crossing)] = rightward == over ? 1 : -1;
    }
    int out = 0;
    for (int i = 0; i < n; ++i) {
      const KnotVisit& v = d.visit(i);
      if (i == first)
        for (int k = 0; k < turns; ++k) code_[at(out++)] = d.visit(first + k);
      if (!dropped[at(v.crossing)]) code_[at(out++)] = v;
      if (crossed_[at(i)] >= 0) code_[at(out++)] = {static_cast<int16_t>(crossed_[at(i)]), !over, v.s};
    }
    d.set(code_.data(), out, sign.data(), n / 2);
  }

  struct Way {
    int length, from, arc;  // number of crossed arcs; the face before and the arc between (-1: the strand itself)
  };
  KnotFaces faces_;
  std::array<Way, KnotFaces::kFaces> way_;
  std::array<int, kVisits> crossed_;
  std::array<KnotVisit, kVisits> code_;
};

}  // namespace swage::toolkit
