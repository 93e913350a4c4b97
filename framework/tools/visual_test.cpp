// SPDX-License-Identifier: Apache-2.0
#include "tools/visual_test.hpp"

#include <cmath>
#include <cstring>
#include <iterator>
#include <vector>

#include "host/visuals.hpp"
#include "scene/state_image.hpp"
#include "snapshot/snapshot.hpp"
#include "tools/print.hpp"
#include "tools/sentences.hpp"

namespace swage::tools {

namespace {

constexpr uint32_t kUntouched = 0xA5A5A5A5u;  // group of a primitive that nobody has written
constexpr uint32_t kWide = 4096;             // room in which any list that makes sense has its place

uint64_t hash_of(const scene::World& world) {
  scene::Writer all;
  scene::save(world, all);
  return all.hash();
}

static_assert(std::size(base::kVisualKinds) == SWAGE_VISUAL_KINDS + 1);

// what is wrong with a primitive, without its number
std::string fault_in(const swage_visual& v, uint32_t bodies) {
  const host::VisualFlaw flaw = host::flaw_of(v, bodies);
  switch (flaw.fault) {
    case host::VisualFault::kKind:
      return say::kVisualKind(v.kind);
    case host::VisualFault::kTone:
      return say::kVisualTone(v.tone);
    case host::VisualFault::kBody:
      return say::kVisualBody(v.body, bodies);
    case host::VisualFault::kNumber:
      return say::kVisualNumber(base::visual_member(static_cast<uint32_t>(flaw.member)));
    case host::VisualFault::kSize:
      return say::kVisualSize(format("%g", v.radius));
    case host::VisualFault::kStrength:
      return say::kVisualStrength(format("%g", v.strength));
    case host::VisualFault::kNormal:
      return say::kVisualNormal(format("%g", std::hypot(v.direction.x, v.direction.y, v.direction.z)));
    case host::VisualFault::kGood:
      break;
  }
  return "";
}

std::string wrong_in(const std::vector<swage_visual>& list, uint32_t n, uint32_t bodies) {
  for (uint32_t i = 0; i < n; ++i)
    if (const std::string fault = fault_in(list[i], bodies); !fault.empty()) return say::kOfVisual(i, base::visual_kind(list[i].kind), fault);
  return "";
}

// what will not be seen of a list without a fault; asked with more room than a host gives, as the wrapper keeps within any
std::string unseen(const Draw& draw, const std::vector<swage_visual>& list, uint32_t n, bool pierceable) {
  for (uint32_t i = 0; i < n && !pierceable; ++i)
    if (list[i].kind <= SWAGE_VISUAL_WOUND) return say::kVisualUnseen(i, base::visual_kind(list[i].kind), SWAGE_TRAIT_PIERCEABLE);
  if (n < snapshot::kMaxVisualsOfOne) return "";
  std::vector<swage_visual> wide(std::size_t{kWide});
  uint32_t n_wide = 0;
  return draw(kWide, wide.data(), &n_wide) && n_wide > n ? say::kVisualsLeftOut(n_wide, n) : "";
}

}  // namespace

std::string visuals(const Draw& draw, uint32_t bodies, const scene::World& world, std::string* note, bool pierceable) {
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
    if (std::string wrong = wrong_in(out, n, bodies); !wrong.empty()) return wrong;
    if (draw(room, again.data(), &n_again) && (n != n_again || std::memcmp(out.data(), again.data(), n * sizeof untouched) != 0))
      return say::kVisualOther();
    if (note != nullptr && room == snapshot::kMaxVisualsOfOne) *note = unseen(draw, out, n, pierceable);
  }
  return "";
}

}  // namespace swage::tools
