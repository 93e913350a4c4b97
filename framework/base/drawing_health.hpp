// SPDX-License-Identifier: Apache-2.0
//
// What pictures lack of the primitives that plugins draw (swage.visual/1): counters, all zero in a sound scene. One table has their
// names for every display: console, `swage run`, record of an attempt.
#pragma once

#include <cstdint>
#include <iterator>
#include <string>

namespace swage::base {

/// The part of a primitive, or of its list, that is at fault.
enum class VisualMember : uint32_t { kNone, kLength, kKind, kTone, kBody, kAx, kAy, kAz, kBx, kBy, kBz, kDirectionX, kDirectionY, kDirectionZ, kDirection, kRadius, kStrength };

inline constexpr const char* kVisualMembers[] = {"", "n", "kind", "tone", "body", "a.x", "a.y", "a.z", "b.x", "b.y", "b.z",
                                                 "direction.x", "direction.y", "direction.z", "direction", "radius", "strength"};
/// Kinds by their number in the ABI; those that nobody knows are "unknown".
inline constexpr const char* kVisualKinds[] = {"unknown", "dent", "tear", "wound", "line", "disc", "tube"};

inline const char* visual_member(uint32_t member) { return kVisualMembers[member < std::size(kVisualMembers) ? member : 0]; }
inline const char* visual_kind(uint32_t kind) { return kVisualKinds[kind < std::size(kVisualKinds) ? kind : 0]; }

/// DrawingHealth::coupling of what an object draws itself.
inline constexpr uint32_t kNoCoupling = UINT32_MAX;

/// Counted over the pictures taken since the start of the run; a list is what one object or coupling draws in one picture.
struct DrawingHealth {
  uint64_t faulty = 0;  // lists left out as a whole, because one of their primitives makes no sense
  uint64_t cut = 0;     // lists whose end is left out, for lack of room
  // the first faulty primitive, where faulty > 0
  uint32_t object = 0;    // index of the object on which it is drawn
  uint32_t coupling = 0;  // index of the coupling that draws it; kNoCoupling: the object itself does
  uint32_t index = 0;     // in its list, from 0
  uint32_t kind = 0;      // SWAGE_VISUAL_* as the plugin has it
  uint32_t member = 0;    // VisualMember
  uint32_t reserved = 0;
};

struct DrawingHealthField {
  uint64_t DrawingHealth::*count;
  const char* id;   // in JSON
  const char* doc;  // after a number
};

inline constexpr DrawingHealthField kDrawingHealthFields[] = {
    {&DrawingHealth::faulty, "faulty", "drawings left out for a faulty primitive"},
    {&DrawingHealth::cut, "cut", "drawings cut for lack of room"},
};

/// "3 drawings left out for a faulty primitive"; "" when all counters are zero. [main]
inline std::string text(const DrawingHealth& health) {
  std::string out;
  for (const DrawingHealthField& field : kDrawingHealthFields)
    if (health.*field.count > 0) out += (out.empty() ? "" : ", ") + std::to_string(health.*field.count) + " " + field.doc;
  return out;
}

}  // namespace swage::base
