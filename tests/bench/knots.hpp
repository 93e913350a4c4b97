// SPDX-License-Identifier: Apache-2.0
//
// swage-bench knots: which knots hold, over friction and pretension, by the pull test of tests/knots/pull.hpp.
#pragma once

#include <string>
#include <vector>

namespace swage::bench {

struct KnotsWanted {
  std::string out;    // folder of table and charts; "": none
  std::string only;   // knots whose name begins so
  double load = 0.1;  // N
  bool quick = false;  // one pretension, three frictions
  double yield = 0, hardening = 0;  // strain beyond which the thread stays bent, 0: never; share of its stiffness that is left there
  std::vector<double> pretensions, frictions;  // N, 1; none: those of the command
  std::string command;                         // as it was given, but for the folder
};

/// Prints a line for each pull; returns how many passed through themselves or were left unconverged in a tenth of their steps. Throws
/// std::runtime_error where there is no such knot or a file cannot be written.
int run_knots(const KnotsWanted& wanted);

}  // namespace swage::bench
