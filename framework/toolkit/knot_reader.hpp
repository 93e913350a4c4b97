// SPDX-License-Identifier: Apache-2.0
//
// Names the knot in a thread: straightened a little, and wholly where that is not enough (knot_thread.hpp), seen from several directions (knot_eye.hpp), each view reduced
// (knot_strand.hpp) and read (knot_word.hpp). A name is certain when two views in a row give the same word, and determinant and
// signature are those of that word. Reading goes in slices: so much work a call. Header-only.
//
//   thread.begin(nodes, n);
//   while (!reader.read(thread, 500, name)) ...   // one call a step
//
// Threads: [rt], nothing allocates; the reader is scratch, the thread keeps what lasts.
#pragma once

#include "toolkit/knot_eye.hpp"
#include "toolkit/knot_strand.hpp"
#include "toolkit/knot_word.hpp"

namespace swage::toolkit {

struct KnotName {
  KnotWord word;
  bool certain = false;
};

class KnotReader {
 public:
  static constexpr int kFirstViews = 6;  // of a thread that has been straightened a little
  static constexpr int kViews = 30;

  /// Goes on by about `work` tests of pieces with pieces, or by one view. True when there is a name; an uncertain one when no two
  /// views agree.
  bool read(KnotThread& thread, int work, KnotName& name) {
    if (!thread.straighten(work)) return false;
    const int k = static_cast<int>(thread.view);
    thread.view += 1;
    if (k == kFirstViews) return thread.go_on(), false;
    if (eye_.look(thread, view(k), diagram_) != KnotSight::kSound) return thread.view >= kViews;
    strand_.reduce(diagram_);
    name.word = KnotReading::read(diagram_);
    const double number = name.word.number();
    const bool sound = number >= 0 && name.word.invariants == invariants_of(name.word);
    name.certain = sound && thread.word == number;
    thread.word = sound ? number : -1;
    return name.certain || thread.view >= kViews;
  }
  /// The last view, reduced.
  const KnotDiagram& diagram() const { return diagram_; }

  static KnotView view(int k) {
    constexpr int slant[8][2] = {{1, 2}, {-2, 1}, {3, -1}, {-1, -3}, {4, 3}, {-3, 5}, {5, -4}, {-5, -2}};
    return {k % 3, slant[k / 3 % 8][0], slant[k / 3 % 8][1]};
  }

 private:
  KnotEye eye_;
  KnotDiagram diagram_;
  KnotStrand strand_;
};

}  // namespace swage::toolkit
