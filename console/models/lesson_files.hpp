// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Export of lessons to another station, and import from one: each lesson is one self-contained file.
#pragma once

#include <QString>
#include <QStringList>
#include <functional>
#include <memory>

#include "base/problem.hpp"
#include "host/catalogue.hpp"
#include "snapshot/scene_card.hpp"

namespace swage::console {

/// Writes a lesson merged with all its bases. Files named by its plugins, such as an expert's hand, are searched
/// where it is imported. Returns "" or the error.
QString export_lesson(const QString& lesson_path, const QString& file);

struct ImportPlaces {
  QString own;          // folder of the user's own lessons
  QString draft;        // temporary file from which the lesson is built before the import
  QStringList series;   // local lesson folders: files named by the lesson are searched there, too
};
/// Builds the lesson of a file; nullptr and the problems on failure.
using LessonBuilder = std::function<std::unique_ptr<snapshot::SceneCard>(const QString& path, base::Problems& problems)>;

struct Imported {
  QString path, problem;  // the imported file, or "file, line 7: error"
};
/// Adds a lesson file to the user's own lessons, if it can be built.
Imported import_lesson(const QString& file, const ImportPlaces& places, const host::Catalogue& catalogue, const LessonBuilder& build);

/// The first error; nullptr where there are only warnings and notes.
const base::Problem* first_error(const base::Problems& problems);
/// "lesson.json, line 7: The lesson has no object "tray"." Of several errors the first, and the number of further ones.
QString problem_words(const base::Problems& problems, const QString& file);

}  // namespace swage::console
