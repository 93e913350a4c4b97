// SPDX-License-Identifier: Apache-2.0
//
// Events that the host itself reports, in every scene, in addition to those that couplings and lessons declare.
#pragma once

#include <cstdint>

#include "judge/verdict.hpp"

namespace swage::judge {

/// Owner of these events in the script.
inline constexpr const char* kHostOwner = "swage";

enum HostEvent : uint32_t {
  kInstanceQuarantined,  // "host.quarantined"; value: ordinal of the instance (objects, couplings, devices,
                         // lesson)
  kObjectReset,          // "host.reset"; value: index of the object
  kMomentMarked,         // "host.mark"; value: ordinal of the mark
  kTimeLost,             // "host.gap"; value: steps that were never executed
  kForceStopped,         // "host.force_stopped"; value: cause, session::ForceFault
  kSolverFellShort,      // "host.solver"; value: step; the counts are in the health of the loop
  kHandLost,             // "host.hand_lost"; value: index of the device
  kHandBack,             // "host.hand_back"; value: s for which the lesson waited
  kNotDrawn,             // "host.not_drawn"; value: ordinal of the instance whose primitives were left out; the rest is in the
                         // health of the loop
  kHostEventCount
};

/// Adds the host's events to a script that does not have them yet. Returns the index of the first. [main]
uint32_t declare_host_events(Script&);

}  // namespace swage::judge
