// SPDX-License-Identifier: Apache-2.0
//
// swage.object.solids: plain bodies to practise with and to rest objects on. Sizes and frames: solids.md.
#pragma once

#include <swage/environment.hpp>
#include <swage/object.hpp>

#include <string>
#include <vector>

#include "course.hpp"
#include "toolkit/math.hpp"

namespace swage::solids {

enum class Form : int { kSphere, kCylinder, kBox, kSlot, kNest, kTray, kRing, kWire };

struct SolidParams {
  Form form = Form::kSphere;
  bool fixed = false;
  double diameter = 1e-3;                  // m
  double length = 3e-3;                    // m
  swage_vec3 size = {10e-3, 10e-3, 2e-3};  // m
  double gap = 0.08e-3;                    // m
  double bead = 0.5e-3;                    // m
  double density = 1000;                   // kg/m3
  double wire_diameter = 0.2e-3;           // m
  std::string course = "2 mm, 60 deg at 2 mm, -120 deg at 2 mm, 60 deg at 2 mm, 2 mm";
};

class SolidObject final : public Object<SolidParams>, public Solid, public Graspable {
 public:
  static constexpr auto id = "swage.object.solids";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Solid";
  static constexpr auto summary =
      "A rigid sphere, round-ended cylinder or ring, free or fixed; or a fixed box, slot, nest of beads, tray or bent wire.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";

  static constexpr const char* kForms[] = {"sphere", "cylinder", "box", "slot", "nest", "tray", "ring", "wire", nullptr};
  static constexpr std::array fields = {
      choice<&SolidParams::form>(
          "form", "Form", kForms,
          "Slot: two blocks with a gap between them. Nest: three beads in a ring on which round "
          "things come to rest. Tray: a floor with a rim. Wire: straights and bends along its course. Only spheres, "
          "cylinders and rings can be free."),
      boolean<&SolidParams::fixed>("fixed", "Fixed", "Does not move, whatever pushes it."),
      real<&SolidParams::diameter>(
          "diameter", "Diameter", "m", "mm", 10e-6, 0.2,
          "Of the sphere or cylinder; of the ring's centre line; of the circle through the centres of a nest's beads."),
      real<&SolidParams::length>("length", "Length", "m", "mm", 10e-6, 0.2,
                                 "Of the cylinder, its round ends included."),
      vector<&SolidParams::size>("size", "Size", "m", "mm", 10e-6, 0.5,
                                 "Of the box, of each block of the slot, or of the inside of the tray."),
      real<&SolidParams::gap>("gap", "Gap", "m", "mm", 0, 0.05, "Between the blocks of the slot."),
      real<&SolidParams::bead>("bead", "Bead diameter", "m", "mm", 10e-6, 0.05, "Of the beads of the nest."),
      real<&SolidParams::density>("density", "Density", "kg/m3", "kg/m3", 1, 25000, "Of what is not fixed."),
      real<&SolidParams::wire_diameter>("wire_diameter", "Wire diameter", "m", "mm", 10e-6, 0.05,
                                        "Of the ring's and the bent wire's section."),
      text<&SolidParams::course>("course", "Course",
                                 "Of the bent wire, from its origin along x: lengths of straights, and bends to the "
                                 "left with their radius, with commas between them."),
  };

  void build(const SolidParams& params, ObjectBuilder& builder) override;
  void forces(const Step& step) override;
  void locate(const Step& step, swage_vec3 p_W, swage_graspable_place& out) override;

 private:
  Body add_body(const SolidParams& params, ObjectBuilder& builder) const;
  void check(const SolidParams& params, ObjectBuilder& builder);
  void add_wire(const SolidParams& params, ObjectBuilder& builder) const;
  void locate_on_wire(const toolkit::Vec3& p_B, toolkit::Vec3& at, toolkit::Vec3& tangent, double& s) const;
  double length_ = 0;  // m, along the axis of a cylinder; 0 for forms without ends
  double extent_ = 0;  // m, reported to graspers as the length
  double ring_ = 0;    // m, radius of a ring's centre line; 0: not a ring
  std::vector<Piece> wire_;
  // of a free solid in a fluid
  bool fixed_ = true;
  double density_ = 0, thickness_ = 0;  // kg/m3; m, diameter of the ball, the cylinder or the ring's wire
  swage_mass mass_{};
  swage_environment environment_{};
  Body body_;
};

}  // namespace swage::solids
