// SPDX-License-Identifier: Apache-2.0
//
// @ID@: a ball on a spring.
#pragma once

#include <swage/object.hpp>

struct @NAME@Params {
  double radius = 0.5e-3;     // m
  double mass = 4e-6;         // kg
  double stiffness = 0.04;    // N/m, swings 16 times a second
  double damping = 4e-5;      // N s/m, a twentieth of critical
};

class @NAME@ final : public swage::Object<@NAME@Params>, public swage::Solid, public swage::Drawing {
 public:
  static constexpr auto id = "@ID@";
  static constexpr auto version = "0.1.0";
  static constexpr auto name = "@TITLE@";
  static constexpr auto summary = "A ball on a spring.";
  static constexpr auto author = "Somebody";
  static constexpr auto licence = "Apache-2.0";

  // the parameters: checked by the host before build() sees them, shown as a form to instructors
  static constexpr std::array fields = {
      swage::real<&@NAME@Params::radius>("radius", "Radius", "m", "mm", 0.01e-3, 10e-3, "Of the ball."),
      swage::real<&@NAME@Params::mass>("mass", "Mass", "kg", "mg", 1e-9, 1e-2, "Of the ball, evenly spread."),
      swage::real<&@NAME@Params::stiffness>("stiffness", "Stiffness", "N/m", "N/m", 0, 1e3, "Of the spring.").live(),
      swage::real<&@NAME@Params::damping>("damping", "Damping", "N*s/m", "N*s/m", 0, 1, "Of the spring.").live(),
  };

  void build(const @NAME@Params& params, Builder& builder) override;
  void forces(const swage::Step& step) override;
  void finish(const swage::Step& step) override;
  void reset(const swage::Step& step) override;
  void draw(const swage::Step& step, swage::Visuals& out) override;

 private:
  // private numbers of the instance: doubles that the host keeps, saves and restores
  struct State {
    swage_vec3 rest;  // m, in W: position at which the spring is without force
  };

  swage::Body ball_;
  swage::Signal stretch_;
};
