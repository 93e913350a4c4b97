// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/instrument.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "assembly/lesson_file.hpp"
#include "console/view3d/vec.hpp"
#include "host/units.hpp"

namespace swage::console {
namespace {

using Json = nlohmann::ordered_json;

const Json* member(const Json& object, const char* key) {
  const auto at = object.is_object() ? object.find(key) : object.end();
  return at != object.end() ? &*at : nullptr;
}

// three values of a lesson in SI, each a number or a text with a unit
std::optional<Vec> triple(const Json* list, const char* unit) {
  if (list == nullptr || !list->is_array() || list->size() != 3) return {};
  double v[3] = {};
  for (std::size_t i = 0; i < 3; ++i) {
    const Json& one = (*list)[i];
    std::string ignored;
    if (one.is_number())
      v[i] = one.get<double>();
    else if (!one.is_string() || !host::parse_quantity(one.get<std::string>(), unit, "A number", v[i], ignored))
      return {};
  }
  return Vec(v[0], v[1], v[2]);
}

Json list(const Vec& v) { return Json::array({v.x, v.y, v.z}); }
Vec turned_back(const swage_quat& q, const Vec& v) { return rotate({q.w, -q.x, -q.y, -q.z}, v); }

bool has_param(const host::PluginInfo* plugin, const char* id) {
  return plugin != nullptr && std::any_of(plugin->params.begin(), plugin->params.end(), [&](const host::Param& p) { return p.id == id; });
}

// The start position of the tips in the lesson, from the first of its devices that has one.
Json start_of(const assembly::LessonDevice& device) {
  for (const assembly::DeviceChoice& choice : device.choices) {
    const Json params = Json::parse(choice.params, nullptr, false);
    const auto start = triple(member(params, "start"), "m"), axis = triple(member(params, "start_axis"), "1"),
               closing = triple(member(params, "start_closing"), "1");
    if (!start || !axis || !closing) continue;
    const swage_pose& X_WD = device.X_WD0;
    return {{"start", list(turned_back(X_WD.q, *start - Vec(X_WD.p)) * device.motion_scale)},
            {"start_axis", list(turned_back(X_WD.q, *axis))},
            {"start_closing", list(turned_back(X_WD.q, *closing))}};
  }
  return Json::object();
}

void require(Json& requires_, const std::string& id, const host::Catalogue& catalogue) {
  const host::PluginInfo* plugin = catalogue.find(id);
  if (plugin != nullptr) requires_[id] = "^" + plugin->version.substr(0, plugin->version.find('.'));
}

// Replaces the lesson's device by the bound one.
void bind_device(Json& devices, Json& objects, const assembly::LessonDevice& device, const Binding& binding, const host::Catalogue& catalogue) {
  const Json own = devices[0];
  const std::string& name = device.name;
  Json hand = {{"name", name}, {"plugin", binding.pose}};
  for (const char* key : {"pose", "motion_scale", "force_scale", "filters", "reaction", "coupling"})
    if (const Json* value = member(own, key)) hand[key] = *value;
  if (binding.clutch >= 0) hand["filters"]["clutch"] = Json::array({binding.clutch});
  if (has_param(catalogue.find(binding.pose), "start"))
    if (const Json start = start_of(device); !start.empty()) hand["params"] = start;
  const bool jaws = !binding.jaws.empty() && binding.jaws != binding.pose;
  if (binding.clutch >= 0 && !binding.pedal.empty() && binding.pedal != binding.pose) {
    const bool same = jaws && binding.pedal == binding.jaws;
    hand["filters"]["clutch_of"] = name + (same ? "_jaws" : "_pedal");
    if (!same) devices.push_back({{"name", name + "_pedal"}, {"plugin", binding.pedal}});
  }
  devices[0] = hand;
  if (!jaws) return;
  devices.push_back({{"name", name + "_jaws"}, {"plugin", binding.jaws}});
  for (Json& object : objects)
    if (object.contains("follows") && object["follows"].value("closure", std::string()) == name) object["follows"]["closure"] = name + "_jaws";
}

}  // namespace

Binding read_binding(const Settings& settings, const QString& person) {
  Binding out;
  const nlohmann::json all = nlohmann::json::parse(settings.text("bindings").toStdString(), nullptr, false);
  const std::string who = person.toStdString();
  if (!all.is_object() || !all.contains(who)) return out;
  try {
    const auto& one = all.at(who);
    out = {one.at("pose"), one.at("jaws"), one.at("clutch"), one.value("pedal", std::string())};
  } catch (const nlohmann::json::exception&) {
    // treated as no choice
  }
  return out;
}

void remember(const Binding& binding, const QString& person, Settings& settings) {
  nlohmann::json all = nlohmann::json::parse(settings.text("bindings").toStdString(), nullptr, false);
  if (!all.is_object()) all = nlohmann::json::object();
  all[person.toStdString()] = {{"pose", binding.pose}, {"jaws", binding.jaws}, {"clutch", binding.clutch}, {"pedal", binding.pedal}};
  settings.set("bindings", QString::fromStdString(all.dump()));
}

std::vector<const host::PluginInfo*> held_devices(const host::Catalogue& catalogue) {
  std::vector<const host::PluginInfo*> out;
  for (const host::PluginInfo* plugin : catalogue.of_kind(SWAGE_KIND_DEVICE)) {
    const bool plays = std::any_of(plugin->params.begin(), plugin->params.end(),
                                   [](const host::Param& p) { return p.type == SWAGE_PARAM_FILE && p.required(); });
    if (!plays) out.push_back(plugin);
  }
  return out;
}

std::vector<std::string> instrument_settings(const std::string& lesson_path, const Binding& binding,
                                             const std::optional<Placement>& placement, const host::Catalogue& catalogue) {
  assembly::LessonFile lesson;
  base::Problems ignored;
  if ((!binding.any() && !placement) || !assembly::read_lesson_file(lesson_path, lesson, ignored) || lesson.devices.empty()) return {};
  const Json whole = Json::parse(lesson.text);
  Json devices = whole["devices"], objects = whole["objects"];
  assembly::LessonDevice& own = lesson.devices.front();
  if (placement) {
    const swage_pose& X = own.X_WD0 = placement->X_WD;
    devices[0]["pose"] = {{"p", {X.p.x, X.p.y, X.p.z}}, {"q", {X.q.w, X.q.x, X.q.y, X.q.z}}};
    devices[0]["motion_scale"] = own.motion_scale = placement->motion_scale;
    if (!placement->force) devices[0]["force_scale"] = 0;
  }
  if (!binding.any()) return {"devices=" + devices.dump()};
  bind_device(devices, objects, own, binding, catalogue);
  Json needs = whole.value("requires", Json::object());
  for (const std::string& id : {binding.pose, binding.jaws, binding.clutch >= 0 ? binding.pedal : std::string()})
    if (!id.empty()) require(needs, id, catalogue);
  return {"devices=" + devices.dump(), "objects=" + objects.dump(), "requires=" + needs.dump()};
}

}  // namespace swage::console
