// SPDX-License-Identifier: Apache-2.0
//
// swage.coupling.pierce: a needle and tissue: touch, puncture, track, exit, wound. Model and limits: coupling_pierce.md.
#pragma once

#include <swage/coupling.hpp>
#include <swage/units.hpp>

#include <optional>

#include "reaction.hpp"
#include "track.hpp"
#include "wound.hpp"

namespace swage::coupling_pierce {

enum class Sweep : int { kNeedle, kTissue };

struct PierceParams {
  Law law = Law::kNullZone;
  double null_angle = 15 * kDegree;                                                // rad
  double reaction = 60e-3;                                                         // N
  std::array<double, 4> table_angle{0, 15 * kDegree, 45 * kDegree, 90 * kDegree};  // rad
  std::array<double, 4> table_force{0, 0, 24e-3, 60e-3};                           // N
  double limit_angle = 80 * kDegree;                                               // rad
  double bluntness = 1;
  double exit_share = 0.7;
  Sweep sweep = Sweep::kNeedle;
  double torn_from = 1.5;
};

/// The private state of the coupling.
struct PierceState {
  static constexpr uint32_t kTracks = 2, kWounds = 8;
  static constexpr int kPointClears = 1, kEndClears = 2;  // which end of the needle
  Track track[kTracks];
  Wound wound[kWounds];
  double newest;                 // index of the track that the signals report
  double last_entry, last_exit;  // indices of the wounds that the signals report; -1: none
  double entries, deflections;
  double untouched_s;  // s, since the point last pressed on the surface
  double touching;     // 1: the point presses
  double peak;         // N, greatest normal force of this touch
  double peak_entry, peak_exit;
  double refused;                // rad, angle at which the point was refused in this touch; 0: it was not
  double refused_p[3];           // m, O, position of the point then
  double clearing;               // kPointClears, kEndClears, or both: that end has just come out, and its remaining overlap is no touch
  double swept;                  // m2
  double entry_p[3], exit_p[3];  // m, W

  bool clears(int end) const { return (static_cast<int>(clearing) & end) != 0; }
  void set_clearing(int end, bool on) {
    const int now = static_cast<int>(clearing);
    clearing = on ? now | end : now & ~end;
  }
};

/// Resultant of the contacts of the needle's point.
struct Press {
  double force = 0;               // N, normal
  Vec3 normal_W = Vec3::Zero();   // outward, unit when force > 0
  Vec3 surface_W = Vec3::Zero();  // m, on the undisturbed surface
};

class Pierce final : public Coupling<PierceParams>, public Ties, public DrawingOnB {
 public:
  static constexpr auto id = "swage.coupling.pierce";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Pierce";
  static constexpr auto summary =
      "A needle goes through tissue: dimple, puncture that depends on its angle, a track that holds it, "
      "exit, and the "
      "wound; it does not cut sideways.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";
  static constexpr std::array needs_a{SWAGE_TRAIT_PIERCING}, needs_b{SWAGE_TRAIT_PIERCEABLE};
  static constexpr bool detects = true;

  static constexpr const char* kLaws[] = {"null zone", "threshold", "quadratic", "table", nullptr};
  static constexpr const char* kSweeps[] = {"needle", "tissue", nullptr};
  static constexpr std::array fields = {
      choice<&PierceParams::law>(
          "law", "Reaction law", kLaws,
          "How the force that the point must bear grows with its angle to the inward normal."),
      real<&PierceParams::null_angle>("null_angle", "Null zone", "rad", "deg", 0, 80 * kDegree,
                                      "Angle below which there is no reaction."),
      real<&PierceParams::reaction>("reaction", "Reaction", "N", "mN", 0, 10, "At 90 deg."),
      vector<&PierceParams::table_angle>("table_angle", "Angles of the table", "rad", "deg", 0, 90 * kDegree,
                                         "Four angles, rising; law table only."),
      vector<&PierceParams::table_force>("table_force", "Forces of the table", "N", "mN", 0, 10,
                                         "The reaction at each; law table only."),
      real<&PierceParams::limit_angle>("limit_angle", "Limit angle", "rad", "deg", 1 * kDegree, 89 * kDegree,
                                       "From here on the point does not go in however hard it is pressed."),
      real<&PierceParams::bluntness>("bluntness", "Bluntness", "1", "1", 0.05, 20,
                                     "Puncture force over that of a new sharp point."),
      real<&PierceParams::exit_share>("exit_share", "Exit peak", "1", "1", 0, 5,
                                      "Force to break out through a surface, over the puncture force."),
      choice<&PierceParams::sweep>(
          "sweep", "Wound follows", kSweeps,
          "Needle: every way of the needle through the surface counts, as in the thesis. "
          "Tissue: only what gave way."),
      real<&PierceParams::torn_from>("torn_from", "Torn from", "1", "1", 1, 100,
                                     "Wound ratio above which the event pierce.torn is sent."),
  };

  void build(const PierceParams& params, CouplingBuilder& builder) override;
  void bind(const Peer& a, const Peer& b) override;
  void resolve(const CouplingStep& step) override;
  uint32_t ties(const CouplingStep& step, std::span<swage_tie> out) override;
  void on_solved(const CouplingStep& step, std::span<const swage_tie> ties) override;
  void finish(const CouplingStep& step) override;
  void reset(const CouplingStep& step) override;
  void draw(const CouplingStep& step, Visuals& out) override;

 private:
  bool passes(const PierceState& state, const Site& site, const swage_contact& contact, double s) const;
  Press press(const CouplingStep& step, const Site& site) const;
  double angle_of_point(const Site& site, const Vec3& normal_W) const;
  void touch(const CouplingStep& step, PierceState& state, const Site& site, const Press& press) const;
  void refuse(const CouplingStep& step, PierceState& state, const Site& site, const Press& press,
              double angle) const;
  void enter(const CouplingStep& step, PierceState& state, const Site& site, const Press& press,
             double angle) const;
  uint32_t wound_at(PierceState& state, const Vec3& p_O, const Vec3& n_O, const Vec3& along_O,
                    double radius) const;
  void go_on(const CouplingStep& step, PierceState& state, const Site& site, Track& track) const;
  void come_out(const CouplingStep& step, PierceState& state, const Site& site, Track& track) const;
  void close(PierceState& state, Track& track, int end) const;
  void tear(const CouplingStep& step, PierceState& state, const Site& site, uint32_t wound,
            const swage_piercing_place& place, const double* held_O) const;
  double filled_at(const PierceState& state, uint32_t wound) const;
  Pose plane_in_world(const PierceState& state, const Site& site, uint32_t wound) const;
  double angle_in(const Site& site, const Track& track, const PierceState& state) const;

  void declare(CouplingBuilder& builder);
  void declare_events(CouplingBuilder& builder);
  void tell(const CouplingStep& step, const PierceState& state, const Site& site, const Press& press) const;
  void tell_track(const CouplingStep& step, const PierceState& state, const Site& site,
                  const Press& press) const;
  void tell_wounds(const CouplingStep& step, const PierceState& state) const;
  void tell_place(const CouplingStep& step, const Signal (&signal)[3], const double* p_W) const;

  PierceParams params_;
  Reaction reaction_;
  Peer needle_, tissue_;

  // outlines that follow from the wounds of the state, computed anew where these differ
  mutable Outline settled_[PierceState::kWounds];

  // valid within one step: resolve() computes before_ for ties(), on_solved() computes after_ for finish()
  std::optional<Site> before_, after_;
  // valid from ties() to finish()
  struct Made {
    uint32_t track = 0, of = 0;
  };
  Made made_[PierceState::kTracks * Track::kTies];
  double along_ = 0, lateral_ = 0, pull_ = 0;  // N, of the newer track

  Signal state_, angle_, cosine_, force_, lateral_signal_, pull_signal_, peak_entry_, peak_exit_, s_, depth_,
      below_;
  Signal at_[3], entry_[3], exit_[3];
  Signal wound_, area_, area_ratio_, exit_wound_, exit_area_, swept_, entries_, deflections_, law_signal_,
      wound_wide_, exit_wide_;
  Event touched_, entered_, exited_, back_out_, passed_, deflected_, torn_, cut_out_;
};

}  // namespace swage::coupling_pierce
