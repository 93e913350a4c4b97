// SPDX-License-Identifier: Apache-2.0
#include "host/schema.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "host/environment.hpp"
#include "host/units.hpp"
#include "snapshot/scene_card.hpp"

namespace swage::host {

using Json = nlohmann::ordered_json;

namespace {

constexpr const char* kDraft = "http://json-schema.org/draft-07/schema#";

Json note_pattern() { return {{"^x-", Json::object()}}; }  // notes for people are allowed everywhere

// "^\s*[-+]?...\s*(mm|m|um)\s*$": JSON Schema uses regular expressions of ECMAScript
std::string quantity_pattern(const std::string& si) {
  std::string units = units_like(si), choices;
  for (std::size_t at = 0; at < units.size();) {
    const std::size_t end = std::min(units.find(", ", at), units.size());
    for (const char c : units.substr(at, end - at)) choices += c == '*' ? "\\*" : std::string(1, c);
    choices += "|";
    at = end + 2;
  }
  if (!choices.empty()) choices.pop_back();
  return "^ *[-+]?[0-9]*\\.?[0-9]+([eE][-+]?[0-9]+)? *(" + choices + (si == "1" ? ")? *$" : ") *$");
}

Json quantity_schema(const std::string& si, double min, double max) {
  Json number = {{"type", "number"}};
  if (std::isfinite(min)) number["minimum"] = min;
  if (std::isfinite(max)) number["maximum"] = max;
  return {{"anyOf", {number, {{"type", "string"}, {"pattern", quantity_pattern(si)}}}}};
}

Json number_schema(const Param& p) { return quantity_schema(p.unit, p.min, p.max); }

Json param_schema(const Param& p) {
  Json s;
  switch (p.type) {
    case SWAGE_PARAM_INTEGER:
      s = {{"type", "integer"}, {"minimum", p.min}, {"maximum", p.max}};
      break;
    case SWAGE_PARAM_BOOL:
      s = {{"type", "boolean"}};
      break;
    case SWAGE_PARAM_CHOICE:
      s = {{"enum", p.choices}};
      break;
    case SWAGE_PARAM_TEXT:
    case SWAGE_PARAM_FILE:
      s = {{"type", "string"}};
      break;
    case SWAGE_PARAM_VECTOR:
      s = {{"type", "array"},
           {"items", number_schema(p)},
           {"minItems", p.dimension},
           {"maxItems", p.dimension}};
      break;
    default:
      s = number_schema(p);
  }
  s["title"] = p.label;
  s["description"] = p.doc;
  const ParamValues values = default_values({p});
  s["default"] = Json::parse(value_text(p, values.value[0]), nullptr, false);
  return s;
}

Json params_object(const PluginInfo& plugin) {
  Json s = {{"type", "object"}, {"title", plugin.name}, {"description", plugin.summary}};
  Json& properties = s["properties"] = Json::object();
  Json required = Json::array();
  for (const Param& p : plugin.params) {
    properties[p.id] = param_schema(p);
    // former ids are accepted, with a warning that names the new one
    for (const std::string& alias : p.aliases) properties[alias] = param_schema(p);
    if (p.required()) required.push_back(p.id);
  }
  if (!required.empty()) s["required"] = required;
  s["patternProperties"] = note_pattern();
  s["additionalProperties"] = false;
  return s;
}

// an object with "plugin" and "params", where the plugin determines the schema of params
Json use_schema(const std::vector<PluginInfo>& plugins, int32_t kind, Json properties,
                std::vector<std::string> required) {
  Json ids = Json::array(), rules = Json::array();
  for (const PluginInfo& plugin : plugins) {
    if (plugin.kind != kind) continue;
    ids.push_back(plugin.id);
    rules.push_back({{"if", {{"properties", {{"plugin", {{"const", plugin.id}}}}}}},
                     {"then", {{"properties", {{"params", {{"$ref", "#/definitions/" + plugin.id}}}}}}}});
  }
  properties["plugin"] = {{"enum", ids}};
  properties["params"] = {{"type", "object"}};
  required.insert(required.begin(), "plugin");
  Json s = {{"type", "object"}, {"required", required}};
  s["properties"] = std::move(properties);
  s["patternProperties"] = note_pattern();
  s["additionalProperties"] = false;
  if (!rules.empty()) s["allOf"] = std::move(rules);
  return s;
}

Json closed(Json properties, const std::vector<std::string>& required) {
  Json s = {{"type", "object"}};
  if (!required.empty()) s["required"] = required;
  s["properties"] = std::move(properties);
  s["patternProperties"] = note_pattern();
  s["additionalProperties"] = false;
  return s;
}

Json three(const std::string& unit) {
  return {{"type", "array"},
          {"items", quantity_schema(unit, -INFINITY, INFINITY)},
          {"minItems", 3},
          {"maxItems", 3}};
}

Json list(Json items) { return {{"type", "array"}, {"items", std::move(items)}}; }

Json pose_schema() {
  const Json four = {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 4}, {"maxItems", 4}};
  return closed({{"p", three("m")}, {"q", four}, {"rpy", three("rad")}}, {});
}

Json filters_schema() {
  const Json bits = list({{"type", "integer"}, {"minimum", 0}, {"maximum", 31}});
  return closed({{"rate", quantity_schema("Hz", 0, 1e3)},
                 {"low_pass", quantity_schema("Hz", 0, 500)},
                 {"dead_band", quantity_schema("m", 0, 0.1)},
                 {"dead_turn", quantity_schema("rad", 0, 1)},
                 {"clutch", bits},
                 {"clutch_of", {{"type", "string"}, {"pattern", "^[a-z][a-z0-9_]*$"}}}},
                {});
}

Json reaction_schema() {
  const Json point = {{"type", "array"}, {"items", quantity_schema("N", 0, 1e3)}, {"minItems", 2}, {"maxItems", 2}};
  return closed({{"law", {{"enum", {"proportional", "null zone", "threshold", "quadratic", "table"}}}},
                 {"from", quantity_schema("N", 0, 1e3)},
                 {"table", list(point)}},
                {"law"});
}

Json device_schema(const std::vector<PluginInfo>& plugins, const Json& name) {
  return use_schema(plugins, SWAGE_KIND_DEVICE,
                    {{"name", name},
                     {"as", name},
                     {"motion_scale", quantity_schema("1", 1e-3, 1e3)},
                     {"force_scale", quantity_schema("1", 0, 1e3)},
                     {"pose", pose_schema()},
                     {"filters", filters_schema()},
                     {"reaction", reaction_schema()},
                     {"or", list(use_schema(plugins, SWAGE_KIND_DEVICE, {{"as", name}}, {}))}},
                    {"name"});
}

Json environment_schema() {
  Json keys = {{"medium", {{"enum", std::vector<std::string>(std::begin(kMedia), std::end(kMedia))}}}};
  for (const EnvironmentKey& k : kEnvironmentKeys) keys[k.key] = quantity_schema(k.unit, k.min, k.max);
  return closed(keys, {"medium"});
}

}  // namespace

std::string params_schema(const PluginInfo& plugin) {
  Json s = {{"$schema", kDraft}, {"$id", plugin.id + " " + plugin.version}};
  s.update(params_object(plugin));
  return s.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string lesson_schema(const std::vector<PluginInfo>& plugins) {
  const Json text = {{"type", "string"}};
  const Json name = {{"type", "string"}, {"pattern", "^[a-z][a-z0-9_]*$"}};
  const Json follows = closed({{"pose", text}, {"closure", text}}, {});
  const Json pair = {{"type", "array"}, {"items", text}, {"minItems", 2}, {"maxItems", 2}};
  const Json object = use_schema(plugins, SWAGE_KIND_OBJECT,
                                 {{"name", name}, {"follows", follows}, {"pose", pose_schema()}}, {"name"});
  const Json coupling =
      use_schema(plugins, SWAGE_KIND_COUPLING, {{"name", name}, {"between", pair}}, {"between"});

  Json s = {{"$schema", kDraft}, {"$id", "swage-lesson/1"}, {"title", "Swage lesson"}};
  s.update(closed({{"format", {{"const", "swage-lesson/1"}}},
                   {"id", text},
                   {"title", text},
                   {"summary", text},
                   {"goal", text},
                   {"reset", closed({{"label", {{"type", "string"}, {"minLength", 1}, {"maxLength", 24}}}, {"tip", text}}, {"label"})},
                   {"seed", {{"type", "integer"}, {"minimum", 0}}},
                   {"rate_hz", quantity_schema("Hz", 200, 10000)},
                   {"scene_length", quantity_schema("m", 1e-6, 10)},
                   {"gravity", three("m/s2")},
                   {"environment", environment_schema()},
                   {"max_time", quantity_schema("s", 0, 86400)},
                   {"mirror", {{"type", "boolean"}}},
                   {"tips_only", {{"type", "boolean"}}},
                   {"view", {{"enum", snapshot::kViews}}},
                   {"pull", closed({{"load", quantity_schema("N", 1e-3, 10)}, {"points", {{"type", "number"}, {"minimum", 0}, {"maximum", 60}}}}, {"load"})},
                   {"mode", {{"enum", {"practice", "test", "demo"}}}},
                   {"cues", list({{"enum", {"colour", "shape", "sound", "force"}}})},
                   {"requires", {{"type", "object"}, {"additionalProperties", text}}},
                   {"devices", list(device_schema(plugins, name))},
                   {"objects", list(object)},
                   {"couplings", list(coupling)},
                   {"lesson", use_schema(plugins, SWAGE_KIND_LESSON, Json::object(), {})},
                   {"based_on", text},
                   {"remove", list(text)},
                   {"add", closed({{"objects", list(object)}, {"couplings", list(coupling)}, {"devices", list(device_schema(plugins, name))}}, {})},
                   {"set", {{"type", "object"}, {"propertyNames", {{"pattern", "^[a-z][a-z0-9_]*\\."}}}}}},
                  {"format", "id", "title"}));
  // a complete lesson, or one based on another with its own parts and values
  const Json parts = {"devices", "objects", "couplings", "lesson", "requires"};
  Json none = Json::object();
  for (const Json& part : parts) none[part.get<std::string>()] = false;
  s["if"] = {{"required", {"based_on"}}};
  s["then"] = {{"properties", none}};
  s["else"] = {{"required", {"objects", "lesson"}}, {"properties", {{"set", false}, {"add", false}, {"remove", false}}}};
  Json& definitions = s["definitions"] = Json::object();
  for (const PluginInfo& plugin : plugins) definitions[plugin.id] = params_object(plugin);
  return s.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace swage::host
