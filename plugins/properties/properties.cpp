// SPDX-License-Identifier: Apache-2.0
#include "properties/properties.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "toolkit/read_file.hpp"

namespace swage::properties {
namespace {

using Json = nlohmann::json;

std::string take(const std::string& name, const Json& entry, const std::string& noun,
                 const std::map<std::string, Property>& known) {
  const auto property = known.find(name);
  if (property == known.end()) return "\"" + name + "\" is not a property of a " + noun;
  const bool whole = entry.is_object() && entry.contains("value") && entry["value"].is_number() &&
                     entry.contains("unit") && entry["unit"].is_string();
  if (!whole) return "\"" + name + "\" needs a value and a unit";
  if (entry["unit"] != property->second.unit)
    return "\"" + name + "\" is in " + property->second.unit + ", not " + entry["unit"].get<std::string>();
  const bool told = entry.contains("status") &&
                    (entry["status"] == "sourced" || entry["status"] == "assumed") &&
                    entry.contains("source") && entry["source"].is_string();
  if (!told) return "\"" + name + "\" needs a status (sourced or assumed) and a source";
  const double x = entry["value"].get<double>() * property->second.si;
  if (!std::isfinite(x) || x < 0) return "\"" + name + "\" must be a number of 0 or above";
  if (property->second.set) property->second.set(x);
  return "";
}

}  // namespace

std::string read_properties(const std::string& path, const std::string& format, const std::string& noun,
                            const std::map<std::string, Property>& known) {
  std::string text, why;
  if (!toolkit::read_file(path, toolkit::kMostFileBytes, text, why)) return path + ": " + why;
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains("format") || json["format"] != format)
    return path + " is not a " + noun + " of format " + format;
  if (!json.contains("values") || !json["values"].is_object()) return path + " has no \"values\"";
  for (const auto& [name, entry] : json["values"].items()) {
    const std::string wrong = take(name, entry, noun, known);
    if (!wrong.empty()) return path + ": " + wrong;
  }
  return "";
}

}  // namespace swage::properties
