// SPDX-License-Identifier: Apache-2.0
//
// swage.coupling.pull_through: a thread that a needle has drawn into tissue: the tissue holds it at entry and exit, and it drags, cuts and
// saws. Model and limits: coupling_pull_through.md.
#pragma once

#include <swage/coupling.hpp>
#include <swage/units.hpp>

#include <algorithm>
#include <optional>

#include "passage.hpp"

namespace swage::coupling_pull_through {

enum class Leads : int { kFirst, kLast };
enum class Starts : int { kOutside, kThrough };
enum class Tells : int { kAll, kStitches };

struct PullThroughParams {
  Leads leads = Leads::kFirst;
  Starts starts = Starts::kOutside;
  double drag = 1;             // N/m
  double friction = 0.2;
  double saw = 0.02;           // 1
  double in_from = 0.1e-3;     // m
  double cut_from = 0.2e-3;    // m
  int bites = 1;
  Tells tells = Tells::kAll;
};

inline constexpr int kMostBites = 4;

/// The private state of the coupling.
struct PullThroughState {
  Passage bite[kMostBites];               // the bite nearest to the leading end first
  double bites;                           // number of bites in the tissue
  double told;                            // 1: pull.has_cut was sent
  double told_out;                        // 1: pull.came_out was sent for the first bite
  double cut, back;                       // m, longest cut of a hole so far; m, thread length drawn back so far
  double drag_along, force[3], lateral;  // N, of the last step
  double began_s;                         // s, when the thread was laid where it starts: at the start, or when it was put back

  int count() const { return static_cast<int>(bites); }
  /// m, length of thread between bite `b` and the one before it, or the other end of the thread, whose length is `length` [m].
  double loop(int b, double length) const {
    const double before = b + 1 < count() ? bite[b + 1].hole[bite[b + 1].holes() - 1].u : length;
    return std::max(0.0, before - bite[b].hole[0].u);
  }
  uint32_t holes() const {
    uint32_t n = 0;
    for (int i = 0; i < count(); ++i) n += bite[i].holes();
    return n;
  }
};

class PullThrough final : public Coupling<PullThroughParams>, public Ties, public DrawingOnB {
 public:
  static constexpr auto id = "swage.coupling.pull_through";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Pull through";
  static constexpr auto summary =
      "A thread follows its needle through tissue: held sideways where it goes in and comes out, dragged along its "
      "way, and cutting where it is pulled hard or sawn.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";
  static constexpr std::array needs_a{SWAGE_TRAIT_STRAND, SWAGE_TRAIT_SOLID};
  static constexpr std::array needs_b{SWAGE_TRAIT_PIERCEABLE};
  static constexpr bool detects = true;

  static constexpr const char* kLeads[] = {"first", "last", nullptr};
  static constexpr const char* kStarts[] = {"outside", "through", nullptr};
  static constexpr const char* kTells[] = {"all", "stitches", nullptr};
  static constexpr std::array fields = {
      choice<&PullThroughParams::leads>("leads", "Leading end", kLeads, "Which end of the thread the needle draws in."),
      choice<&PullThroughParams::starts>("starts", "Starts", kStarts,
                                         "Outside, or lying through the tissue already as the thread's start shape does: the needle is gone."),
      real<&PullThroughParams::drag>("drag", "Drag", "N/m", "N/m", 0, 1e4,
                                     "Against the thread, per length inside, before anything bears on its side."),
      real<&PullThroughParams::friction>("friction", "Friction", "1", "1", 0, 3,
                                         "Coulomb coefficient, inside and on the surface."),
      real<&PullThroughParams::saw>("saw", "Sawing", "1", "1", 0, 10,
                                    "Way that a hole is cut per way that the thread slides in it, where it bears what tears at "
                                    "once; in proportion below."),
      real<&PullThroughParams::in_from>("in_from", "In from", "m", "mm", 1e-6, 5e-3,
                                        "So deep the leading end must be before it is in: deeper than a needle dents the surface.")
          .hidden(),
      real<&PullThroughParams::cut_from>("cut_from", "Cut from", "m", "mm", 1e-6, 10e-3,
                                         "A hole cut by more than this sends the event pull.has_cut."),
      integer<&PullThroughParams::bites>("bites", "Bites", 1, kMostBites,
                                         "So often at most the thread goes through the tissue at once: 1 a single stitch, more a running suture."),
      choice<&PullThroughParams::tells>("tells", "Tells", kTells,
                                        "Which signals there are: all but pull.drawn; or for single stitches with one thread, in a scene that has no "
                                        "room for all, pull.drawn in the place of pull.drag, pull.lateral, pull.bites and those of loops."),
  };

  void build(const PullThroughParams& params, CouplingBuilder& builder) override;
  void bind(const Peer& a, const Peer& b) override;
  void reset(const CouplingStep& step) override;
  void resolve(const CouplingStep& step) override;
  uint32_t ties(const CouplingStep& step, std::span<swage_tie> out) override;
  void on_solved(const CouplingStep& step, std::span<const swage_tie> ties) override;
  void finish(const CouplingStep& step) override;
  void draw(const CouplingStep& step, Visuals& out) override;

 private:
  Site site(const CouplingStep& step) const {
    return {thread_, tissue_, step.a(), step.b(), params_.leads == Leads::kLast};
  }
  void declare_loops(CouplingBuilder& builder);
  PassageLaw law(const Site& site) const;
  bool passes(const Site& site, const PullThroughState& state, const swage_contact& contact) const;
  void follow_end(const CouplingStep& step, const Site& site, PullThroughState& state) const;
  void follow_bites(const CouplingStep& step, const Site& site, PullThroughState& state) const;
  bool may_begin(const Site& site, const PullThroughState& state) const;
  void tell(const CouplingStep& step, const Site& site, const PullThroughState& state) const;

  PullThroughParams params_;
  StrandPeer thread_;
  Peer tissue_;
  Signal drawn_, state_, tail_, out_, inside_, drag_, force_, lateral_, tension_tail_, tension_out_, cut_, back_, bites_, loop_, loop_least_, loop_most_;
  Event in_, came_out_, back_out_, through_, cut_event_;
};

}  // namespace swage::coupling_pull_through
