// SPDX-License-Identifier: Apache-2.0
//
// swage.object.needle: a rigid circular-arc needle of true micro size. The model and its limits are in
// needle.md.
#pragma once

#include <swage/object.hpp>

#include "arc.hpp"

namespace swage::needle {

enum class Circle : int { kQuarter, kThreeEighths, kHalf, kFiveEighths, kTwoEighths, kFourEighths };
enum class SizeOf : int { kChord, kLength };

struct NeedleParams {
  Circle arc = Circle::kThreeEighths;
  SizeOf size_of = SizeOf::kChord;
  double size = 5e-3;             // m
  double wire_diameter = 0.1e-3;  // m
  double density = 7900;          // kg/m3
};

class Needle final : public Object<NeedleParams>, public Solid, public Graspable {
 public:
  static constexpr auto id = "swage.object.needle";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Suture needle";
  static constexpr auto summary =
      "Rigid needle of round wire bent to a quarter to five eighths of a circle; it does not bend or break.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";

  static constexpr const char* kCircles[] = {"1/4", "3/8", "1/2", "5/8", "2/8", "4/8", nullptr};
  static constexpr const char* kSizes[] = {"chord", "length", nullptr};
  static constexpr std::array fields = {
      choice<&NeedleParams::arc>("arc", "Arc", kCircles, "Share of a full circle that the needle spans."),
      choice<&NeedleParams::size_of>(
          "size_of", "Size is the", kSizes,
          "What the size measures: the chord from point to swage, or the length of the arc."),
      real<&NeedleParams::size>("size", "Size", "m", "mm", 0.5e-3, 50e-3,
                                "Chord or length of the centre line."),
      real<&NeedleParams::wire_diameter>("wire_diameter", "Wire diameter", "m", "um", 20e-6, 1e-3,
                                         "Diameter of the round body. Micro-needles have 50 to 150 um."),
      real<&NeedleParams::density>("density", "Density", "kg/m3", "kg/m3", 100, 25000,
                                   "Of the wire. Surgical steel has 7700 to 8000 kg/m3.")
          .hidden(),
  };

  void build(const NeedleParams& params, ObjectBuilder& builder) override;
  void locate(const Step& step, swage_vec3 p_W, swage_graspable_place& out) override;

 private:
  Arc arc_;
  Vec3 centre_B_ = Vec3::Zero();  // of the circle, m
  Body body_;
};

}  // namespace swage::needle
