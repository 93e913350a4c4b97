// SPDX-License-Identifier: Apache-2.0
//
// swage.coupling.grasp: computes from the solved contacts how a gripper holds an object. It changes no contact. See
// coupling_grasp.md.
#pragma once

#include <swage/coupling.hpp>
#include <swage/wire.hpp>

#include "thesis.hpp"
#include "toolkit/math.hpp"

namespace swage::coupling_grasp {

using toolkit::Vec3;

/// Model of the grasp, from the simplest to the most accurate.
enum class Level : int { kThesis, kContact };

struct GraspParams {
  Level level = Level::kContact;
  double touch_force = 1e-3;  // N
  double balance = 0.1;
  double settle_time = 0.03;  // s
  double hard_force = 1.0;    // N
  double skin = 25e-6;        // m
};

/// The private state of the coupling.
struct GraspState {
  double held = 0;                       // 0 or 1
  double pending_s = 0;                  // s, time for which the contacts have contradicted `held`
  double touching = 0;                   // 0 or 1
  double untouched_s = 0;                // s, since the last touch
  double hard = 0;                       // 0 or 1
  double held_since_s = 0;               // s
  double s = 0;                          // coordinate along the object of the last contact
  double tip_reach = 0;                  // m
  double tilt_axis = 0, tilt_plane = 0;  // rad
};

/// Sums and means of the contacts of one step.
struct Pinch {
  double left = 0, right = 0;  // N, force of each jaw along the closing direction
  double roll_left = 0, roll_right = 0;  // N m, of each jaw's forces along the closing direction about the jaw axis
  double weight = 0;           // N, sum of the normal forces
  double s = 0;                // coordinate along the object, weighted by normal force
  double slip = 0;             // m/s, likewise
  Vec3 p_W = Vec3::Zero();     // m, on the centre line
  Vec3 tangent_W = Vec3::Zero(), normal_W = Vec3::Zero();

  double uneven = 1;  // imbalance of the forces, or of the penetrations: 0 for an even pinch, 1 for one jaw alone

  double force() const { return 0.5 * (left + right); }
  double couple() const;     // N m, with which the two jaws turn each other about their axis; 0 while one of them does not press
  double imbalance() const;  // |left - right| over the harder one
};

class Grasp final : public Coupling<GraspParams> {
 public:
  static constexpr auto id = "swage.coupling.grasp";
  static constexpr auto version = "1.1.0";
  static constexpr auto name = "Grasp";
  static constexpr auto summary =
      "Tells from the contact forces whether, where, how hard and how squarely a gripper holds a thing.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";
  static constexpr std::array needs_a{SWAGE_TRAIT_GRIPPER}, needs_b{SWAGE_TRAIT_GRASPABLE};
  static constexpr bool detects = false;

  static constexpr const char* kLevels[] = {"thesis", "contact", nullptr};
  static constexpr std::array fields = {
      choice<&GraspParams::level>("level", "Level", kLevels,
                                  "What decides whether and where it is held: the particle that both jaws "
                                  "enter deepest, as in the thesis, or "
                                  "the forces of the contacts."),
      real<&GraspParams::touch_force>("touch_force", "Touch from", "N", "mN", 1e-6, 1,
                                      "A jaw counts as touching above this force."),
      real<&GraspParams::balance>(
          "balance", "Balance", "1", "1", 0.001, 1,
          "Greatest difference between the two jaws, as a share of the harder one, that still "
          "counts as a grasp."),
      real<&GraspParams::settle_time>("settle_time", "Settling time", "s", "ms", 0, 1,
                                      "A grasp or its loss counts once it has lasted this long."),
      real<&GraspParams::hard_force>(
          "hard_force", "Too hard above", "N", "N", 1e-3, 100,
          "Above this grip force the event grasp.too_hard is sent; it can come again after "
          "the force has fallen below nine tenths of it."),
      real<&GraspParams::skin>(
          "skin", "Skin", "m", "um", 0, 1e-3,
          "Thesis only: from how far outside of the wire a jaw counts as inside a particle.")
          .hidden(),
  };

  void build(const GraspParams& params, CouplingBuilder& builder) override;
  void bind(const Peer& a, const Peer& b) override;
  void finish(const CouplingStep& step) override;
  void reset(const CouplingStep& step) override;

 private:
  bool gather(const CouplingStep& step, const swage_gripper_state& jaws, Pinch& pinch) const;
  bool choose_particle(const CouplingStep& step, const swage_gripper_state& jaws, Pinch& pinch) const;
  void follow_touch(const CouplingStep& step, GraspState& state, const Pinch& pinch) const;
  void follow_hold(const CouplingStep& step, GraspState& state, const Pinch& pinch) const;
  void follow_force(const CouplingStep& step, GraspState& state, const Pinch& pinch) const;
  void follow_wire(const CouplingStep& step) const;

  GraspParams params_;
  Peer gripper_, thing_;
  Signal held_, force_, left_, right_, s_, tip_reach_, tilt_axis_, tilt_plane_, balance_, slip_, roll_moment_;
  WirePeer wire_;
  Event touched_, taken_, released_, too_hard_, collapsed_, broke_;
};

}  // namespace swage::coupling_grasp
