// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A lesson that an instructor makes of another one: a file that is based on it, leaves parts out, adds others and sets values
// (assembly/lesson_text.hpp).
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <QVector>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace swage::console {

struct Variant {
  QString base;  // path of the lesson that it is based on
  QString title, summary, goal;
  QVector<std::pair<std::string, std::string>> set;  // "needle.arc" and JSON
  std::vector<std::string> remove = {};              // names of objects, couplings and devices
  nlohmann::ordered_json add = {};                   // { "objects": [...], "couplings": [...], "devices": [...] }; null for nothing

  bool operator==(const Variant&) const = default;
};

/// Where lessons of one's own are, found without being asked for.
QString own_lessons_folder();
/// Where lessons are kept while they are edited, so that nothing is lost where the program ends.
QString lesson_drafts_folder();

/// "Stiff wall, 2/8" is "stiff_wall_2_8": of a title, for file and id; "lesson" when nothing is left of it.
QString slug(const QString& title);

/// The file's text. `folder`: where it will be; the base is named from there.
QByteArray variant_text(const Variant& variant, const QString& folder);

/// What such a text says; nothing where it is none. The base is as it is written there.
std::optional<Variant> read_variant(const QByteArray& text);

/// Writes <folder>/<slug>.json whole or not at all. `problem` says why not: no title, one of that name is there, no room.
struct Saved {
  QString path, problem;
};
Saved save_variant(const Variant& variant, const QString& folder);

/// Whether a lesson is one of one's own: a file in that folder, which may be edited and deleted.
bool is_own_lesson(const QString& path, const QString& folder = own_lessons_folder());

/// Writes title, task, goal, parts and values into a lesson of one's own, based on another or not, whole or not at all; `base` is
/// not looked at. The id and all else of the file stay: attempts refer to the id. Returns why not, or "".
QString update_variant(const QString& path, const Variant& changed);

/// The titles of lessons in a folder that are based on this one, and could not run without it.
QStringList based_on_it(const QString& path, const QString& folder = own_lessons_folder());

/// Writes a file whole or not at all. Returns why not, or "".
QString write_whole(const QString& path, const QByteArray& text);

/// Puts a lesson of one's own into the desktop's bin, from which it can be taken back. Returns why not, or "".
QString delete_lesson(const QString& path);

}  // namespace swage::console
