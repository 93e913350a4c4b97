// SPDX-License-Identifier: Apache-2.0
//
// A suture of the library (resources/threads, format swage-thread/1): what its material is. Frames: none. Units: SI.
// Threads: [main].
#pragma once

#include <string>

namespace swage::thread {

/// 10-0 nylon that has lain straight.
struct Suture {
  double diameter = 22e-6;  // m
  double young = 2.5e9;     // Pa
  double poisson = 0.39;
  double density = 1140;   // kg/m3
  double memory = 0;       // 1/m
  double strength = 0.19;  // N
  double pull_off = 0.14;  // N
  double yield = 0;        // strain of its surface beyond which it stays bent; 0: it never does
  double hardening = 0;    // share of its bending stiffness that is left there
};

/// Reads a library entry over `suture`. Returns "" or what is wrong.
std::string read_suture(const std::string& path, Suture& suture);

/// What is wrong with a suture, or "".
std::string fault(const Suture& suture);

}  // namespace swage::thread
