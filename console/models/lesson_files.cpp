// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/lesson_files.hpp"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QObject>
#include <QRegularExpression>
#include <nlohmann/json.hpp>
#include <set>

#include "assembly/lesson_file.hpp"
#include "assembly/lesson_text.hpp"
#include "console/models/said.hpp"
#include "console/models/variant.hpp"

namespace swage::console {
namespace {

using Json = nlohmann::ordered_json;

// All files that the lesson gives to its plugins by parameters of type FILE.
std::set<std::string> files_of(const assembly::LessonFile& lesson, const host::Catalogue& catalogue) {
  std::set<std::string> out;
  const auto take = [&](const assembly::PluginUse& use) {
    const host::PluginInfo* plugin = catalogue.find(use.plugin);
    const Json params = Json::parse(use.params, nullptr, false);
    if (plugin == nullptr || !params.is_object()) return;
    for (const host::Param& p : plugin->params)
      if (p.type == SWAGE_PARAM_FILE && params.contains(p.id) && params[p.id].is_string()) out.insert(params[p.id].get<std::string>());
  };
  for (const assembly::LessonDevice& device : lesson.devices)
    for (const assembly::DeviceChoice& choice : device.choices) take(choice);
  for (const assembly::LessonObject& object : lesson.objects) take(object);
  for (const assembly::LessonCoupling& coupling : lesson.couplings) take(coupling);
  take(lesson.lesson);
  return out;
}

// Searches beside the lesson, then in the local series, then in the folder of that name next to them.
QString find_file(const QString& name, const QString& beside, const QStringList& series) {
  const QString in_folder = QStringLiteral("../") + name.section(QLatin1Char('/'), -2);
  QStringList candidates{QDir(beside).absoluteFilePath(name)};
  for (const QString& folder : series) candidates += {QDir(folder).absoluteFilePath(name), QDir(folder).absoluteFilePath(in_folder)};
  for (const QString& path : candidates)
    if (QFileInfo(path).isFile()) return QFileInfo(path).canonicalFilePath();
  return {};
}

std::string as_json(const QString& text) { return Json(text.toStdString()).dump(); }

// The text keeps its lines, so that the line of an error is right.
std::string with_files_in_full(const assembly::LessonFile& lesson, const QStringList& series, const host::Catalogue& catalogue) {
  const QString beside = QString::fromStdString(lesson.folder());
  QString text = QString::fromStdString(lesson.text);
  for (const std::string& file : files_of(lesson, catalogue)) {
    const QString name = QString::fromStdString(file), found = find_file(name, beside, series);
    if (!found.isEmpty()) text.replace(QString::fromStdString(as_json(name)), QString::fromStdString(as_json(found)));
  }
  return text.toStdString();
}

// A derived lesson is built from a text merged with its base, whose lines are not the file's. The file itself, read in its
// place, gives the same errors with its own lines; where it does not, no line is given.
base::Problems where_the_file_has_it(const base::Problems& problems, const QString& file, const assembly::LessonFile& lesson,
                                     const LessonBuilder& build) {
  QFile own(file);
  if (own.open(QIODevice::ReadOnly) && own.readAll().toStdString() == lesson.text) return problems;
  base::Problems there;
  const base::Problem* error = first_error(problems);
  const bool fails = error != nullptr && build(file, there) == nullptr;
  const base::Problem* same = first_error(there);
  if (fails && same != nullptr && same->message == error->message && same->where.starts_with(file.toStdString())) return there;
  there = problems;
  for (base::Problem& p : there) p.where.clear();
  return there;
}

}  // namespace

const base::Problem* first_error(const base::Problems& problems) {
  for (const base::Problem& p : problems)
    if (p.severity == base::Severity::kError) return &p;
  return nullptr;
}

QString problem_words(const base::Problems& problems, const QString& file) {
  QStringList words;
  for (const base::Problem& p : problems) {
    if (p.severity != base::Severity::kError) continue;
    const auto line = QRegularExpression(QStringLiteral(":(\\d+)(?: #|$)")).match(QString::fromStdString(p.where));
    const QString name = QFileInfo(file).fileName();
    words += line.hasMatch() ? QObject::tr("%1, line %2: %3").arg(name, line.captured(1), said_message(p.message))
                             : QObject::tr("%1: %2").arg(name, said_message(p.message));
  }
  if (words.isEmpty()) return {};
  const auto more = words.size() - 1;
  return more == 0 ? words.front() : words.front() + QLatin1Char(' ') + (more == 1 ? QObject::tr("And one more.") : QObject::tr("And %1 more.").arg(more));
}

QString export_lesson(const QString& lesson_path, const QString& file) {
  assembly::LessonText lesson;
  base::Problems problems;
  if (!assembly::read_lesson_text(lesson_path.toStdString(), {}, lesson, problems) || base::failed(problems))
    return problem_words(problems, lesson_path);
  return write_whole(file, QByteArray::fromStdString(lesson.text));
}

Imported import_lesson(const QString& file, const ImportPlaces& places, const host::Catalogue& catalogue, const LessonBuilder& build) {
  assembly::LessonFile lesson;
  base::Problems problems;
  if (!assembly::read_lesson_file(file.toStdString(), lesson, problems) || base::failed(problems))
    return {{}, problem_words(problems, file)};
  const QByteArray text = QByteArray::fromStdString(with_files_in_full(lesson, places.series, catalogue));
  if (!QDir().mkpath(QFileInfo(places.draft).absolutePath()) || !QDir().mkpath(places.own))
    return {{}, QObject::tr("The folder %1 cannot be made.").arg(places.own)};
  if (const QString problem = write_whole(places.draft, text); !problem.isEmpty()) return {{}, problem};
  const bool can = build(places.draft, problems) != nullptr;
  QFile::remove(places.draft);
  if (!can) return {{}, problem_words(where_the_file_has_it(problems, file, lesson, build), file)};
  const QString title = QString::fromStdString(lesson.title);
  const QString path = places.own + QLatin1Char('/') + slug(title) + QStringLiteral(".json");
  if (QFileInfo::exists(path)) return {{}, QObject::tr("There is a lesson called \"%1\" among your own already; delete or rename it first.").arg(title)};
  const QString problem = write_whole(path, text);
  return problem.isEmpty() ? Imported{path, {}} : Imported{{}, problem};
}

}  // namespace swage::console
