// SPDX-License-Identifier: Apache-2.0
//
// Builder: names of signals, metrics, cues, events and phases; checks that need all declarations.
#include <algorithm>

#include "host/builder.hpp"
#include "host/sentences.hpp"
#include "host/units.hpp"

namespace swage::host {

using scene::Range;

namespace {

bool is_name(const std::string& id) {
  const auto good = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '.';
  };
  return !id.empty() && id[0] >= 'a' && id[0] <= 'z' && std::all_of(id.begin(), id.end(), good);
}

}  // namespace

uint32_t Builder::add_name(std::vector<judge::Name>& list, Range& range, judge::Name name) {
  if (!is_name(name.id)) return refuse(say::kNotDotted(name.id));
  if (name.doc.empty()) return refuse(say::kNameNoDoc(name.id));
  if (const Unit* u = find_unit(name.unit); u == nullptr || u->si != name.unit)
    return refuse(say::kNameNoUnit(name.id, name.unit, unit_list()));
  for (uint32_t i = 0; i < range.count; ++i)
    if (list[range.first + i].id == name.id) return refuse(say::kDeclaredTwice(name.id));
  list.push_back(std::move(name));
  return range.count++;
}

void Builder::finish() {
  for (uint32_t i = 0; i < body.count; ++i) {
    const scene::BodyInfo& info = world_.body[body.first + i];
    if (info.motion == SWAGE_MOTION_HINGED && info.hinge == scene::kNone)
      refuse(say::kNoHinge(info.name));
  }
}

}  // namespace swage::host
