// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/variant.hpp"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QObject>
#include <QSaveFile>
#include <QStandardPaths>
#include <nlohmann/json.hpp>

#include "console/models/said.hpp"
#include "assembly/parts.hpp"
#include "assembly/settings.hpp"

namespace swage::console {

using Json = nlohmann::ordered_json;

namespace {

QByteArray as_text(const Json& file) {
  return QByteArray::fromStdString(file.dump(2, ' ', false, Json::error_handler_t::replace)) + '\n';
}

std::string text_of(const Json& object, const char* key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

bool is_list_or_none(const Json& file, const char* key, Json::value_t type) { return !file.contains(key) || file[key].type() == type; }

// A part added by the file itself is deleted there; a part of the base is listed as removed.
void remove_from(Json& file, const std::string& name) {
  for (auto& [list, parts] : file["add"].items())
    for (std::size_t i = 0; parts.is_array() && i < parts.size(); ++i)
      if (text_of(parts[i], "name") == name) return parts.erase(i), void();
  file["remove"].push_back(name);
}

void drop_values_of(Json& file, const std::string& name) {
  if (!file.contains("set")) return;
  Json kept = Json::object();
  for (const auto& [what, value] : file["set"].items())
    if (!what.starts_with(name + ".")) kept[what] = value;
  file["set"] = kept;
}

void change_based(Json& file, const Variant& changed) {
  for (const std::string& name : changed.remove) {
    remove_from(file, name);
    drop_values_of(file, name);
  }
  for (const auto& [list, parts] : changed.add.items())
    for (const Json& part : parts) file["add"][list].push_back(part);
  for (const char* key : {"add", "remove"})
    if (file[key].empty()) file.erase(key);
  for (const auto& [what, value] : changed.set) file["set"][what] = Json::parse(value, nullptr, false);
}

// Changes a lesson without a base, whose parts and values are in the file itself. Returns "" or the error.
QString change_whole(Json& file, const Variant& changed) {
  assembly::Places none;
  base::Problems problems;
  std::vector<std::string> pointers;
  if (!changed.remove.empty()) assembly::remove_parts({changed.remove, none, ""}, file, none, problems);
  if (!changed.add.empty()) assembly::add_parts({changed.add, none, ""}, file, none, problems);
  for (const auto& [what, value] : changed.set) assembly::set_in(file, {what, value}, "", problems, pointers);
  return problems.empty() ? QString() : said_message(problems.front().message);
}

}  // namespace

QString write_whole(const QString& path, const QByteArray& text) {
  QSaveFile file(path);
  if (file.open(QIODevice::WriteOnly) && file.write(text) == text.size() && file.commit()) return {};
  return QObject::tr("%1 cannot be written: %2").arg(path, file.errorString());
}

QString lesson_drafts_folder() {
  return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) + QStringLiteral("/swage/drafts");
}

QString own_lessons_folder() {
  return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
         QStringLiteral("/swage/lessons");
}

QString slug(const QString& title) {
  QString out;
  for (const QChar c : title.normalized(QString::NormalizationForm_KD).toLower()) {
    if (c.isMark()) continue;  // combining accents
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

QString view_in(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return {};
  const QByteArray text = file.readAll();
  const Json json = Json::parse(text.begin(), text.end(), nullptr, false, true);
  return json.is_object() ? QString::fromStdString(text_of(json, "view")) : QString();
}

QByteArray variant_text(const Variant& variant, const QString& folder) {
  // a base within the same folder tree is named relatively, as both may be moved together; any other by its full path
  const QString relative = QDir(folder).relativeFilePath(variant.base);
  const bool near = !relative.startsWith(QLatin1String(".."));
  Json file;
  file["format"] = "swage-lesson/1";
  file["based_on"] = (near ? relative : QFileInfo(variant.base).absoluteFilePath()).toStdString();
  file["id"] = "own." + slug(variant.title).toStdString();
  file["title"] = variant.title.trimmed().toStdString();
  if (!variant.summary.isEmpty()) file["summary"] = variant.summary.toStdString();
  if (!variant.goal.isEmpty()) file["goal"] = variant.goal.toStdString();
  if (!variant.view.isEmpty()) file["view"] = variant.view.toStdString();
  if (!variant.remove.empty()) file["remove"] = variant.remove;
  if (!variant.add.empty()) file["add"] = variant.add;
  for (const auto& [what, value] : variant.set) file["set"][what] = Json::parse(value, nullptr, false);
  return as_text(file);
}

std::optional<Variant> read_variant(const QByteArray& text) {
  const Json file = Json::parse(text.begin(), text.end(), nullptr, false, true);
  if (!file.is_object() || text_of(file, "based_on").empty()) return std::nullopt;
  if (!is_list_or_none(file, "set", Json::value_t::object) || !is_list_or_none(file, "add", Json::value_t::object) ||
      !is_list_or_none(file, "remove", Json::value_t::array))
    return std::nullopt;
  const auto words = [&](const char* key) { return QString::fromStdString(text_of(file, key)); };
  Variant out{words("based_on"), words("title"), words("summary"), words("goal"), {}};
  out.view = words("view");
  if (file.contains("add")) out.add = file["add"];
  const Json removed = file.value("remove", Json::array()), set = file.value("set", Json::object());
  for (const Json& name : removed)
    if (name.is_string()) out.remove.push_back(name.get<std::string>());
  for (const auto& [what, value] : set.items()) out.set.append({what, value.dump()});
  return out;
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
  const bool editable = file.is_object() && is_list_or_none(file, "set", Json::value_t::object) &&
                        is_list_or_none(file, "add", Json::value_t::object) && is_list_or_none(file, "remove", Json::value_t::array);
  if (!editable) return QObject::tr("%1 is no lesson that can be edited here.").arg(path);
  file["title"] = changed.title.trimmed().toStdString();
  for (const auto& [key, words] : {std::pair{"summary", changed.summary}, {"goal", changed.goal}})
    if (!words.isEmpty() || file.contains(key)) file[key] = words.toStdString();
  if (changed.view.isEmpty())
    file.erase("view");
  else
    file["view"] = changed.view.toStdString();
  if (file.contains("based_on"))
    change_based(file, changed);
  else if (const QString problem = change_whole(file, changed); !problem.isEmpty())
    return problem;
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
