// SPDX-License-Identifier: Apache-2.0
//
// Names the knot in a thread: straightened a little, and fully where that is not enough (thread.hpp), seen from several
// directions (eye.hpp), each view reduced (strand.hpp) and read (word.hpp). A name is certain when two views or more
// give the same word, the plainest (from which the fewest crossings were removed) among them, none gives another knot, and determinant
// and signature are those of that word. The plainest view gives the places of its throws on the thread. Reading is done in slices of
// bounded work per call. Header-only.
//
//   thread.begin(nodes, n);
//   while (!reader.read(thread, 500, name)) ...   // one call a step
//
// Threads: [rt], nothing allocates; the reader is scratch, the thread keeps what lasts.
#pragma once

#include "toolkit/knot/eye.hpp"
#include "toolkit/knot/strand.hpp"
#include "toolkit/knot/word.hpp"

namespace swage::toolkit {

struct KnotName {
  KnotWord word;
  bool certain = false;
};

class KnotReader {
 public:
  static constexpr int kFirstViews = 12;  // views of a thread that has been straightened a little; all are used
  static constexpr int kViews = 36;       // with those of the fully straightened thread, where the first were not enough

  /// Continues by about `work` tests of pieces with pieces, or by one view. True when there is a name. An uncertain one has the word of
  /// the last view.
  bool read(KnotThread& thread, int work, KnotName& name) {
    if (!thread.straighten(work)) return false;
    const int k = static_cast<int>(thread.view);
    if (k == kFirstViews && thread.gap < KnotThread::kNodes) return thread.go_on(), false;
    thread.view += 1;
    if (eye_.look(thread, view(k), diagram_) == KnotSight::kSound) {
      const int seen = diagram_.crossings();
      strand_.reduce(diagram_);
      name.word = KnotReading::read(diagram_);
      note(name.word, seen - diagram_.crossings(), thread.findings);
    }
    const KnotFindings& found = thread.findings;
    name.certain = found.agreed >= 2 && found.contradicted == 0;
    if (k + 1 < kFirstViews || (!name.certain && k + 1 < kViews)) return false;
    if (name.certain) tell(found, name.word);
    return true;
  }
  /// The last view, reduced.
  const KnotDiagram& diagram() const { return diagram_; }

  static KnotView view(int k) {
    constexpr int slant[8][2] = {{1, 2}, {-2, 1}, {3, -1}, {-1, -3}, {4, 3}, {-3, 5}, {5, -4}, {-5, -2}};
    return {k % 3, slant[k / 3 % 8][0], slant[k / 3 % 8][1]};
  }

 private:
  static size_t at(int i) { return static_cast<size_t>(i); }
  /// In a view with many crossings to remove a whole throw may slide along the thread through another: the same knot in another order.
  /// So the plainest view decides about the order; a view that gives another knot contradicts it.
  static void note(const KnotWord& word, int excess, KnotFindings& found) {
    const double number = word.number();
    const KnotInvariants says = invariants_of(word);
    if (number < 0 || word.invariants != says) return;
    const bool first = found.agreed == 0, same = !first && number == found.word;
    if (!first && !same) {
      KnotWord before;
      tell(found, before);
      if (before.invariants != says || excess == found.excess) found.contradicted = 1;
    }
    if (same) found.agreed += 1;
    const double taken = thread_taken(word);
    const bool nearer = same && excess == found.excess && taken < found.taken;
    if (!first && !nearer && excess >= found.excess) return;
    if (!same) found.word = number, found.agreed = 1;
    found.taken = taken;
    found.excess = excess, found.throws = word.throws, found.knots = word.knots;
    for (int i = 0; i < word.throws; ++i) {
      const KnotThrow& t = word.tied[at(i)];
      const auto &a = t.strand[0], &b = t.strand[1];
      found.tied[at(i)] = {double(t.turns), double(t.sign), double(t.knot), {a.first, a.last, b.first, b.last}};
    }
  }
  /// A loop whose legs cross far from its throw may be seen as a part of that: the throw then takes all the thread between.
  static double thread_taken(const KnotWord& word) {
    double sum = 0;
    for (int i = 0; i < word.throws; ++i)
      for (const KnotThrow::Strand& strand : word.tied[at(i)].strand) sum += strand.last - strand.first;
    return sum;
  }
  static void tell(const KnotFindings& found, KnotWord& word) {
    word = {};
    word.throws = static_cast<int>(found.throws), word.knots = static_cast<int>(found.knots);
    for (int i = 0; i < word.throws; ++i) {
      const auto& t = found.tied[at(i)];
      word.tied[at(i)] = {int(t.turns), int(t.sign), int(t.knot), {{t.strand[0], t.strand[1]}, {t.strand[2], t.strand[3]}}};
    }
    word.invariants = invariants_of(word);
  }

  KnotEye eye_;
  KnotDiagram diagram_;
  KnotStrand strand_;
};

}  // namespace swage::toolkit
