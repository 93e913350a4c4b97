// SPDX-License-Identifier: Apache-2.0
#include "assembly/settings.hpp"

#include "host/nearest.hpp"

namespace swage::assembly {
namespace {

using Json = nlohmann::ordered_json;

Json value_of(const std::string& text) {
  Json value = Json::parse(text, nullptr, false);
  return value.is_discarded() ? Json(text) : value;
}

std::string name_of(const Json& use) {
  if (use.contains("name") && use["name"].is_string()) return use["name"];
  return last_word(use.value("plugin", ""));
}

void set_param(Json& use, const std::string& key, const Json& value) { use["params"][key] = value; }

void set_device(Json& device, const std::string& key, const Json& value) {
  bool known = false;
  const auto offer = [&](Json& choice) {
    if (!choice.contains("params") || !choice["params"].contains(key)) return;
    set_param(choice, key, value);
    known = true;
  };
  offer(device);
  if (device.contains("or"))
    for (Json& choice : device["or"]) offer(choice);
  if (!known) set_param(device, key, value);
}

/// False when nothing of this name is there; `names` then has all that is.
bool set_instance(Json& file, const std::string& name, const std::string& key, const Json& value,
                  std::vector<std::string>& names) {
  if (name == "lesson" && file.contains("lesson")) {
    set_param(file["lesson"], key, value);
    return true;
  }
  for (const char* list : {"objects", "couplings", "devices"}) {
    if (!file.contains(list) || !file[list].is_array()) continue;
    for (Json& use : file[list]) {
      if (!use.is_object()) continue;
      names.push_back(name_of(use));
      if (names.back() != name) continue;
      std::string(list) == "devices" ? set_device(use, key, value) : set_param(use, key, value);
      return true;
    }
  }
  names.push_back("lesson");
  return false;
}

}  // namespace

std::string last_word(const std::string& plugin_id) { return plugin_id.substr(plugin_id.rfind('.') + 1); }

bool parse_setting(const std::string& text, Setting& out) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) return false;
  out = {text.substr(0, equals), text.substr(equals + 1)};
  return true;
}

bool set_in(Json& file, const Setting& setting, const std::string& name, base::Problems& problems) {
  const std::size_t dot = setting.what.find('.');
  const Json value = value_of(setting.value);
  if (dot == std::string::npos) {
    file[setting.what] = value;
    return true;
  }
  std::vector<std::string> names;
  const std::string instance = setting.what.substr(0, dot);
  if (set_instance(file, instance, setting.what.substr(dot + 1), value, names)) return true;
  problems.push_back({base::Severity::kError, name,
                      "There is no \"" + instance + "\" to set \"" + setting.what + "\"." +
                          host::did_you_mean(instance, names) + " There is: " + host::join(names) + "."});
  return false;
}

}  // namespace swage::assembly
