// SPDX-License-Identifier: Apache-2.0
//
// Proxy (god object) of a tool that follows a hand: it cannot pass through fixed solids that a coupling lets the tool touch. Both
// have a prescribed motion, so no contact force could hold them apart; the proxy stops at the surface and slides along it while the
// hand moves on.
//
// Units: m. Threads: built on [main]; rest() is [rt] and allocates nothing.
#pragma once

#include <vector>

#include "contact/narrow_phase.hpp"
#include "host/rig.hpp"

namespace swage::step {

class ToolProxy {
 public:
  explicit ToolProxy(const host::Rig& rig);

  /// Pose of the tool's frame at the end of its motion from X_from, where its bodies are now, to X_to: pushed out of whatever it
  /// would overlap; where that fails, the pose before. X_to itself when nothing is in between.
  toolkit::Pose rest(uint32_t object, const toolkit::Pose& X_from, const toolkit::Pose& X_to) noexcept;

 private:
  /// A shape of a tool and a fixed shape.
  struct Stop {
    uint32_t object, tool, fixed;  // shapes: global
    contact::Separation memory;
  };
  bool push_out(uint32_t object, const toolkit::Pose& X_from, toolkit::Pose& X_WT) noexcept;
  double reach(uint32_t object, const toolkit::Pose& X_from) const noexcept;

  const scene::World& world_;
  std::vector<Stop> stop_;
  std::vector<contact::Solid> solid_;  // per shape of the world; empty where nothing needs it
  contact::Manifold found_;
};

}  // namespace swage::step
