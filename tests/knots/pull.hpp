// SPDX-License-Identifier: Apache-2.0
//
// Pull test of a knot in 10-0 nylon, as a tensile machine does it with a loop that has been cut open: a loosely laid tie of a known
// word is drawn tight by its two tails and its two legs (the loop's halves); then its tails are let go and it is pulled apart by its legs.
//
//     tail   \       /  tail       tighten: all four are drawn outward until each bears the pretension
//             [knots]              rest:    legs keep it, as tissue that gapes does; tails give way and are let go
//     leg  __/       \__  leg      pull:    legs go outward at a speed until they bear the load, which they then keep
//
// Bodies: one thread of segments about as long as it is thick (dynamics/rod_body.hpp), that touches itself, in the host's own detector and
// solver; no plugins. Units SI. Threads: [main].
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ties.hpp"

namespace swage::test {

struct PullTest {
  Word word{1, -1};
  double friction = 0.3;
  double tying_friction = 0.05;  // at most so much while it is drawn tight, so that inner throws are drawn tight too
  double pretension = 10e-3;  // N
  double load = 0.1;          // N; more than `strength`: to breaking; 0: it is not pulled
  // of 10-0 nylon, as resources/threads has it
  double diameter = 22e-6, young = 2.5e9, poisson = 0.39, density = 1140, strength = 0.19;
  double yield = 0, hardening = 0;  // strain at which it begins to stay bent, and the share of its stiffness left there; 0: it is elastic
  double stiffness = 5e4;    // N/m, of a contact of the thread with itself. 1e4: tight loops cut through each other at 20 mN
  double segment = 22e-6;    // m
  double unit = 55e-6;       // m, radius of the throws as they are laid: 2.5 diameters
  double tail = 20;          // units
  TieShape shape;            // how it is laid, but for its tail
  double legs = 1;           // share of the pretension that the legs bear while it is drawn tight
  double winds = 1;          // share of it that the strand bears that goes about the straight one of a sliding knot
  double oil = 1e4, thins = 0.1;  // Pa s, s: what it lies in at first, and the time in which that falls to a third
  double draw_for = 0;       // s, after which it is taken as it is; 0: only once all four bear what they should
  double tighten_speed = 3e-3, pull_speed = 2e-3;  // m/s, of each end
  double keep = 0.2;         // s, for which the load is kept
  double dt = 1e-3;          // s
  double margin = 5e-6;      // m, within which contacts are looked for
};

enum class PullEnd { kHolds, kSlips, kBreaks, kNotTight };
const char* text(PullEnd);

/// Of one phase.
struct PullPhase {
  int steps = 0;
  uint64_t not_converged = 0;
  uint64_t directions = 0;     // search directions of the solver
  int passages = 0;            // of thread through thread
  size_t contacts = 0, bearing = 0;  // most of a step: looked at, and with force
  double median_us = 0, p999_us = 0, most_us = 0;  // processor time of a step
};

struct PullResult {
  PullEnd end = PullEnd::kNotTight;
  PullPhase tighten, rest, pull;
  double sprung = 0;      // m, of the two tails together, drawn into the knot while it rested
  double slip[2] = {};    // m, of each tail into the knot, from the rest on
  double creep = 0;       // m/s, of both tails, in the second half of the time for which the load was kept
  double most = 0;        // N, greatest tension of a leg
  double overlap = 0;     // m, deepest
  Word word;              // that is read after the pull
  bool certain = false;
  bool same_word = false;
  std::string health;     // what the solver said, if anything
  std::vector<Vec3> rested;  // m, the thread once it has rested; its legs end beside the node `loop`
  int loop = 0;
};

/// `trace`: a CSV of the run, one line in ten steps; "": none.
PullResult pull(const PullTest& test, const std::string& trace = "");

}  // namespace swage::test
