// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A lesson that an instructor makes of another one: a file that is based on it and sets some values (assembly/lesson_text.hpp).
#pragma once

#include <QByteArray>
#include <QString>
#include <QVector>
#include <string>
#include <utility>

namespace swage::console {

struct Variant {
  QString base;  // path of the lesson that it is based on
  QString title, summary, goal;
  QVector<std::pair<std::string, std::string>> set;  // "needle.arc" and JSON
};

/// Where lessons of one's own are, found without being asked for.
QString own_lessons_folder();

/// "Stiff wall, 2/8" is "stiff_wall_2_8": of a title, for file and id; "lesson" when nothing is left of it.
QString slug(const QString& title);

/// The file's text. `folder`: where it will be; the base is named from there.
QByteArray variant_text(const Variant& variant, const QString& folder);

/// Writes <folder>/<slug>.json whole or not at all. `problem` says why not: no title, one of that name is there, no room.
struct Saved {
  QString path, problem;
};
Saved save_variant(const Variant& variant, const QString& folder);

}  // namespace swage::console
