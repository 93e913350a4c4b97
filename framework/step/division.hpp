// SPDX-License-Identifier: Apache-2.0
//
// When a step is divided. Contacts are detected where a chain would advance to, and each is a plane for the whole step. A chain that is
// snatched or springs back leaves the plane, and passes the edge of what it touched, or something that was not near. Such a step is undone
// and repeated in four parts, each of them again in four where that is still too far. A spring moves a mass from rest as the square of the
// time: 0.4 mm in a step become 0.1 um in a sixty-fourth.
#pragma once

#include "dynamics/options.hpp"
#include "step/chain_watch.hpp"

namespace swage::step {

/// Parts of a divided step; kUsual and kDivisions limit how often. More parts: a step that is too far in one of them alone costs more. Fewer
/// divisions: a snatched thread passes through itself.
constexpr int kParts = 4;

/// How often a step is divided for displacements that may lead to a passage: down to 1/64.
constexpr std::size_t kUsual = 3;

/// How often where a chain did pass through itself: a thread of 4e-7 kg/m that bears 20 mN springs by ten of its diameters in 1/64 ms.
constexpr std::size_t kDivisions = 6;

/// In radii of a chain: allowed displacement relative to what it is near to since contacts were detected, where that is no flat face that
/// stands still; its own thickness. Smaller: fast sliding costs several times as much. Larger: passages.
constexpr double kFar = 2;

/// True when a step at this level of division was too far for one. If it did not converge it is divided once: where it never does, the cost
/// stays that of five. `begun`: the health before it. [rt]
inline bool fell_short(const dynamics::Stats& stats, const base::SolverHealth& begun, std::size_t level, ChainWatch& chains,
                       const contact::ContactSet& contacts) noexcept {
  if (level >= kDivisions) return false;
  if ((level < kUsual && stats.strayed > kFar) || (level == 0 && stats.health.not_converged > begun.not_converged)) return true;
  return chains.passed_itself() || (level < kUsual && chains.met_unseen(contacts));
}

}  // namespace swage::step
