// SPDX-License-Identifier: Apache-2.0
//
// swage.coupling.swage: an end of a thread is swaged into the blunt end of a needle. Model and limits: coupling_swage.md.
#pragma once

#include <swage/coupling.hpp>
#include <swage/strand.hpp>

#include "toolkit/math.hpp"

namespace swage::coupling_swage {

using toolkit::Vec3;

enum class End : int { kFirst, kLast };

struct SwageParams {
  End end = End::kFirst;
  double depth = 0.25e-3;   // m
  double stiffness = 1e5;   // N/m
  double strength = 0;      // N
  double friction = 0.2;
  double touch = 1e5;       // N/m
};

/// The private state of the coupling.
struct SwageState {
  double off;        // 1: pulled out, or never swaged in
  double over;       // 1: in the last step the pull was above the strength
  double turn[2];    // cosine and sine, from the needle's normal to the thread's about the needle's tangent at its blunt end
  double f[3], m[3]; // N and N m about the mouth, W: force and moment of the thread on the needle in the last step
};

/// Place and directions of the joint of needle and thread, in W.
struct Joint {
  Vec3 mouth, out;                // m, mouth of the needle's hole; unit, out of the needle along its hole
  Vec3 up;                        // unit, fixed to the needle and perpendicular to `out`: required direction of the thread's normal
  Vec3 thread_mouth, thread_end;  // m, places of the thread's material that belong to the mouth and to the bottom of the hole
  Vec3 thread_up;                 // unit, present normal of the thread at the mouth
  double radius = 0;              // m, of the thread
  uint32_t needle_body = 0, thread_body = 0;
};

class Swage final : public Coupling<SwageParams>, public Ties {
 public:
  static constexpr auto id = "swage.coupling.swage";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Swage";
  static constexpr auto summary =
      "A thread's end sits in the hole of a needle's blunt end: place, direction and turn are held, until it is pulled "
      "harder than the swage bears. Beside it needle and thread touch.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";
  static constexpr std::array needs_a{SWAGE_TRAIT_PIERCING, SWAGE_TRAIT_GRASPABLE};
  static constexpr std::array needs_b{SWAGE_TRAIT_STRAND};
  static constexpr bool detects = true;

  static constexpr const char* kEnds[] = {"first", "last", nullptr};
  static constexpr std::array fields = {
      choice<&SwageParams::end>("end", "End", kEnds, "Which end of the thread is in the needle."),
      real<&SwageParams::depth>("depth", "Depth", "m", "mm", 0.02e-3, 3e-3,
                                "How far the thread goes into the needle. Half a segment of the thread is best."),
      real<&SwageParams::stiffness>("stiffness", "Stiffness", "N/m", "N/m", 1e2, 1e7,
                                    "Of the thread in its hole. 1e5 N/m: 1 um under 0.1 N. Softer: the thread leaves its hole as it "
                                    "is pulled.")
          .hidden(),
      real<&SwageParams::strength>("strength", "Pull-off strength", "N", "mN", 0, 100,
                                   "Pull that draws the thread out of the needle. 0: as the thread says."),
      real<&SwageParams::friction>("friction", "Friction", "1", "1", 0, 3, "Coulomb coefficient where needle and thread touch."),
      real<&SwageParams::touch>("touch", "Contact stiffness", "N/m", "N/m", 1, 3e7, "Normal force per overlap where they touch.")
          .hidden(),
  };

  void build(const SwageParams& params, CouplingBuilder& builder) override;
  void bind(const Peer& a, const Peer& b) override;
  void reset(const CouplingStep& step) override;
  void resolve(const CouplingStep& step) override;
  uint32_t ties(const CouplingStep& step, std::span<swage_tie> out) override;
  void on_solved(const CouplingStep& step, std::span<const swage_tie> ties) override;
  void finish(const CouplingStep& step) override;

 private:
  bool find(const CouplingStep& step, const SwageState& state, Joint& joint) const;
  bool meet(const CouplingStep& step, SwageState& state) const;

  SwageParams params_;
  Peer needle_;
  StrandPeer thread_;
  Signal tension_, angle_, moment_, attached_;
  Event pulled_off_;
};

}  // namespace swage::coupling_swage
