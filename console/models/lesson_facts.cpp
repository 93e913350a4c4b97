// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/lesson_facts.hpp"

#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>

#include "host/params.hpp"

namespace swage::console {

std::optional<ForceBand> force_band(const std::string& lesson_path, const host::Catalogue& catalogue) {
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
    if (p.id != "force" || p.unit != "N" || p.type != SWAGE_PARAM_VECTOR || p.dimension != 2) continue;
    return ForceBand{values.value[i].number[0], values.value[i].number[1]};
  }
  return {};
}

}  // namespace swage::console
