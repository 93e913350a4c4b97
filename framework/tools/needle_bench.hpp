// SPDX-License-Identifier: Apache-2.0
//
// The needle bench: the bending test of ASTM F1874-98 (clamp two thirds of the way back from the point, bend by a right angle,
// report yield moment and maximum moment), a squeeze between flat jaws, reverse bending until break. Each figure is compared with its
// closed form, for the needle of the simulation (joints) and for the reference (strips). [main]
#pragma once

#include <string>
#include <vector>

#include "toolkit/wire_arm.hpp"

namespace swage::tools {

/// Data of a needle for the bench: a file of the library (format swage-needle/1).
struct NeedleModel {
  std::string file, name;
  double share = 0.375;    // of a full circle
  double size = 5e-3;      // m
  bool chord = true;       // size is the chord; false: the arc length
  double diameter = 1e-4;  // m
  int sourced = 0, assumed = 0;
  toolkit::WireMaterial material;

  double length() const;  // m, of the arc
  double arm() const;     // m, from the clamp to the point, straight
};

/// Reads a file; "" or its fault.
std::string read_needle(const std::string& path, NeedleModel& out);

/// One figure. Errors are relative to the closed form.
struct NeedleFigure {
  std::string name, unit;
  double scale = 1;  // factor to the unit for printing
  double closed_form = 0, bending = 0, reference = 0;
  double bending_error() const { return bending / closed_form - 1; }
  double reference_error() const { return reference / closed_form - 1; }
};

/// Runs the bench. pieces: of the whole needle in the simulation; width: m, of the flat jaws.
std::vector<NeedleFigure> bench_needle(const NeedleModel& needle, int pieces, double width);

}  // namespace swage::tools
