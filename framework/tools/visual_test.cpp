// SPDX-License-Identifier: Apache-2.0
#include "tools/visual_test.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <utility>
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

constexpr std::array<const char*, SWAGE_VISUAL_KINDS + 1> kKinds = {"unknown", "dent", "tear", "wound", "line", "disc", "tube"};

const char* kind_of(const swage_visual& v) { return kKinds[v.kind <= SWAGE_VISUAL_KINDS ? v.kind : 0]; }

// the first member that is no place
std::string member_of(const swage_visual& v) {
  constexpr double kFar = 1e6;  // m, as in host/visuals.hpp
  const std::pair<const char*, double> members[] = {
      {"a.x", v.a.x}, {"a.y", v.a.y}, {"a.z", v.a.z}, {"b.x", v.b.x}, {"b.y", v.b.y}, {"b.z", v.b.z},
      {"direction.x", v.direction.x}, {"direction.y", v.direction.y}, {"direction.z", v.direction.z}};
  for (const auto& [name, x] : members)
    if (!(std::abs(x) < kFar)) return name;
  return "radius";
}

// what is wrong with a primitive, without its number
std::string fault_in(const swage_visual& v, uint32_t bodies) {
  switch (host::fault_of(v, bodies)) {
    case host::VisualFault::kKind:
      return v.tone >= SWAGE_TONES && v.kind > 0 && v.kind <= SWAGE_VISUAL_KINDS ? say::kVisualTone(v.tone) : say::kVisualKind(v.kind);
    case host::VisualFault::kBody:
      return say::kVisualBody(v.body, bodies);
    case host::VisualFault::kNumber:
      return say::kVisualNumber(member_of(v));
    case host::VisualFault::kSize:
      return say::kVisualSize(format("%g", v.radius));
    case host::VisualFault::kStrength:
      return say::kVisualStrength(format("%g", v.strength));
    case host::VisualFault::kGood:
      break;
  }
  const double length = std::hypot(v.direction.x, v.direction.y, v.direction.z);
  // the tolerance with which the host takes directions as unit
  return v.kind == SWAGE_VISUAL_DISC && !(std::abs(length - 1) < 1e-6) ? say::kVisualNormal(format("%g", length)) : "";
}

std::string wrong_in(const std::vector<swage_visual>& list, uint32_t n, uint32_t bodies) {
  for (uint32_t i = 0; i < n; ++i)
    if (const std::string fault = fault_in(list[i], bodies); !fault.empty()) return say::kOfVisual(i, kind_of(list[i]), fault);
  return "";
}

// what will not be seen of a list without a fault; asked with more room than a host gives, as the wrapper keeps within any
std::string unseen(const Draw& draw, const std::vector<swage_visual>& list, uint32_t n, bool pierceable) {
  for (uint32_t i = 0; i < n && !pierceable; ++i)
    if (list[i].kind <= SWAGE_VISUAL_WOUND) return say::kVisualUnseen(i, kind_of(list[i]), SWAGE_TRAIT_PIERCEABLE);
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
