// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A lesson that an instructor derives from another: a file that names its base, removes parts, adds others and sets values
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
  QString base;  // path of the base lesson
  QString title, summary, goal;
  QVector<std::pair<std::string, std::string>> set;  // "needle.arc" and JSON
  std::vector<std::string> remove = {};              // names of objects, couplings and devices
  nlohmann::ordered_json add = {};                   // { "objects": [...], "couplings": [...], "devices": [...] }; null for nothing
  QString view = {};                                 // from where the trainee looks first; "": as the base says

  bool operator==(const Variant&) const = default;
};

/// Folder of the user's own lessons, which is searched by default.
QString own_lessons_folder();
/// Folder of drafts during an edit, so that nothing is lost when the program ends.
QString lesson_drafts_folder();

/// "Stiff wall, 2/8" -> "stiff_wall_2_8": file name and id from a title; "lesson" when nothing is left of it.
QString slug(const QString& title);

/// The key "view" of a lesson file itself, not of its base; "" without one.
QString view_in(const QString& path);

/// The file's text. `folder`: its destination; the base is named relative to it.
QByteArray variant_text(const Variant& variant, const QString& folder);

/// Parses such a text; no value for other texts. The base is returned as written there.
std::optional<Variant> read_variant(const QByteArray& text);

/// Writes <folder>/<slug>.json atomically. `problem`: the error, such as no title, an existing file, a full disk.
struct Saved {
  QString path, problem;
};
Saved save_variant(const Variant& variant, const QString& folder);

/// Whether a lesson is the user's own: a file in that folder, which may be edited and deleted.
bool is_own_lesson(const QString& path, const QString& folder = own_lessons_folder());

/// Writes title, task, goal, parts and values into one of the user's own lessons, derived or not, atomically; `base` is
/// ignored. The id and all else in the file stay: attempts refer to the id. Returns "" or the error.
QString update_variant(const QString& path, const Variant& changed);

/// Titles of the lessons in a folder that are derived from this one and could not run without it.
QStringList based_on_it(const QString& path, const QString& folder = own_lessons_folder());

/// Writes a file atomically. Returns "" or the error.
QString write_whole(const QString& path, const QByteArray& text);

/// Moves one of the user's own lessons to the desktop's bin, from which it can be restored. Returns "" or the error.
QString delete_lesson(const QString& path);

}  // namespace swage::console
