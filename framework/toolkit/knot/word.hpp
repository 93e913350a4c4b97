// SPDX-License-Identifier: Apache-2.0
//
// The word of a knot: its throws in the order in which they were tied, each with its turns and its sign, such as (+2, -1, +1), the
// surgeon's knot. A throw of n turns is two strands that pass each other 2 n + 1 times, alternately, the torus knot T(2, 2 n + 1);
// throws are tied one around the loop of the other, so along the thread they are nested: the innermost is the first.
// Parts of a diagram that share no strand between them (no chord of its code crosses another's) are read one by one.
// Header-only.
//
// Threads: [rt], nothing allocates.
#pragma once

#include "toolkit/knot/invariants.hpp"
#include "toolkit/knot/thread.hpp"

namespace swage::toolkit {

/// One throw. `first` and `last`: places on the thread, in nodes, between which each of its two strands is in the throw.
struct KnotThrow {
  int turns = 0, sign = 0;
  int knot = 0;  // throws around one loop are one knot; a thread may carry several, in the order along it
  struct Strand {
    double first = 0, last = 0;
  } strand[2];
};

struct KnotWord {
  static constexpr int kThrows = KnotFindings::kThrows;
  int throws = 0;
  std::array<KnotThrow, kThrows> tied{};  // knot by knot, in each the first throw first
  int knots = 0;
  int others = 0;  // parts that are no throw; a thread with some is tangled, or knotted in another way
  KnotInvariants invariants;

  /// A whole number below 2^52 that identifies a word; -1 for a thread with other parts.
  double number() const {
    if (others > 0) return -1;
    uint64_t h = 0xcbf29ce484222325u;  // FNV-1a, by throws
    for (size_t i = 0; i < static_cast<size_t>(throws); ++i)
      h = (h ^ static_cast<uint64_t>((tied[i].knot * 256 + tied[i].turns) * 2 + (tied[i].sign > 0))) * 0x100000001b3u;
    return static_cast<double>(h >> 12);
  }
};

/// Invariants of the knot that a word describes: the product of 2 n + 1, and minus the sum of 2 n.
inline KnotInvariants invariants_of(const KnotWord& word) {
  KnotInvariants out{word.others == 0, 1, 0};
  for (size_t i = 0; i < static_cast<size_t>(word.throws); ++i) {
    out.determinant *= 2 * word.tied[i].turns + 1;
    out.signature -= 2 * word.tied[i].sign * word.tied[i].turns;
  }
  return out;
}

/// Reads a reduced diagram.
class KnotReading {
 public:
  static KnotWord read(const KnotDiagram& diagram) {
    KnotReading reading(diagram);
    reading.part();
    return reading.word();
  }

 private:
  static constexpr int kParts = 2 * KnotWord::kThrows;
  static size_t at(int i) { return static_cast<size_t>(i); }
  explicit KnotReading(const KnotDiagram& d) : d_(d) {}

  int root(int k) const {
    while (parent_[at(k)] != k) k = parent_[at(k)];
    return k;
  }
  /// Divides the crossings into parts: those whose chords cross are of one part.
  void part() {
    for (int k = 0; k < KnotDiagram::kCrossings; ++k) parent_[at(k)] = k, open_[at(k)] = -1;
    // the chords that are open, in order of their beginnings; one that ends crosses all that began after it
    std::array<int, KnotDiagram::kCrossings> stack;
    int n = 0;
    for (int i = 0; i < d_.visits(); ++i) {
      const int k = d_.visit(i).crossing;
      if (open_[at(k)] < 0) {
        open_[at(k)] = i, stack[at(n++)] = k;
        continue;
      }
      int j = n - 1;
      for (; stack[at(j)] != k; --j) parent_[at(root(stack[at(j)]))] = root(k);
      std::copy(stack.begin() + j + 1, stack.begin() + n, stack.begin() + j), --n;
    }
  }
  /// Reads a part as a throw: after half of its visits the same crossings in the same order, over and under in turn. False: it is none.
  bool read_throw(int part, KnotThrow& out) const {
    std::array<int, 2 * KnotDiagram::kCrossings> visit;
    int n = 0;
    for (int i = 0; i < d_.visits(); ++i)
      if (root(d_.visit(i).crossing) == part) visit[at(n++)] = i;
    const int c = n / 2;
    if (c < 3 || c % 2 == 0) return false;
    const int sign = d_.sign(part);
    for (int i = 0; i < c; ++i) {
      const KnotVisit &a = d_.visit(visit[at(i)]), &b = d_.visit(visit[at(i + c)]);
      if (a.crossing != b.crossing || d_.sign(a.crossing) != sign) return false;
      if (i > 0 && a.over == d_.visit(visit[at(i - 1)]).over) return false;
    }
    out.turns = (c - 1) / 2, out.sign = sign;
    find_strands(visit.data(), c, out);
    return true;
  }
  /// The two strands are on two sides of the parts nested in the throw: of the longest gap between two successive visits.
  void find_strands(const int* visit, int c, KnotThrow& out) const {
    int gap = c - 1;
    for (int i = 0; i + 1 < 2 * c; ++i)
      if (visit[i + 1] - visit[i] > visit[gap + 1] - visit[gap]) gap = i;
    const auto s = [&](int i) { return d_.visit(visit[i]).s; };
    out.strand[0] = {s(0), s(gap)};
    out.strand[1] = {s(gap + 1), s(2 * c - 1)};
  }
  /// Whether part b lies within part a: between two visits of a, and not beyond all of them.
  bool within(int b, int a) const { return first_[at(b)] > first_[at(a)] && first_[at(b)] < last_[at(a)]; }

  KnotWord word() {
    KnotWord out;
    std::array<int, kParts> part{};
    int parts = 0;
    for (int i = 0; i < d_.visits(); ++i) {
      const int p = root(d_.visit(i).crossing);
      int k = 0;
      while (k < parts && part[at(k)] != p) ++k;
      if (k == kParts) return out.others = kParts, out;
      if (k == parts) part[at(parts++)] = p, first_[at(k)] = i;
      last_[at(k)] = i;
    }
    std::array<bool, kParts> told{};
    // innermost parts in the order of the thread, and outward from each as far as nothing else lies within
    for (int k = 0; k < parts; ++k) {
      if (told[at(k)] || !ready(k, parts, told)) continue;
      bool started = false;
      for (int p = k; p >= 0; p = outward(p, parts, told)) {
        told[at(p)] = true;
        add(part[at(p)], started, out);
      }
      k = -1;  // what lay outside of two may be ready now
    }
    out.invariants = KnotSurface::invariants(d_);
    return out;
  }
  void add(int part, bool& started, KnotWord& out) const {
    KnotThrow next;
    if (out.throws == KnotWord::kThrows || !read_throw(part, next)) {
      ++out.others;
      return;
    }
    out.knots += !started;
    started = true;
    next.knot = out.knots - 1;
    out.tied[at(out.throws++)] = next;
  }
  bool ready(int k, int parts, const std::array<bool, kParts>& told) const {
    for (int j = 0; j < parts; ++j)
      if (j != k && !told[at(j)] && within(j, k)) return false;
    return true;
  }
  /// The next part outward of p, when it is ready.
  int outward(int p, int parts, const std::array<bool, kParts>& told) const {
    int best = -1;
    for (int j = 0; j < parts; ++j)
      if (!told[at(j)] && within(p, j) && ready(j, parts, told) && (best < 0 || within(j, best))) best = j;
    return best;
  }

  const KnotDiagram& d_;
  std::array<int, KnotDiagram::kCrossings> parent_, open_;
  std::array<int, kParts> first_{}, last_{};
};

}  // namespace swage::toolkit
