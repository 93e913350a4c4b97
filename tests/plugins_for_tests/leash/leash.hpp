// SPDX-License-Identifier: Apache-2.0
//
// Ties the first body of one object to the first of another at three places, as they stand to each other at the start: a hand that
// never slips. With a strength it is a grip that lets go; with a stiffness of 0 it has let go. The example of the guide's part on ties.
#pragma once

#include <swage/coupling.hpp>
#include <swage/eigen.hpp>

#include <cmath>

namespace swage::test {

struct LeashParams {
  double stiffness = 2000;  // N/m, of each of the three
  double strength = 0;      // N, of each; 0: never lets go
  double arm = 2e-3;        // m, of the places about the body's origin
};

class Leash final : public swage::Coupling<LeashParams>, public swage::Ties {
 public:
  static constexpr auto id = "test.coupling.leash", version = "1.0.0", name = "Leash",
                        summary = "Ties two bodies to each other.", author = "Swage", licence = "Apache-2.0";
  static constexpr std::array<const char*, 0> needs_a{}, needs_b{};
  static constexpr bool detects = true;  // so that the pair is there; what touches passes through
  using P = LeashParams;
  static constexpr std::array fields = {
      swage::real<&P::stiffness>("stiffness", "Stiffness", "N/m", "N/m", 0, 1e6, "Of each of three ties.")
          .live(),
      swage::real<&P::strength>("strength", "Strength", "N", "N", 0, 1e3, "Of each; 0 is boundless."),
      swage::real<&P::arm>("arm", "Arm", "m", "mm", 1e-5, 0.1, "Of their places about the origin of b."),
  };

  void build(const P&, Builder& builder) override { builder.state<State>(); }
  void resolve(const swage::CouplingStep& step) override;
  uint32_t ties(const swage::CouplingStep& step, std::span<swage_tie> out) override;
  void on_solved(const swage::CouplingStep& step, std::span<const swage_tie> ties) override;

 private:
  // where the places are on both bodies while nothing pulls; 0 in `known` before the first step
  struct State {
    double known;
    swage_vec3 p_A[3], p_B[3];
  };
};

}  // namespace swage::test
