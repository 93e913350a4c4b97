// SPDX-License-Identifier: Apache-2.0
//
// swage.coupling.cut: blades cut a strand that they press between them. Model and limits: coupling_cut.md.
#pragma once

#include <swage/coupling.hpp>
#include <swage/cut.hpp>
#include <swage/strand.hpp>

namespace swage::coupling_cut {

struct CutParams {
  double friction = 0.2;
  double stiffness = 1e5;  // N/m
};

/// The private state of the coupling.
struct CutState {
  double cuts;    // number so far
  double closed;  // 1: the blades have cut and not opened since
  double opening;  // rad, between the blades when they cut
};

/// Forces and place of the contacts that press on the strand in one step.
struct Shear {
  double left = 0, right = 0;  // N, of each blade along the closing direction
  double weight = 0, s = 0;    // N, sum of the normal forces; m, mean place weighted by them
  double opening = 0;          // rad, between the blades

  double force() const;  // N, of the blade that presses with less force
};

class Cut final : public Coupling<CutParams> {
 public:
  static constexpr auto id = "swage.coupling.cut";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Cut";
  static constexpr auto summary =
      "Blades and a thread: they touch, and where both blades press harder than the thread bears across itself it is parted; "
      "whole or parted, no cut in between.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";
  static constexpr std::array needs_a{SWAGE_TRAIT_SOLID, SWAGE_TRAIT_GRIPPER, SWAGE_TRAIT_BLADES};
  static constexpr std::array needs_b{SWAGE_TRAIT_SOLID, SWAGE_TRAIT_STRAND, SWAGE_TRAIT_CUTTABLE};
  static constexpr bool detects = true;

  static constexpr std::array fields = {
      real<&CutParams::friction>("friction", "Friction", "1", "1", 0, 3, "Coulomb coefficient of blades and thread."),
      real<&CutParams::stiffness>("stiffness", "Stiffness", "N/m", "N/m", 1, 3e7, "Normal force per overlap of one touching place.")
          .hidden(),
  };

  void build(const CutParams& params, CouplingBuilder& builder) override;
  void bind(const Peer& a, const Peer& b) override;
  void reset(const CouplingStep& step) override { step.state<CutState>() = {}; }
  void resolve(const CouplingStep& step) override;
  void finish(const CouplingStep& step) override;

 private:
  bool gather(const CouplingStep& step, Shear& shear) const;

  CutParams params_;
  Peer jaws_;
  BladesPeer blades_;
  StrandPeer thread_;
  CuttablePeer cuttable_;
  Signal force_, cuts_;
  Event parted_;
};

}  // namespace swage::coupling_cut
