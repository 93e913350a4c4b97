// SPDX-License-Identifier: Apache-2.0
//
// The bar: what Swage promises to hold, measured against closed forms and against peers in the same run.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "scenario.hpp"

namespace swage::bench {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kMicro = 1e6;  // um per m

/// One promise. Ratios are against a peer in the same run; a peer that is not installed leaves the line
/// unmeasured.
struct Line {
  std::string goal;  // "G1"
  std::string name;  // "grasped phase over ODE trimesh"
  std::string unit;  // "x", "um", "deg", "1"
  double measured = 0;
  double low = 0, high = 0;  // inclusive
  bool available = true;
  std::string note;

  bool held() const { return available && measured >= low && measured <= high; }
};

inline Line at_most(const char* goal, std::string name, const char* unit, double measured, double high,
                    std::string note = "") {
  return {goal, std::move(name), unit, measured, -kInfinity, high, true, std::move(note)};
}
inline Line within(const char* goal, std::string name, const char* unit, double measured, double low,
                   double high, std::string note = "") {
  return {goal, std::move(name), unit, measured, low, high, true, std::move(note)};
}
/// A count that must be zero.
inline Line none(const char* goal, std::string name, double count, std::string note = "") {
  return within(goal, std::move(name), "1", count, 0, 0, std::move(note));
}
/// A line whose peer is not installed.
inline Line unmeasured(const char* goal, std::string name, double high) {
  return {
      goal, std::move(name), "x", 0, -kInfinity, high, false, "peer not installed: scripts/setup.sh peer"};
}
/// Ours over theirs, both in ns.
Line ratio(const char* goal, std::string name, double ours, double theirs, double high);

struct Effort {
  double hold_seconds = 60;  // of S04 to S06
  int passes = 5;            // of timing runs, interleaved with the peers
  static Effort quick() { return {2, 3}; }
};

/// A group of lines of the bar, by the name that --only takes.
struct Goal {
  const char* name;
  std::vector<Line> (*measure)(const Effort&);
};
/// All, in the order of printing.
const std::vector<Goal>& goals();

std::vector<Line> bar_queries(const Effort&);    // G1
std::vector<Line> bar_swept(const Effort&);      // G7, speed
std::vector<Line> bar_units(const Effort&);      // S01
std::vector<Line> bar_table_61(const Effort&);   // the thesis's chain and tree
std::vector<Line> bar_table_62(const Effort&);   // the thesis's loop
std::vector<Line> bar_grasp(const Effort&);      // G2, S04 to S06
std::vector<Line> bar_pinch(const Effort&);      // G3
std::vector<Line> bar_slip(const Effort&);       // G3-slip, no times
std::vector<Line> bar_creep(const Effort&);      // grasp: 20 % more grip than the pull needs, and 20 % less
std::vector<Line> bar_free(const Effort&);       // G6
std::vector<Line> bar_tunnel(const Effort&);     // G7, accuracy
std::vector<Line> bar_shots(const Effort&);      // S46: thin things, from every side
std::vector<Line> bar_couple(const Effort&);     // S47: light needles beyond Coulomb's limit
std::vector<Line> bar_insertion(const Effort&);  // tissue: stays, energy, cost, force
std::vector<Line> bar_tissue(const Effort&);     // its mesh: off closed forms, build, memory
std::vector<Line> bar_needle(const Effort&);     // the needle that bends: cost, its bench, slip and creep
std::vector<Line> bar_thread(const Effort&);     // G4, G5, G8: a thread alone, held, and in the whole loop

}  // namespace swage::bench
