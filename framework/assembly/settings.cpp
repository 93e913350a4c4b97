// SPDX-License-Identifier: Apache-2.0
#include "assembly/settings.hpp"

#include <set>
#include <utility>

#include "assembly/sentences.hpp"
#include "assembly/source_map.hpp"
#include "host/nearest.hpp"

namespace swage::assembly {
namespace {

using Json = nlohmann::ordered_json;

Json value_of(const std::string& text) {
  Json value = Json::parse(text, nullptr, false);
  return value.is_discarded() ? Json(text) : value;
}

std::string text_at(const Json& object, const char* key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// The list at a key, nullptr where there is none.
Json* list_at(Json& object, const char* key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  return found != object.end() && found->is_array() ? &*found : nullptr;
}

/// One value to be set in a lesson.
struct Entry {
  std::string key;
  Json value;
  std::vector<std::string> pointers{};  // where it was set
  bool refused = false;                 // the file has a value of another type in place of "params"

  void put(Json& use, const std::string& pointer) {
    if (use.is_object() && !use.contains("params")) use["params"] = Json::object();
    if (!use.is_object() || !use["params"].is_object()) {
      refused = true;
      return;
    }
    use["params"][key] = value;
    pointers.push_back(pointer + "/params/" + pointer_step(key));
  }

  /// Sets the value in every alternative that has the parameter, else in the first.
  void put_in_device(Json& device, const std::string& pointer) {
    const auto knows = [this](const Json& choice) {
      return choice.is_object() && choice.contains("params") && choice["params"].contains(key);
    };
    if (knows(device)) put(device, pointer);
    if (Json* others = list_at(device, "or"))
      for (std::size_t i = 0; i < others->size(); ++i)
        if (knows((*others)[i])) put((*others)[i], pointer + "/or/" + std::to_string(i));
    if (pointers.empty()) put(device, pointer);
  }
};

std::vector<std::string> names_of(const Json& file, const char* list) {
  if (std::string(list) == "couplings") return coupling_names(file);
  std::vector<std::string> names;
  for (const Json& use : file[list]) names.push_back(text_at(use, "name"));
  return names;
}

/// False when there is no instance of this name; `all` then has every name.
bool find_and_put(Json& file, const std::string& name, Entry& entry, std::vector<std::string>& all) {
  if (name == "lesson" && file.contains("lesson")) {
    entry.put(file["lesson"], "/lesson");
    return true;
  }
  for (const char* list : {"objects", "couplings", "devices"}) {
    Json* uses = list_at(file, list);
    if (uses == nullptr) continue;
    const std::vector<std::string> names = names_of(file, list);
    for (std::size_t i = 0; i < uses->size(); ++i) {
      if (!names[i].empty()) all.push_back(names[i]);
      if (names[i] != name) continue;
      const std::string pointer = "/" + std::string(list) + "/" + std::to_string(i);
      std::string(list) == "devices" ? entry.put_in_device((*uses)[i], pointer)
                                     : entry.put((*uses)[i], pointer);
      return true;
    }
  }
  all.push_back("lesson");
  return false;
}

/// Sets a key of "environment", which has no "params". A lesson without an environment gets one, which then needs a medium.
bool set_environment(Json& file, const std::string& key, const Json& value, std::vector<std::string>& pointers) {
  Json& environment = file["environment"];
  if (!environment.is_object()) environment = Json::object();
  environment[key] = value;
  pointers = {"/environment/" + pointer_step(key)};
  return true;
}

}  // namespace

std::string last_word(const std::string& plugin_id) { return plugin_id.substr(plugin_id.rfind('.') + 1); }

std::vector<std::string> coupling_names(const Json& lesson) {
  std::vector<std::string> names;
  std::set<std::string> taken;
  const auto couplings = lesson.is_object() ? lesson.find("couplings") : lesson.end();
  if (couplings == lesson.end() || !couplings->is_array()) return names;
  for (const Json& use : *couplings) {
    names.push_back(text_at(use, "name"));
    taken.insert(names.back());
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string word = last_word(text_at((*couplings)[i], "plugin"));
    if (!names[i].empty() || word.empty()) continue;
    names[i] = word;
    for (int n = 2; !taken.insert(names[i]).second; ++n) names[i] = word + "_" + std::to_string(n);
  }
  return names;
}

bool parse_setting(const std::string& text, Setting& out) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) return false;
  out = {text.substr(0, equals), text.substr(equals + 1)};
  return true;
}

bool set_in(Json& file, const Setting& setting, const std::string& place, base::Problems& problems,
            std::vector<std::string>& pointers) {
  const std::size_t dot = setting.what.find('.');
  const Json value = value_of(setting.value);
  if (dot == std::string::npos) {
    file[setting.what] = value;
    pointers = {"/" + pointer_step(setting.what)};
    return true;
  }
  std::vector<std::string> names;
  const std::string instance = setting.what.substr(0, dot);
  if (instance == "environment") return set_environment(file, setting.what.substr(dot + 1), value, pointers);
  Entry entry{setting.what.substr(dot + 1), value};
  const bool found = find_and_put(file, instance, entry, names);
  pointers = std::move(entry.pointers);
  if (found && !entry.refused) return true;
  const std::string why = found ? say::kNoParams(setting.what)
                                : say::kNobodyToSet(instance, setting.what, host::did_you_mean(instance, names), host::join(names));
  problems.push_back({base::Severity::kError, place, why});
  return false;
}

}  // namespace swage::assembly
