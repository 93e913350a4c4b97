// SPDX-License-Identifier: Apache-2.0
//
// swage.object.jaws: a needleholder with two hinged jaws and a force-limited handle. Frames and law:
// jaw_shape.hpp, jaws.md.
#pragma once

#include <swage/abi/device.h>
#include <swage/cut.hpp>
#include <swage/object.hpp>

#include "jaw_shape.hpp"

namespace swage::jaws {

struct JawsParams {
  JawShape shape = JawShape::kPrism;
  double reach = 10e-3;           // m
  double length = 6e-3;           // m
  double base_width = 1.5e-3;     // m
  double tip_width = 0.3e-3;      // m
  double thickness = 0.3e-3;      // m
  double opening = 18 * kDegree;  // rad
  double squeeze = 6 * kDegree;   // rad
  double max_grip = 2.0;          // N
  double handle_mass = 5e-3;      // kg
  double handle_ratio = 0.2;      // N at the tips per N at the handle
  double rest_closure = 0;        // 0..1
  bool blades = false;
  double shear = 0.6;             // N of closing force per N of a strand's strength, to cut it
};

class Jaws final : public Object<JawsParams>, public Solid, public Gripper, public Blades {
 public:
  static constexpr auto id = "swage.object.jaws";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Needleholder";
  static constexpr auto summary =
      "Two rigid triangular jaws on hinges, closed by a handle of limited force; the jaws themselves do not "
      "bend.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";

  static constexpr std::array traits{SWAGE_TRAIT_BLADES};

  static constexpr const char* kShapes[] = {"prism", "tetrahedron", nullptr};
  static constexpr std::array fields = {
      choice<&JawsParams::shape>(
          "shape", "Jaw shape", kShapes,
          "Prism: flat jaws of even thickness. Tetrahedron: sharp triangles with a ridge behind, "
          "8 planes and 12 edges for the pair."),
      real<&JawsParams::reach>("reach", "Hinge to tip", "m", "mm", 1e-3, 100e-3,
                               "Distance from the hinge axis to the tips."),
      real<&JawsParams::length>("length", "Jaw length", "m", "mm", 0.5e-3, 50e-3,
                                "Length of the gripping faces, from their base to the tip."),
      real<&JawsParams::base_width>("base_width", "Width at the base", "m", "mm", 0.05e-3, 10e-3,
                                    "Width of the gripping faces at their base."),
      real<&JawsParams::tip_width>(
          "tip_width", "Width at the tip", "m", "mm", 0, 5e-3,
          "Width of the gripping faces at the tip; 0 makes them sharp triangles. Prism only."),
      real<&JawsParams::thickness>("thickness", "Thickness", "m", "mm", 0.02e-3, 5e-3,
                                   "Of one jaw, at its base."),
      real<&JawsParams::opening>("opening", "Opening", "rad", "deg", 1 * kDegree, 90 * kDegree,
                                 "Angle between the jaws when the handle is released."),
      real<&JawsParams::max_grip>(
          "max_grip", "Greatest grip", "N", "N", 0.01, 50,
          "Force at the tips of closed jaws when the handle is fully squeezed. About 0.6 N holds a "
          "micro-needle well.")
          .group("Handle"),
      real<&JawsParams::squeeze>(
          "squeeze", "Squeeze past closed", "rad", "deg", 0.1 * kDegree, 30 * kDegree,
          "Angle that each jaw would still turn if the other were not there: a long way makes a "
          "soft handle.")
          .group("Handle"),
      real<&JawsParams::handle_mass>("handle_mass", "Moving mass", "kg", "g", 1e-5, 1,
                                     "Mass of one jaw and its half of the handle, as felt at the tip.")
          .group("Handle")
          .hidden(),
      real<&JawsParams::handle_ratio>("handle_ratio", "Tip force per handle force", "1", "1", 0.001, 10,
                                      "For devices that measure the force at the handle.")
          .group("Handle")
          .hidden(),
      real<&JawsParams::rest_closure>(
          "rest_closure", "Closure without a hand", "1", "1", 0, 1,
          "How far the handle is closed while no device says so: a clamp has about 0.8.")
          .group("Handle")
          .hidden(),
      boolean<&JawsParams::blades>("blades", "Blades", "Scissors: the jaws cut what a swage.coupling.cut has them cut.").group("Blades"),
      real<&JawsParams::shear>("shear", "Shear", "1", "1", 0.01, 100,
                               "Force with which the blades part a thread, over its strength: blunt ones need more.")
          .group("Blades"),
  };

  void build(const JawsParams& params, ObjectBuilder& builder) override;
  void forces(const Step& step) override;
  void finish(const Step& step) override;
  void describe(const Step& step, swage_gripper_state& out) override;
  void blades_law(const Step&, swage_blades_law& out) override { out.shear = blades_ ? shear_ : 0; }
  const void* extension(std::string_view wanted) override;

 private:
  void check(const JawsParams& params, ObjectBuilder& builder) const;
  void build_jaw(const JawsParams& params, ObjectBuilder& builder, bool left);
  double closure(const Step& step) const;
  double target(const Step& step) const;

  GripLaw law_;
  double handle_ratio_ = 0, rest_closure_ = 0, shear_ = 0;
  bool blades_ = false;
  Body tool_, jaw_[2];  // left, right
  Hinge hinge_[2];
  Signal opening_, command_;
};

}  // namespace swage::jaws
