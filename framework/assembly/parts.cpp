// SPDX-License-Identifier: Apache-2.0
#include "assembly/parts.hpp"

#include <algorithm>
#include <vector>

#include "assembly/sentences.hpp"
#include "assembly/settings.hpp"
#include "assembly/source_map.hpp"
#include "host/nearest.hpp"

namespace swage::assembly {
namespace {

using Json = nlohmann::ordered_json;

bool error(const PartsSaid& said, const std::string& pointer, const std::string& message, base::Problems& problems) {
  problems.push_back({base::Severity::kError, said.places.where(pointer), message});
  return false;
}

std::vector<std::string> names_in(const Json& lesson, const std::string& list) {
  if (list == "couplings") return coupling_names(lesson);
  std::vector<std::string> names;
  const auto uses = lesson.find(list);
  if (uses == lesson.end() || !uses->is_array()) return names;
  for (const Json& use : *uses) {
    const auto name = use.is_object() ? use.find("name") : use.end();
    names.push_back(name != use.end() && name->is_string() ? name->get<std::string>() : std::string());
  }
  return names;
}

// Couplings without a name keep the number that they have in the complete list.
void name_couplings(Json& lesson) {
  const std::vector<std::string> names = coupling_names(lesson);
  for (std::size_t i = 0; i < names.size(); ++i)
    if (Json& use = lesson["couplings"][i]; use.is_object() && !use.contains("name") && !names[i].empty()) use["name"] = names[i];
}

bool take_out(const std::string& name, Json& lesson, Places& places, std::vector<std::string>& all) {
  for (const std::string list : kPartLists) {
    const std::vector<std::string> names = names_in(lesson, list);
    const auto found = std::find(names.begin(), names.end(), name);
    std::copy_if(names.begin(), names.end(), std::back_inserter(all), [](const std::string& n) { return !n.empty(); });
    if (found == names.end()) continue;
    const auto at = static_cast<std::size_t>(found - names.begin());
    lesson[list].erase(at);
    places.close_gap("/" + list, at, names.size());
    return true;
  }
  return false;
}

// the place of every value of a part is that in the variant's file
void move_all(const Json& value, const std::string& to, const std::string& from, const Places& there, Places& places) {
  places.move(to, there.where(from));
  if (value.is_object())
    for (const auto& [key, below] : value.items())
      move_all(below, to + "/" + pointer_step(key), from + "/" + pointer_step(key), there, places);
  if (value.is_array())
    for (std::size_t i = 0; i < value.size(); ++i)
      move_all(value[i], to + "/" + std::to_string(i), from + "/" + std::to_string(i), there, places);
}

}  // namespace

bool remove_parts(const PartsSaid& remove, Json& lesson, Places& lesson_places, base::Problems& problems) {
  const auto is_name = [](const Json& name) { return name.is_string() && !name.get_ref<const std::string&>().empty(); };
  if (!remove.says.is_array() || !std::all_of(remove.says.begin(), remove.says.end(), is_name))
    return error(remove, remove.pointer, say::kRemoveIsNoList(), problems);
  name_couplings(lesson);
  bool good = true;
  for (std::size_t i = 0; i < remove.says.size(); ++i) {
    const std::string name = remove.says[i].get<std::string>();
    std::vector<std::string> all;
    if (!take_out(name, lesson, lesson_places, all))
      good = error(remove, remove.pointer + "/" + std::to_string(i),
                   say::kNobodyToRemove(name, host::did_you_mean(name, all), host::join(all)), problems);
  }
  return good;
}

bool add_parts(const PartsSaid& add, Json& lesson, Places& lesson_places, base::Problems& problems) {
  if (!add.says.is_object()) return error(add, add.pointer, say::kAddIsNoObject(), problems);
  bool good = true;
  for (const auto& [list, parts] : add.says.items()) {
    const std::string from = add.pointer + "/" + pointer_step(list);
    if (std::find(std::begin(kPartLists), std::end(kPartLists), list) == std::end(kPartLists) || !parts.is_array()) {
      good = error(add, from, say::kAddIsNoObject(), problems);
      continue;
    }
    Json& all = lesson[list];
    if (all.is_null()) all = Json::array();
    if (!all.is_array()) continue;  // reported when the lesson is read
    for (std::size_t i = 0; i < parts.size(); ++i) {
      move_all(parts[i], "/" + list + "/" + std::to_string(all.size()), from + "/" + std::to_string(i), add.places, lesson_places);
      all.push_back(parts[i]);
    }
  }
  return good;
}

}  // namespace swage::assembly
