// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/lesson_facts.hpp"

#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>

#include "host/params.hpp"

namespace swage::console {

namespace {

// the checked value of one parameter of a lesson's own plugin, defaults included
std::optional<swage_value> lesson_value(const std::string& lesson_path, const char* id, const char* unit,
                                        uint32_t dimension, const host::Catalogue& catalogue) {
  const QString path = QString::fromStdString(lesson_path);
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return {};
  const QJsonObject root = QJsonDocument::fromJson(file.readAll()).object();
  const QJsonObject lesson = root[QStringLiteral("lesson")].toObject();
  const host::PluginInfo* plugin = catalogue.find(lesson[QStringLiteral("plugin")].toString().toStdString());
  if (!plugin) return {};

  host::ParamSource source;
  source.plugin_id = plugin->id;
  source.folder = QFileInfo(path).absolutePath().toStdString();
  source.bundle_folder = plugin->bundle_dir;
  source.where = [](const std::string& pointer) { return pointer; };
  host::ParamValues values;
  base::Problems problems;
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
  const auto value = lesson_value(lesson_path, "force", "N", 2, catalogue);
  if (!value) return {};
  return ForceBand{value->number[0], value->number[1]};
}

std::optional<double> metric_target(const std::string& lesson_path, const std::string& metric_id,
                                    const host::Catalogue& catalogue) {
  const auto number = [&](const char* id, const char* unit) -> std::optional<double> {
    const auto value = lesson_value(lesson_path, id, unit, 1, catalogue);
    return value ? std::optional(value->number[0]) : std::nullopt;
  };
  if (metric_id == "force.peak" || metric_id == "force.mean") {
    const auto band = force_band(lesson_path, catalogue);
    return band ? std::optional(band->high) : std::nullopt;
  }
  if (metric_id == "time" || metric_id == "time.task") return number("par_time", "s");
  if (metric_id == "grasp.drops") return number("max_drops", "1");
  if (metric_id == "force.over_time") return number("max_over_time", "s");
  return {};
}

}  // namespace swage::console
