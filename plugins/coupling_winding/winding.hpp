// SPDX-License-Identifier: Apache-2.0
//
// swage.coupling.winding: number of turns of a thread about an instrument. It changes no contact. Model and limits: coupling_winding.md.
#pragma once

#include <swage/coupling.hpp>
#include <swage/strand.hpp>

#include "toolkit/knot/winding.hpp"

namespace swage::coupling_winding {

inline constexpr int kPlaces = 401;  // largest number of places of the thread that are observed

struct WindingParams {
  int places = 101;
  double reach = 6e-3;  // m
  double to = 1;        // share of the thread's length in which turns are counted
  double hinge = 10e-3;     // m, from the tips
  double inside = 0.15e-3;  // m, from a gripping face to the middle line of its jaw
};

/// Pose and opening of the jaws.
struct Jaws {
  double tip_W[3] = {}, axis_W[3] = {1, 0, 0}, closing_W[3] = {0, 0, 1};  // m, unit, unit
  double opening = 0;                                                     // rad
};

/// The private state of the coupling.
struct WindingState {
  double known = 0;             // 1: p_T holds the thread's last places, relative to `jaws`
  double whole = 0;             // reported whole turns, with their sign
  double passages = 0;
  Jaws jaws;                     // pose that they will have at the end of the step or substep
  double opening = 0;            // rad, that belongs to p_T
  double p_T[3 * kPlaces] = {};  // m, places in the tool's frame, whose origin is between the tips
};

class Winding final : public Coupling<WindingParams> {
 public:
  static constexpr auto id = "swage.coupling.winding";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Winding";
  static constexpr auto summary =
      "Counts how often a thread is wound about the tips of an instrument, with its sign, and notices when the thread goes through it.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";
  static constexpr std::array needs_a{SWAGE_TRAIT_GRIPPER}, needs_b{SWAGE_TRAIT_STRAND};
  static constexpr bool detects = false;

  static constexpr std::array fields = {
      integer<&WindingParams::places>("places", "Places", 16, kPlaces,
                                      "Of the thread that are looked at, ends included; as many as it has nodes where these are more. One more "
                                      "than its segments, or than a multiple of them, sees it exactly as it is."),
      real<&WindingParams::reach>("reach", "Reach", "m", "mm", 0.1e-3, 0.1, "Length of the instrument that counts, from its tips back."),
      real<&WindingParams::to>("to", "To", "1", "1", 0.05, 1,
                               "Share of the thread, from its first end, whose turns count: beyond is the tail behind the hand that holds it."),
      real<&WindingParams::hinge>("hinge", "Hinge", "m", "mm", 0.1e-3, 0.1, "Distance from the tips back to the hinge of the jaws."),
      real<&WindingParams::inside>("inside", "Inside", "m", "mm", 0, 5e-3,
                                   "Distance from a gripping face to the middle of its jaw: half of its thickness. What meets that has gone through the jaw."),
  };

  void build(const WindingParams& params, CouplingBuilder& builder) override;
  void bind(const Peer& a, const Peer& b) override;
  void reset(const CouplingStep& step) override;
  void resolve(const CouplingStep& step) override;
  void finish(const CouplingStep& step) override;

 private:
  bool look(const CouplingStep& step, const Jaws& jaws);
  bool go_on(const CouplingStep& step, WindingState& state);
  toolkit::Vec3 place(const double* of, int i) const { return Eigen::Map<const toolkit::Vec3>(of + 3 * i); }
  /// A jaw in the tool's frame: x axis on its middle line, origin at its tip.
  struct Jaw {
    double cosine, sine;    // of half the opening, signed by the side
    double length, inside;  // m, from the hinge to the tip; from the middle line to the inner face, signed by the side
  };
  /// side 1: left, -1: right.
  Jaw jaw(double opening, double side) const;
  toolkit::Vec3 in_jaw(const toolkit::Vec3& p_T, const Jaw& jaw) const;
  void find_passages(const CouplingStep& step, WindingState& state) const;
  void tell(const CouplingStep& step, WindingState& state, double turns) const;

  WindingParams params_;
  Peer tool_;
  StrandPeer thread_;
  Signal turns_, whole_, behind_, passages_;
  Event wound_, unwound_, passage_;

  // valid within the present step
  int last_ = 0;       // place up to which turns are counted
  double length_ = 0;  // m
  double p_T_[3 * kPlaces];
  uint32_t parted_[kPlaces];  // whether the thread is parted at each place, as line() tells it; not read here
};

}  // namespace swage::coupling_winding
