// SPDX-License-Identifier: Apache-2.0
//
// swage.coupling.knot: recognises the knot tied in a thread, throw by throw. It changes no contact. Model and limits: coupling_knot.md.
#pragma once

#include <swage/coupling.hpp>
#include <swage/strand.hpp>

#include "toolkit/knot/passage.hpp"
#include "toolkit/knot/reader.hpp"

namespace swage::coupling_knot {

inline constexpr int kMostPlaces = 401;  // of the thread that are looked at

struct KnotParams {
  int places = 201;
  double period = 16e-3;  // s
  double settle = 50e-3;  // s
  int work = 1500;
};

/// The state of the knot as reported.
struct KnotTold {
  static constexpr int kThrows = 6;
  double throws = 0;
  double tied[kThrows] = {};  // turns with their sign, the first throw first
  double tangled = 0;         // 1: knotted, but not by throws, which is proved; 2: no view was read for some time
  bool operator==(const KnotTold&) const = default;
};

/// A passage within a step, in nodes of the observed piece (toolkit/knot/passage.hpp).
struct KnotCrossed {
  double s = 0, other = 0, jump = 0;
};

/// The private state of the coupling.
struct KnotState {
  double places = 0, first = 0;  // of the piece that is observed: number of places, and the first; 0: not observed yet
  double reading = 0;            // 1 while the knot is being read
  double wait_s = 0;             // s, to the next reading
  KnotTold told, seen;           // as reported; as read last
  double seen_s = 0;             // s, time for which `seen` has been unchanged
  double unread = 0;  // readings in a row without a word, none of them proved to be no word
  double sliding = 0, certain = 1, passages = 0;
  static constexpr int kCrossed = 16;  // a snap through several strands and back is noted as some four; what is beyond counts at once
  double n_crossed = 0;
  KnotCrossed crossed[kCrossed];  // passages since the step began that were not undone
  double loop = 0;  // m, of thread between the two strands of the first throw
  double from = 0, to = 0;  // m from the first end: between these places all throws lie, with the loop
  double loosest = 0;       // m, of thread that one strand takes in the loosest throw
  double p_W[3 * toolkit::KnotPassages::kNodes] = {};  // m, places in the step before
  toolkit::KnotThread thread;
};

class Knot final : public Coupling<KnotParams> {
 public:
  static constexpr auto id = "swage.coupling.knot";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Knot";
  static constexpr auto summary =
      "Names what is tied in a thread, throw by throw with turns and sign; tells square from granny and flat from sliding, and notices "
      "when the thread goes through itself.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";
  static constexpr std::array needs_a{SWAGE_TRAIT_STRAND}, needs_b{SWAGE_TRAIT_STRAND};
  static constexpr bool detects = false;

  static constexpr std::array fields = {
      integer<&KnotParams::places>("places", "Places", 16, kMostPlaces,
                                   "Of the thread that are looked at, ends included; as many as it has nodes where these are more. One more "
                                   "than its segments, or than a multiple of them, sees it exactly as it is."),
      real<&KnotParams::period>("period", "Period", "s", "ms", 1e-3, 1, "From one reading to the next."),
      real<&KnotParams::settle>("settle", "Settling time", "s", "ms", 0, 1,
                                "A knot is told when it has been read so long without a change."),
      integer<&KnotParams::work>("work", "Work in a step", 100, 100000,
                                 "Tests of a piece of the thread with another that a reading may take in a step. 1500 are about 30 us.")
          .hidden(),
  };

  void build(const KnotParams& params, CouplingBuilder& builder) override;
  void bind(const Peer& a, const Peer& b) override;
  void reset(const CouplingStep& step) override;
  void resolve(const CouplingStep& step) override;
  void finish(const CouplingStep& step) override;

 private:
  void look(const CouplingStep& step, const KnotState& state);
  void find_passages(KnotState& state);
  static void note_passage(const toolkit::KnotPassage& passage, KnotState& state);
  void tell_passages(const CouplingStep& step, KnotState& state) const;
  void read(const CouplingStep& step, KnotState& state);
  void take(const toolkit::KnotName& said, KnotState& state) const;
  void take_places(toolkit::KnotWord word, KnotState& state) const;
  void tell(const CouplingStep& step, KnotState& state) const;
  void write(const CouplingStep& step, const KnotState& state) const;

  KnotParams params_;
  StrandPeer thread_;
  Signal throws_, tied_[KnotTold::kThrows], kind_, sliding_, loop_, from_, to_, loosest_, certain_, passages_;
  Event tied_event_, untied_event_, tangled_event_, passage_event_;

  // valid within the present step
  int places_ = 0, first_ = 0;
  double p_W_[3 * toolkit::KnotPassages::kNodes];
  uint32_t parted_[kMostPlaces];
  double length_ = 0, radius_ = 0;  // m
  toolkit::KnotPassages finder_;
  toolkit::KnotPassages::Found found_;
  toolkit::KnotReader reader_;
};

}  // namespace swage::coupling_knot
