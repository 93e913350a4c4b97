// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "engine.hpp"

namespace swage::bench {

/// Units inside a peer, per SI unit: mm, mg and s unless a setup asks for others.
struct Units {
  double length = 1e3, mass = 1e6;
  double force() const { return mass * length; }
  double torque() const { return mass * length * length; }
};
inline Units units_of(const Setup& s) { return s.unit > 0 ? Units{s.unit, s.unit * s.unit} : Units{}; }

}  // namespace swage::bench
