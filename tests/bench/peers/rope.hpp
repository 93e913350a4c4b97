// SPDX-License-Identifier: Apache-2.0
//
// A peer's own rope, held level by its first segment.
#pragma once

#include <memory>

#include "engine.hpp"

namespace swage::bench {

struct RopeSetup {
  int segments = 20;
  double length = 18.9e-3, line_mass = 4.33e-7, bending = 2.875e-11;  // m, kg/m, N m2
  double diameter = 22e-6;                                          // m
  int iterations = 10;                                              // of who iterates
};

class Rope {
 public:
  virtual ~Rope() = default;
  virtual void step() = 0;       // of 1 ms, with gravity along -z
  virtual Vec3 end() const = 0;  // m, from the first point
};

/// Null where the peer is not installed.
std::unique_ptr<Rope> mujoco_rope(const RopeSetup&);
std::unique_ptr<Rope> bullet_rope(const RopeSetup&);

}  // namespace swage::bench
