// SPDX-License-Identifier: Apache-2.0
//
// Names the knot in a thread: straightened a little, and fully where that is not enough (thread.hpp), seen from several
// directions (eye.hpp), each view reduced (strand.hpp) and read (word.hpp). A view that is read as a word proves the knot, up to the order of
// its throws. The order is that of the plainest view, from which the fewest crossings were removed. A name is certain when two views or more
// give the same word, the plainest among them and no other as plain, and determinant and signature are those of that word. A view that
// cannot be reduced to a word proves nothing. A thread is tangled when no word has the determinant and signature of its views; where some word
// has them and no view is read as one, that is told as `unread`, and the caller decides how often. Of the views that give the word the one in
// which the throws take the least thread locates them, a plain one before others. Reading is done in slices of bounded work per call. Header-only.
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
  bool tangled = false;  // proved: no throws make a knot with these invariants
  bool unread = false;   // no view was read as a word, though some word has these invariants
};

class KnotReader {
 public:
  static constexpr int kFirstViews = 12;  // views of a thread that has been straightened a little; all are used
  static constexpr double kMostFactored = 1e6;  // twelve throws have up to 3^12; a greater determinant is not tried for factors
  /// nodes, of the thread in a tight throw of one turn. Smaller: throws are located in views with many removed crossings, and flat ones are told
  /// as sliding. Greater: only in the plainest view, where the legs of the loop may count as a part of the first throw.
  static constexpr double kNodesOfCrossing = 6;
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
    name.certain = found.agreed >= 2 && found.contradicted == 0 && found.excess < found.rival;
    const bool unread = found.word < 0 && found.contradicted == 0;
    name.tangled = unread && found.determinant > 0 && !throws_make(found.determinant, -found.signature);
    name.unread = unread && !name.tangled;
    if (k + 1 < kFirstViews || (!name.certain && !name.tangled && k + 1 < kViews)) return false;
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
  /// Whether throws, factors 2 n + 1 of the determinant from `least` on, have the sum `turned` of 2 n with the signs of their turns.
  static bool throws_make(double determinant, double turned, double least = 3) {
    if (determinant == 1) return turned == 0;
    if (determinant > kMostFactored) return true;  // not looked for: nothing is proved
    for (double f = least; f <= determinant; f += 2) {
      if (f * f > determinant) f = determinant;
      if (std::fmod(determinant, f) != 0) continue;
      for (const double sign : {1.0, -1.0})
        if (throws_make(determinant / f, turned - sign * (f - 1), f)) return true;
    }
    return false;
  }
  /// In a view with many crossings to remove a whole throw may slide along the thread through another: the same knot in another order.
  /// So the plainest view decides about the order.
  static void note(const KnotWord& word, int excess, KnotFindings& found) {
    if (word.invariants.known) {
      const double determinant = static_cast<double>(word.invariants.determinant), signature = word.invariants.signature;
      if (found.determinant == 0) found.determinant = determinant, found.signature = signature;
      if (found.determinant != determinant || found.signature != signature) found.contradicted = 1;
    }
    const double number = word.number();
    if (number < 0 || word.invariants != invariants_of(word)) return;
    if (found.agreed > 0 && number != found.word) {
      if (excess >= found.excess) return void(found.rival = std::min<double>(found.rival, excess));
      found.rival = found.excess;
      found.agreed = 0, found.taken = 1e9;
    }
    found.word = number, found.agreed += 1;
    found.excess = found.agreed == 1 ? excess : std::min<double>(found.excess, excess);
    locate(word, excess, found);
  }
  /// Takes the places of the throws from the view in which they take the least thread; each crossing that was removed counts as some of it.
  static void locate(const KnotWord& word, int excess, KnotFindings& found) {
    const double taken = thread_taken(word) + kNodesOfCrossing * excess;
    if (taken >= found.taken) return;
    found.taken = taken;
    found.throws = word.throws, found.knots = word.knots;
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
