// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Lessons that go to another station, and come from one: each is one file, whole.
#pragma once

#include <QString>
#include <QStringList>
#include <functional>
#include <memory>

#include "base/problem.hpp"
#include "host/catalogue.hpp"
#include "snapshot/scene_card.hpp"

namespace swage::console {

/// Writes a lesson with all that it has of those that it is based on. Files that its plugins name, as an expert's hand, are looked
/// for where it is imported. Returns why not, or "".
QString export_lesson(const QString& lesson_path, const QString& file);

struct ImportPlaces {
  QString own;          // where lessons of one's own are
  QString draft;        // a file to build the lesson from before it is taken in
  QStringList series;   // folders of lessons that are here: files named by the lesson are looked for from there, too
};
/// Builds the lesson of a file; nullptr and why not.
using LessonBuilder = std::function<std::unique_ptr<snapshot::SceneCard>(const QString& path, base::Problems& problems)>;

struct Imported {
  QString path, problem;  // the lesson's own file, or "file, line 7: what is wrong"
};
/// Takes a lesson file in among one's own, once it could be built.
Imported import_lesson(const QString& file, const ImportPlaces& places, const host::Catalogue& catalogue, const LessonBuilder& build);

/// The first error of these; nullptr where there are but warnings and notes.
const base::Problem* first_error(const base::Problems& problems);
/// "lesson.json, line 7: The lesson has no object "tray"." Of several the first, and how many more.
QString problem_words(const base::Problems& problems, const QString& file);

}  // namespace swage::console
