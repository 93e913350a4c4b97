// SPDX-License-Identifier: Apache-2.0
#include "tools/visual_test.hpp"

#include <algorithm>
#include <cstring>
#include <vector>

#include "host/visuals.hpp"
#include "scene/state_image.hpp"
#include "snapshot/snapshot.hpp"
#include "tools/print.hpp"
#include "tools/sentences.hpp"

namespace swage::tools {

namespace {

constexpr uint32_t kUntouched = 0xA5A5A5A5u;  // group of a primitive that nobody has written

uint64_t hash_of(const scene::World& world) {
  scene::Writer all;
  scene::save(world, all);
  return all.hash();
}

std::string wrong_in(const swage_visual& v, uint32_t bodies) {
  switch (host::fault_of(v, bodies)) {
    case host::VisualFault::kKind:
      return say::kVisualKind(v.kind, v.tone);
    case host::VisualFault::kBody:
      return say::kVisualBody(v.body, bodies);
    case host::VisualFault::kNumber:
      return say::kVisualNumber();
    case host::VisualFault::kSize:
      return say::kVisualSize(format("%g", v.radius));
    case host::VisualFault::kStrength:
      return say::kVisualStrength(format("%g", v.strength));
    case host::VisualFault::kGood:
      break;
  }
  return "";
}

}  // namespace

std::string visuals(const Draw& draw, uint32_t bodies, const scene::World& world) {
  for (const uint32_t room : {0u, 1u, snapshot::kMaxVisualsOfOne}) {
    // one more than there is room for, to see whether it keeps within it
    swage_visual untouched{};
    untouched.group = kUntouched;
    std::vector<swage_visual> out(room + 1, untouched), again = out;
    uint32_t n = 0, n_again = 0;
    const uint64_t before = hash_of(world);
    if (!draw(room, out.data(), &n)) return "";
    if (n > room) return say::kManyVisuals(n, room);
    if (out[room].group != kUntouched) return say::kVisualBeyond(room);
    if (hash_of(world) != before) return say::kVisualMeddles();
    for (uint32_t i = 0; i < n; ++i)
      if (std::string wrong = wrong_in(out[i], bodies); !wrong.empty()) return wrong;
    if (draw(room, again.data(), &n_again) && (n != n_again || std::memcmp(out.data(), again.data(), n * sizeof untouched) != 0))
      return say::kVisualOther();
  }
  return "";
}

}  // namespace swage::tools
