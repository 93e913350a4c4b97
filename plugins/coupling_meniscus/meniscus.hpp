// SPDX-License-Identifier: Apache-2.0
//
// swage.coupling.meniscus: a thread adheres to wet surfaces. Model and limits: coupling_meniscus.md.
#pragma once

#include <swage/coupling.hpp>
#include <swage/environment.hpp>
#include <swage/strand.hpp>

#include "bridge.hpp"
#include "toolkit/math.hpp"

namespace swage::coupling_meniscus {

inline constexpr uint32_t kPlaces = 128;  // largest number of places of a thread: 30 mm every 0.25 mm
inline constexpr int kMostBridges = 48;   // of the 64 ties of a scene

struct MeniscusParams {
  double spacing = 0.4e-3;  // m
  int most = 24;
};

/// A place of the thread that may be wet. Plain doubles.
struct Place {
  double wet = 0;     // 1: a bridge holds it
  double body = 0;    // body index in the other object
  double p_B[3] = {}, n_B[3] = {};  // m, unit: where the place lay, and the surface normal there, in that body's frame
  double pull = 0;                  // N, of its bridge in the last step
};

/// The private state of the coupling.
struct MeniscusState {
  double served = 0, force = 0;  // bridges of this step; N, sum of their forces
  Place place[kPlaces];
};

class Meniscus final : public Coupling<MeniscusParams>, public Ties {
 public:
  static constexpr auto id = "swage.coupling.meniscus";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Meniscus";
  static constexpr auto summary =
      "In moist surroundings a film of liquid holds a thread to what it lies on, until it is peeled off. Nothing where the lesson is dry or under water.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";
  static constexpr std::array needs_a{SWAGE_TRAIT_STRAND}, needs_b{SWAGE_TRAIT_SOLID};
  static constexpr bool detects = false;

  static constexpr std::array fields = {
      real<&MeniscusParams::spacing>("spacing", "Spacing", "m", "mm", 0.05e-3, 5e-3,
                                     "Length of thread for which one bridge of liquid stands. Longer than a fifth of the elastocapillary "
                                     "length (2.4 mm of 10-0), the thread comes off in jerks."),
      integer<&MeniscusParams::most>("most", "Most bridges", 1, kMostBridges,
                                     "That bear at once. Those at the ends of what is wet go first: between them the thread lies still anyway.")
          .hidden(),
  };

  void build(const MeniscusParams& params, CouplingBuilder& builder) override;
  void bind(const Peer& a, const Peer& b) override;
  void reset(const CouplingStep& step) override;
  void resolve(const CouplingStep& step) override;
  uint32_t ties(const CouplingStep& step, std::span<swage_tie> out) override;
  void on_solved(const CouplingStep& step, std::span<const swage_tie> ties) override;
  void finish(const CouplingStep& step) override;

 private:
  bool moist() const { return environment_.surface_tension > 0; }
  double at(uint32_t place) const { return (place + 0.5) * params_.spacing; }
  uint32_t count(double length) const;
  /// Displacement of a place from where it lay [m], along the normal and across it.
  struct Lift {
    toolkit::Vec3 p_W, n_W;
    double up = 0, aside = 0;
    uint32_t body = 0;
    bool good = false;
  };
  Lift lift(const CouplingStep& step, const swage_strand_law& law, const Place& place, double s) const;

  MeniscusParams params_;
  uint32_t bridge_[kMostBridges] = {};  // place of each tie of this step
  swage_environment environment_{};
  StrandPeer thread_;
  Signal force_, wet_, left_out_;
};

}  // namespace swage::coupling_meniscus
