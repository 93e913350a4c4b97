// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/lesson_facts.hpp"

#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>

#include "assembly/lesson_text.hpp"
#include "host/params.hpp"

namespace swage::console {

namespace {

// the checked value of one parameter of a lesson's own plugin, defaults included
std::optional<swage_value> lesson_value(const std::string& lesson_path, const char* id, const char* unit,
                                        uint32_t dimension, const host::Catalogue& catalogue) {
  assembly::LessonText whole;
  base::Problems problems;
  if (!assembly::read_lesson_text(lesson_path, {}, whole, problems)) return {};
  const QJsonObject root = QJsonDocument::fromJson(QByteArray::fromStdString(whole.text)).object();
  const QJsonObject lesson = root[QStringLiteral("lesson")].toObject();
  const host::PluginInfo* plugin = catalogue.find(lesson[QStringLiteral("plugin")].toString().toStdString());
  if (!plugin) return {};

  host::ParamSource source;
  source.plugin_id = plugin->id;
  source.folder = QFileInfo(QString::fromStdString(whole.beside)).absolutePath().toStdString();
  source.bundle_folder = plugin->bundle_dir;
  source.where = [](const std::string& pointer) { return pointer; };
  host::ParamValues values;
  const QByteArray params =
      QJsonDocument(lesson[QStringLiteral("params")].toObject()).toJson(QJsonDocument::Compact);
  if (!host::check_params(params.toStdString(), plugin->params, source, values, problems)) return {};
  for (size_t i = 0; i < plugin->params.size(); ++i) {
    const host::Param& p = plugin->params[i];
    if (p.id == id && p.unit == unit && p.dimension == dimension) return values.value[i];
  }
  return {};
}

}  // namespace

std::optional<ForceBand> force_band(const std::string& lesson_path, const host::Catalogue& catalogue) {
  if (const auto value = lesson_value(lesson_path, "force", "N", 2, catalogue))
    return ForceBand{value->number[0], value->number[1]};
  if (const auto value = lesson_value(lesson_path, "max_force", "N", 1, catalogue))
    return ForceBand{0, value->number[0]};
  return {};
}

MetricTarget metric_target(const std::string& lesson_path, const std::string& metric_id,
                           const host::Catalogue& catalogue) {
  if (metric_id == "force.peak") {
    const auto band = force_band(lesson_path, catalogue);
    return band ? MetricTarget{{}, band->high} : MetricTarget{};
  }
  // a limit of the greatest force says nothing about its mean; an interval does
  if (metric_id == "force.mean") {
    const auto value = lesson_value(lesson_path, "force", "N", 2, catalogue);
    return value ? MetricTarget{value->number[0], value->number[1]} : MetricTarget{};
  }
  static constexpr struct {
    const char *metric, *param, *unit;
  } kMost[] = {{"time", "par_time", "s"},
               {"time.task", "par_time", "s"},
               {"grasp.drops", "max_drops", "1"},
               {"insert.entry_distance", "tolerance", "m"},
               {"insert.entry_angle", "in_angle", "rad"},
               {"insert.angle", "in_angle", "rad"},
               {"insert.deflections", "max_deflections", "1"},
               {"wound.size", "max_wound", "1"}};
  for (const auto& most : kMost) {
    if (metric_id != most.metric) continue;
    if (const auto value = lesson_value(lesson_path, most.param, most.unit, 1, catalogue))
      return {{}, value->number[0]};
  }
  return {};
}

}  // namespace swage::console
