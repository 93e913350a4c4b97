// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/lessons_model.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QDirIterator>
#include <QFileInfo>
#include <QJsonDocument>
#include <QRegularExpression>
#include <algorithm>

#include "assembly/lesson_file.hpp"
#include "console/models/lesson_files.hpp"
#include "console/models/qt_text.hpp"
#include "console/models/said.hpp"
#include "console/models/variant.hpp"

namespace swage::console {

LessonEntry read_lesson(const QString& path) {
  LessonEntry entry;
  entry.path = QDir::cleanPath(QFileInfo(path).absoluteFilePath());
  entry.title = QFileInfo(path).completeBaseName();
  assembly::LessonFile lesson;
  base::Problems problems;
  assembly::read_lesson_file(path.toStdString(), lesson, problems);
  if (const base::Problem* error = first_error(problems)) {
    entry.problem = qt(error->where + ": ") + said_message(error->message);
    const QJsonDocument json = QJsonDocument::fromJson(QByteArray::fromStdString(lesson.text));
    entry.other = !json.isNull() && !json[QStringLiteral("format")].toString().startsWith(QLatin1String("swage-lesson"));
  }
  // the lesson's own translations, and those of its base
  for (const QString& file : {entry.path, qt(lesson.beside)}) learn_words(QFileInfo(file).absolutePath());
  entry.id = qt(lesson.id);
  if (!lesson.title.empty()) entry.title = qt(lesson.title);
  entry.summary = qt(lesson.summary);
  entry.mirror = lesson.mirror;
  entry.goal = qt(lesson.goal);
  entry.reset_label = qt(lesson.reset_label);
  entry.reset_tip = qt(lesson.reset_tip);
  for (const assembly::LessonDevice& device : lesson.devices) {
    // an instrument without a name is named by the last word of its plugin's id
    const assembly::DeviceChoice& first = device.choices.front();
    if (entry.hands.isEmpty() && first.as.empty() && !first.plugin.empty()) entry.hands += qt(first.plugin).section(QLatin1Char('.'), -1);
    for (const assembly::DeviceChoice& choice : device.choices)
      if (const QString as = qt(choice.as); !as.isEmpty() && !entry.hands.contains(as)) entry.hands += as;
  }
  return entry;
}

QStringList lesson_folders() {
  QStringList folders;
  const QString variable = qEnvironmentVariable("SWAGE_LESSON_PATH");
  folders += variable.split(QDir::listSeparator(), Qt::SkipEmptyParts);
  folders += own_lessons_folder();
  QDir dir(QCoreApplication::applicationDirPath());
  folders += dir.absoluteFilePath(QStringLiteral("../share/swage/lessons"));
  // started from a build folder, the sources are a few levels up
  for (int i = 0; i < 4 && dir.cdUp(); ++i) {
    if (dir.exists(QStringLiteral("lessons/series")))
      folders += dir.absoluteFilePath(QStringLiteral("lessons/series"));
  }
  return folders;
}

QString lesson_file(const QString& name) {
  for (const QString& folder : lesson_folders())
    if (QDirIterator it(folder, {name}, QDir::Files, QDirIterator::Subdirectories); it.hasNext()) return it.next();
  return {};
}

void LessonsModel::set_folders(const QStringList& folders) {
  beginResetModel();
  entries_.clear();
  for (const QString& folder : folders) {
    QStringList files;
    QDirIterator it(folder, {QStringLiteral("*.json")}, QDir::Files, QDirIterator::Subdirectories);
    while (it.hasNext())
      if (const QString file = it.next(); !it.fileName().startsWith(QLatin1String("words"))) files += file;
    files.sort();
    for (const QString& file : files) {
      const LessonEntry entry = read_lesson(file);
      // other JSON files may lie beside lessons; the first lesson of an id is used
      if (!entry.other && row_of(entry.id.isEmpty() ? entry.path : entry.id) < 0) entries_.append(entry);
    }
  }
  endResetModel();
}

int LessonsModel::add_file(const QString& path) {
  const LessonEntry entry = read_lesson(path);
  if (const int row = row_of(entry.path); row >= 0) return row;
  if (const int row = entry.id.isEmpty() ? -1 : row_of(entry.id); row >= 0) {
    entries_[row] = entry;
    Q_EMIT dataChanged(index(row), index(row));
    return row;
  }
  beginInsertRows({}, 0, 0);
  entries_.prepend(entry);
  endInsertRows();
  return 0;
}

void LessonsModel::read_again(int row) {
  entries_[row] = read_lesson(entries_[row].path);
  Q_EMIT dataChanged(index(row), index(row));
}

void LessonsModel::remove(int row) {
  beginRemoveRows({}, row, row);
  entries_.removeAt(row);
  endRemoveRows();
}

int LessonsModel::row_of(const QString& key) const {
  const auto it = std::find_if(entries_.begin(), entries_.end(), [&](const LessonEntry& e) {
    return e.path == key || (!e.id.isEmpty() && e.id == key);
  });
  return it == entries_.end() ? -1 : static_cast<int>(it - entries_.begin());
}

int LessonsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(entries_.size());
}

QVariant LessonsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= entries_.size()) return {};
  const LessonEntry& e = entries_[index.row()];
  switch (role) {
    case Qt::DisplayRole:
      return said(e.title);
    case Qt::ToolTipRole:
      return QStringList({said(e.title), said(e.summary), e.path, e.problem})
          .filter(QRegularExpression(QStringLiteral(".")))
          .join(QLatin1Char('\n'));
    case Qt::AccessibleDescriptionRole:
      return e.problem.isEmpty() ? said(e.summary) : e.problem;
    case kPath:
      return e.path;
    case kId:
      return e.id;
    case kTitle:
      return e.title;
    case kSummary:
      return said(e.summary);
    case kGoal:
      return said(e.goal);
    case kResetLabel:
      return said(e.reset_label);
    case kResetTip:
      return said(e.reset_tip);
    case kMirror:
      return e.mirror;
    case kHands:
      return e.hands;
    case kProblem:
      return e.problem;
    default:
      return {};
  }
}

}  // namespace swage::console
