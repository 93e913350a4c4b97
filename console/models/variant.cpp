// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/variant.hpp"

#include <QDir>
#include <QFileInfo>
#include <QObject>
#include <QSaveFile>
#include <QStandardPaths>
#include <nlohmann/json.hpp>

namespace swage::console {

using Json = nlohmann::ordered_json;

QString own_lessons_folder() {
  return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
         QStringLiteral("/swage/lessons");
}

QString slug(const QString& title) {
  QString out;
  for (const QChar c : title.normalized(QString::NormalizationForm_KD).toLower()) {
    if (c.isMark()) continue;  // an accent
    const bool plain =
        (c >= QLatin1Char('a') && c <= QLatin1Char('z')) || (c >= QLatin1Char('0') && c <= QLatin1Char('9'));
    if (plain)
      out += c;
    else if (!out.isEmpty() && !out.endsWith(QLatin1Char('_')))
      out += QLatin1Char('_');
  }
  while (out.endsWith(QLatin1Char('_'))) out.chop(1);
  return out.isEmpty() ? QStringLiteral("lesson") : out;
}

QByteArray variant_text(const Variant& variant, const QString& folder) {
  // what lies below one roof may move together; all else is named in full
  const QString relative = QDir(folder).relativeFilePath(variant.base);
  const bool near = !relative.startsWith(QLatin1String(".."));
  Json file;
  file["format"] = "swage-lesson/1";
  file["based_on"] = (near ? relative : QFileInfo(variant.base).absoluteFilePath()).toStdString();
  file["id"] = "own." + slug(variant.title).toStdString();
  file["title"] = variant.title.trimmed().toStdString();
  if (!variant.summary.isEmpty()) file["summary"] = variant.summary.toStdString();
  if (!variant.goal.isEmpty()) file["goal"] = variant.goal.toStdString();
  for (const auto& [what, value] : variant.set) file["set"][what] = Json::parse(value, nullptr, false);
  return QByteArray::fromStdString(file.dump(2, ' ', false, Json::error_handler_t::replace)) + '\n';
}

Saved save_variant(const Variant& variant, const QString& folder) {
  if (variant.title.trimmed().isEmpty()) return {{}, QObject::tr("A lesson has a title.")};
  if (!QDir().mkpath(folder)) return {{}, QObject::tr("The folder %1 cannot be made.").arg(folder)};
  const QString path = folder + QLatin1Char('/') + slug(variant.title) + QStringLiteral(".json");
  if (QFileInfo::exists(path))
    return {{}, QObject::tr("There is a lesson of that title already; give it another.")};
  QSaveFile file(path);
  const QByteArray text = variant_text(variant, QFileInfo(path).absolutePath());
  if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.commit())
    return {{}, QObject::tr("%1 cannot be written: %2").arg(path, file.errorString())};
  return {path, {}};
}

}  // namespace swage::console
