// SPDX-License-Identifier: Apache-2.0
#include "judge/host_events.hpp"

namespace swage::judge {

uint32_t declare_host_events(Script& script) {
  // present already?
  for (uint32_t i = 0; i < script.events.size(); ++i)
    if (script.events[i].owner == kHostOwner) return i;

  const auto first = static_cast<uint32_t>(script.events.size());
  script.events.push_back({kHostOwner, "host.quarantined", "1", "a plugin misbehaved; the attempt is void"});
  script.events.push_back({kHostOwner, "host.reset", "1", "an object was put back to its start"});
  script.events.push_back({kHostOwner, "host.mark", "1", "somebody marked this moment"});
  script.events.push_back({kHostOwner, "host.gap", "1", "steps were lost because the machine was held up"});
  script.events.push_back({kHostOwner, "host.force_stopped", "1", "the force guard disarmed a device"});
  script.events.push_back(
      {kHostOwner, "host.solver", "1", "the solver fell short for the first time; the counts say of what"});
  script.events.push_back(
      {kHostOwner, "host.hand_lost", "1", "a hand was lost: its tool holds, and the lesson waits for it"});
  script.events.push_back({kHostOwner, "host.hand_back", "s", "a lost hand is back, and goes on from where its tool stands"});
  script.events.push_back({kHostOwner, "host.not_drawn", "1", "what a plugin draws was left out for the first time: a part of it makes no sense"});
  return first;
}

}  // namespace swage::judge
