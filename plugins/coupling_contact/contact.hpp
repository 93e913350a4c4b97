// SPDX-License-Identifier: Apache-2.0
//
// swage.coupling.contact: two solids that may touch, and the law of their surfaces. See coupling_contact.md.
#pragma once

#include <swage/coupling.hpp>

namespace swage::coupling_contact {

struct ContactParams {
  double friction = 0.3;
  double stiffness = 1e6;  // N/m
  double restitution = 0;
};

/// kg: upper limit of stiffness times the step squared. Usual: 1. A grasp of a needle of 0.4 mg holds up to 60 and breaks at 100 with
/// forces of hundreds of newtons, as rounding errors of the stiff contact reach the needle's weight.
inline constexpr double kMostPerStep = 30;

class Contact final : public Coupling<ContactParams> {
 public:
  static constexpr auto id = "swage.coupling.contact";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Contact";
  static constexpr auto summary =
      "Two solids touch: linear compliance, Coulomb friction, restitution; dry, no adhesion.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";
  static constexpr std::array needs_a{SWAGE_TRAIT_SOLID}, needs_b{SWAGE_TRAIT_SOLID};
  static constexpr bool detects = true;

  static constexpr std::array fields = {
      real<&ContactParams::friction>(
          "friction", "Friction", "1", "1", 0, 3,
          "Coulomb coefficient. Steel on steel about 0.3, silicone on steel about 0.8."),
      real<&ContactParams::stiffness>(
          "stiffness", "Stiffness", "N/m", "N/m", 1, 3e7,
          "Normal force per overlap of one touching place. A steel wire of 0.1 mm has about "
          "1e6, a soft pad about 1e3."),
      real<&ContactParams::restitution>("restitution", "Restitution", "1", "1", 0, 1,
                                        "Share of the speed of approach that is left after an impact."),
  };

  void build(const ContactParams& params, CouplingBuilder& builder) override;
  void activate(double dt_s) override;
  void resolve(const CouplingStep& step) override;
  void finish(const CouplingStep& step) override;

 private:
  ContactParams law_;
  Signal force_, overlap_;
};

}  // namespace swage::coupling_contact
