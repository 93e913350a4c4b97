// SPDX-License-Identifier: Apache-2.0
//
// What a tool that follows a hand cannot go through: fixed solids that a coupling lets it touch. Both sides are moved from
// outside, so no contact force could hold them apart; the tool's proxy stops at the surface and slides along it while the
// hand runs ahead.
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

  /// Where the frame of the tool comes to rest on its way from X_from, where its bodies stand now, to X_to: pushed out of
  /// whatever it would overlap, and back at X_from when that cannot be done. X_to itself when nothing is there.
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
