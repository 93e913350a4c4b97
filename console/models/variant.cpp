// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/variant.hpp"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QObject>
#include <QSaveFile>
#include <QStandardPaths>
#include <nlohmann/json.hpp>

namespace swage::console {

using Json = nlohmann::ordered_json;

namespace {

// "" or why not
QString write_whole(const QString& path, const QByteArray& text) {
  QSaveFile file(path);
  if (file.open(QIODevice::WriteOnly) && file.write(text) == text.size() && file.commit()) return {};
  return QObject::tr("%1 cannot be written: %2").arg(path, file.errorString());
}

QByteArray as_text(const Json& file) {
  return QByteArray::fromStdString(file.dump(2, ' ', false, Json::error_handler_t::replace)) + '\n';
}

}  // namespace

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
  return as_text(file);
}

Saved save_variant(const Variant& variant, const QString& folder) {
  if (variant.title.trimmed().isEmpty()) return {{}, QObject::tr("A lesson has a title.")};
  if (!QDir().mkpath(folder)) return {{}, QObject::tr("The folder %1 cannot be made.").arg(folder)};
  const QString path = folder + QLatin1Char('/') + slug(variant.title) + QStringLiteral(".json");
  if (QFileInfo::exists(path))
    return {{}, QObject::tr("There is a lesson of that title already; give it another.")};
  const QString problem = write_whole(path, variant_text(variant, QFileInfo(path).absolutePath()));
  return problem.isEmpty() ? Saved{path, {}} : Saved{{}, problem};
}

bool is_own_lesson(const QString& path, const QString& folder) {
  const QString own = QFileInfo(folder).canonicalFilePath(), file = QFileInfo(path).canonicalFilePath();
  return !own.isEmpty() && file.startsWith(own + QLatin1Char('/'));
}

QString update_variant(const QString& path, const Variant& changed) {
  if (changed.title.trimmed().isEmpty()) return QObject::tr("A lesson has a title.");
  QFile old(path);
  if (!old.open(QIODevice::ReadOnly)) return QObject::tr("%1 cannot be read: %2").arg(path, old.errorString());
  const QByteArray text = old.readAll();
  Json file = Json::parse(text.begin(), text.end(), nullptr, false, true);
  const bool sets = file.is_object() && (!file.contains("set") || file["set"].is_object());
  if (!sets) return QObject::tr("%1 is no lesson that can be edited here.").arg(path);
  file["title"] = changed.title.trimmed().toStdString();
  for (const auto& [key, words] : {std::pair{"summary", changed.summary}, {"goal", changed.goal}})
    if (!words.isEmpty() || file.contains(key)) file[key] = words.toStdString();
  for (const auto& [what, value] : changed.set) file["set"][what] = Json::parse(value, nullptr, false);
  return write_whole(path, as_text(file));
}

QStringList based_on_it(const QString& path, const QString& folder) {
  QStringList titles;
  const QString wanted = QFileInfo(path).canonicalFilePath();
  for (const QFileInfo& other : QDir(folder).entryInfoList({QStringLiteral("*.json")}, QDir::Files, QDir::Name)) {
    QFile file(other.filePath());
    if (!file.open(QIODevice::ReadOnly)) continue;
    const QByteArray text = file.readAll();
    const Json json = Json::parse(text.begin(), text.end(), nullptr, false, true);
    if (!json.is_object() || !json.contains("based_on") || !json["based_on"].is_string()) continue;
    const QString base = QString::fromStdString(json["based_on"].get<std::string>());
    if (QFileInfo(other.dir(), base).canonicalFilePath() == wanted)
      titles += json.contains("title") && json["title"].is_string()
                    ? QString::fromStdString(json["title"].get<std::string>())
                    : other.fileName();
  }
  return titles;
}

QString delete_lesson(const QString& path) {
  if (QFile::moveToTrash(path)) return {};
  return QObject::tr("%1 could not be put into the bin; nothing was deleted.").arg(path);
}

}  // namespace swage::console
