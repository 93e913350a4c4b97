// SPDX-License-Identifier: Apache-2.0
//
// swage.object.solids: plain bodies to practise on and to rest things on. Sizes and frames: solids.md.
#pragma once

#include <swage/object.hpp>

#include "toolkit/math.hpp"

namespace swage::solids {

enum class Form : int { kSphere, kCylinder, kBox, kSlot, kNest, kTray };

struct SolidParams {
  Form form = Form::kSphere;
  bool fixed = false;
  double diameter = 1e-3;                  // m
  double length = 3e-3;                    // m
  swage_vec3 size = {10e-3, 10e-3, 2e-3};  // m
  double gap = 0.08e-3;                    // m
  double bead = 0.5e-3;                    // m
  double density = 1000;                   // kg/m3
};

class SolidObject final : public Object<SolidParams>, public Solid, public Graspable {
 public:
  static constexpr auto id = "swage.object.solids";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Solid";
  static constexpr auto summary =
      "A rigid sphere or round-ended cylinder, free or fixed; or a fixed box, slot, nest of beads or tray.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";

  static constexpr const char* kForms[] = {"sphere", "cylinder", "box", "slot", "nest", "tray", nullptr};
  static constexpr std::array fields = {
      choice<&SolidParams::form>(
          "form", "Form", kForms,
          "Slot: two blocks with a gap between them. Nest: three beads in a ring on which round "
          "things come to rest. Tray: a floor with a rim. Only spheres and cylinders can be free."),
      boolean<&SolidParams::fixed>("fixed", "Fixed", "Does not move, whatever pushes it."),
      real<&SolidParams::diameter>(
          "diameter", "Diameter", "m", "mm", 10e-6, 0.2,
          "Of the sphere or cylinder; of the circle through the centres of a nest's beads."),
      real<&SolidParams::length>("length", "Length", "m", "mm", 10e-6, 0.2,
                                 "Of the cylinder, its round ends included."),
      vector<&SolidParams::size>("size", "Size", "m", "mm", 10e-6, 0.5,
                                 "Of the box, of each block of the slot, or of the inside of the tray."),
      real<&SolidParams::gap>("gap", "Gap", "m", "mm", 0, 0.05, "Between the blocks of the slot."),
      real<&SolidParams::bead>("bead", "Bead diameter", "m", "mm", 10e-6, 0.05, "Of the beads of the nest."),
      real<&SolidParams::density>("density", "Density", "kg/m3", "kg/m3", 1, 25000, "Of what is not fixed."),
  };

  void build(const SolidParams& params, ObjectBuilder& builder) override;
  void locate(const Step& step, swage_vec3 p_W, swage_graspable_place& out) override;

 private:
  Body add_body(const SolidParams& params, ObjectBuilder& builder) const;
  double length_ = 0;  // m, along the axis of a cylinder; 0 where there are no ends
  double extent_ = 0;  // m, told to graspers as the length
  Body body_;
};

}  // namespace swage::solids
