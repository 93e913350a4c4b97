// SPDX-License-Identifier: Apache-2.0
//
// Parameter tables in the sidecar: the plugin's values, number for number.
#include "host/params_json.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace swage::host {

using Json = nlohmann::ordered_json;

namespace {

constexpr std::array kTypes = {"real", "integer", "bool", "choice", "text", "vector", "file"};

constexpr std::array<std::pair<const char*, uint32_t>, 4> kFlags = {
    {{"live", SWAGE_PARAM_LIVE}, {"required", SWAGE_PARAM_REQUIRED}, {"hidden", SWAGE_PARAM_HIDDEN}, {"interval", SWAGE_PARAM_INTERVAL}}};

// JSON has no infinity; an open end of a range is null
Json bound(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
double bound(const Json& json, double open) { return json.is_null() ? open : json.get<double>(); }

Json param_to_json(const Param& p) {
  Json json;
  json["id"] = p.id;
  const bool known = p.type >= SWAGE_PARAM_REAL && p.type <= SWAGE_PARAM_FILE;
  json["type"] = known ? kTypes[static_cast<std::size_t>(p.type - 1)] : "unknown";
  json["label"] = p.label;
  json["group"] = p.group;
  json["unit"] = p.unit;
  json["display_unit"] = p.display_unit;
  json["doc"] = p.doc;
  json["dimension"] = p.dimension;
  json["min"] = bound(p.min);
  json["max"] = bound(p.max);
  json["default"] = p.default_number;
  json["default_text"] = p.default_text;
  json["choices"] = p.choices;
  json["aliases"] = p.aliases;
  Json& flags = json["flags"] = Json::array();
  for (const auto& [name, bit] : kFlags)
    if ((p.flags & bit) != 0) flags.push_back(name);
  return json;
}

Param param_from_json(const Json& json) {
  Param p;
  json.at("id").get_to(p.id);
  const std::string type = json.at("type");
  for (std::size_t i = 0; i < kTypes.size(); ++i)
    if (type == kTypes[i]) p.type = static_cast<int32_t>(i + 1);
  json.at("label").get_to(p.label);
  json.at("group").get_to(p.group);
  json.at("unit").get_to(p.unit);
  json.at("display_unit").get_to(p.display_unit);
  json.at("doc").get_to(p.doc);
  json.at("dimension").get_to(p.dimension);
  p.min = bound(json.at("min"), -std::numeric_limits<double>::infinity());
  p.max = bound(json.at("max"), std::numeric_limits<double>::infinity());
  json.at("default").get_to(p.default_number);
  json.at("default_text").get_to(p.default_text);
  json.at("choices").get_to(p.choices);
  json.at("aliases").get_to(p.aliases);
  for (const auto& [name, bit] : kFlags)
    for (const Json& flag : json.at("flags"))
      if (flag == name) p.flags |= bit;
  return p;
}

}  // namespace

Json table_to_json(const ParamTable& table) {
  Json list = Json::array();
  for (const Param& p : table) list.push_back(param_to_json(p));
  return list;
}

bool table_from_json(const Json& json, ParamTable& out) {
  out.clear();
  try {
    for (const Json& item : json) out.push_back(param_from_json(item));
  } catch (const Json::exception&) {
    return false;
  }
  return true;
}

}  // namespace swage::host
