// SPDX-License-Identifier: Apache-2.0
#include "step/overlaps.hpp"

#include <swage/abi/strand.h>

#include <algorithm>
#include <cstdio>

#include "step/sentences.hpp"

namespace swage::step {

namespace {
// of the scene's length: 20 um in a scene of 1 mm. Objects that rest on something or are held overlap by 1 um at most
constexpr double kDeepOverlap = 0.02;

/// True when one of both is a thread that a coupling ties to the other: its end is inside.
bool swaged(const host::Rig& rig, const contact::Pair& pair) {
  const auto is_thread = [&](uint32_t object) {
    return rig.objects[object].instance->extension(SWAGE_TRAIT_STRAND) != nullptr;
  };
  if (!is_thread(pair.object_a) && !is_thread(pair.object_b)) return false;
  return std::any_of(rig.couplings.begin(), rig.couplings.end(), [&](const host::CouplingSlot& slot) {
    return slot.ties != nullptr && std::minmax(slot.object_a, slot.object_b) == std::minmax(pair.object_a, pair.object_b);
  });
}

}  // namespace

base::Problems start_overlaps(const host::Rig& rig, const contact::Options& options) {
  base::Problems out;
  contact::Detector detector(rig.world, rig.pairs, options);
  contact::ContactSet set;
  detector.reserve(set);
  detector.reset(set);
  detector.detect(rig.world, set);
  std::vector<double> depth(rig.pairs.size(), 0);
  for (const contact::Contact& c : set.contact) depth[c.pair] = std::max(depth[c.pair], -c.gap);
  for (std::size_t i = 0; i < depth.size(); ++i) {
    if (depth[i] <= kDeepOverlap * rig.world.length || swaged(rig, rig.pairs[i])) continue;
    const auto& a = *rig.objects[rig.pairs[i].object_a].instance;
    const auto& b = *rig.objects[rig.pairs[i].object_b].instance;
    char deep_mm[32];
    std::snprintf(deep_mm, sizeof deep_mm, "%.3g", 1e3 * depth[i]);
    out.push_back({base::Severity::kWarning, a.name, say::kStartsInside(a.name, deep_mm, b.name)});
  }
  return out;
}

}  // namespace swage::step
