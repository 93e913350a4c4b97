// SPDX-License-Identifier: Apache-2.0
//
// Design of a needle: its shape, its wire along the length, its material. All numbers SI.
#pragma once

#include <string>

#include "arc.hpp"
#include "toolkit/wire_section.hpp"

namespace swage::needle {

/// A needle of a manufacturer, or one that a lesson defines. Defaults are the reference needle: 3/8 circle, 5 mm
/// chord, 100 um.
struct Form {
  double share = 0.375;           // of a full circle
  bool chord = true;              // `size` is the chord; else the length of the arc
  double size = 5e-3;             // m
  double wire_diameter = 0.1e-3;  // m
  double taper_length = 0;        // m from the point, over which the wire grows from point_diameter
  double point_diameter = 20e-6;  // m, at the point
  double flattening = 1;          // thickness in the plane over width, 0.3..1
  double swage_length = 0;        // m from the end, drilled for the thread
  double swage_hole = 0.5;        // diameter of the hole over that of the wire
  toolkit::WireMaterial material;

  Arc arc() const {
    const double sweep = 2 * std::numbers::pi * share;
    return chord ? arc_of_chord(sweep, size, 0.5 * wire_diameter)
                 : arc_of_length(sweep, size, 0.5 * wire_diameter);
  }
  bool uniform() const { return taper_length <= 0 && swage_length <= 0; }

  /// Section at s (0 point .. 1 swage) of a needle `length` [m] long.
  toolkit::WireSection section(double s, double length) const {
    double d = wire_diameter;
    if (s * length < taper_length)
      d = point_diameter + (wire_diameter - point_diameter) * s * length / taper_length;
    const bool drilled = (1 - s) * length < swage_length;
    return toolkit::wire_section(d, flattening, drilled ? swage_hole : 0, material);
  }
};

/// Mass of the stretch from s0 to s1: as mass_of(Arc), in slices where the section changes. Flattening is neglected: it keeps
/// the area and shifts mass by less than the wire's thickness.
ArcMass mass_of(const Form& form, double s0 = 0, double s1 = 1);

/// "" or the reason why such a needle cannot be made.
std::string fault(const Form& form);

/// Reads a library entry (format "swage-needle/1", resources/needles) into `form`. Returns "" or the fault.
std::string read_model(const std::string& path, Form& form);

}  // namespace swage::needle
