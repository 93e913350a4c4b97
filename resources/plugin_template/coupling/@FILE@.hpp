// SPDX-License-Identifier: Apache-2.0
//
// @ID@: a contact law between two solids that also reports when they begin and cease to touch.
#pragma once

#include <swage/coupling.hpp>

struct @NAME@Params {
  double friction = 0.4;     // Coulomb coefficient
  double stiffness = 500;    // N/m, normal, of the surfaces
};

class @NAME@ final : public swage::Coupling<@NAME@Params> {
 public:
  static constexpr auto id = "@ID@";
  static constexpr auto version = "0.1.0";
  static constexpr auto name = "@TITLE@";
  static constexpr auto summary = "Contact with friction between two solids, and how hard they press.";
  static constexpr auto author = "Somebody";
  static constexpr auto licence = "Apache-2.0";

  // traits that the two objects must offer; detects: the host finds their contacts for the solver
  static constexpr std::array needs_a = {SWAGE_TRAIT_SOLID};
  static constexpr std::array needs_b = {SWAGE_TRAIT_SOLID};
  static constexpr bool detects = true;

  static constexpr std::array fields = {
      swage::real<&@NAME@Params::friction>("friction", "Friction", "1", "1", 0, 5, "Coulomb coefficient.").live(),
      swage::real<&@NAME@Params::stiffness>("stiffness", "Stiffness", "N/m", "N/m", 1, 1e6, "Of the surfaces."),
  };

  void build(const @NAME@Params& params, Builder& builder) override;
  void resolve(const swage::CouplingStep& step) override;
  void finish(const swage::CouplingStep& step) override;
  void reset(const swage::CouplingStep& step) override;

 private:
  // private numbers of the instance: doubles that the host keeps, saves and restores
  struct State {
    double touching;  // 0 or 1
  };

  swage::Signal force_;
  swage::Event began_, ended_;
};
