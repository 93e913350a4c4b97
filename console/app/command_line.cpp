// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/app/command_line.hpp"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>

#include "console/models/lessons_model.hpp"

namespace swage::console {
namespace {

QCommandLineOption option(const char* name, const char* text, const char* value = "") {
  return {QString::fromLatin1(name), QCoreApplication::translate("command_line", text),
          QString::fromLatin1(value)};
}

// Recognises an attempt file by its name or by its first bytes. No store is open yet, so that closing the file releases no lock.
bool is_attempt(const QString& path) {
  if (path.endsWith(QLatin1String(".swage"), Qt::CaseInsensitive)) return true;
  QFile file(path);
  return QFileInfo(path).isFile() && file.open(QIODevice::ReadOnly) && file.read(15) == "SQLite format 3";
}

QList<QCommandLineOption> all_options() {
  return {
      option("start", QT_TRANSLATE_NOOP("command_line", "Start the lesson at once.")),
      option("device", QT_TRANSLATE_NOOP("command_line", "The hand: mouse, expert, a plugin id, or a name from the lesson."), "device"),
      option("person", QT_TRANSLATE_NOOP("command_line", "Who practises."), "name"),
      option("mode", QT_TRANSLATE_NOOP("command_line", "practice, test or demo."), "mode"),
      option("plugin-dir", QT_TRANSLATE_NOOP("command_line", "Folder to look for plugins in first; may be repeated."), "folder"),
      option("store", QT_TRANSLATE_NOOP("command_line", "Attempts database: a file, postgresql://user@host/database, or :none:."), "store"),
      option("station", QT_TRANSLATE_NOOP("command_line", "What this station is called among those of the school; the machine's name unless given."), "name"),
      option("safe-mode", QT_TRANSLATE_NOOP("command_line", "Stock plugins only.")),
      option("seed",
             QT_TRANSLATE_NOOP("command_line", "Seed of every attempt, so that targets and tremor are the same again; otherwise each attempt draws its own."),
             "number"),
      option("language", QT_TRANSLATE_NOOP("command_line", "en or de; that of the system unless given."), "language"),
      option("theme", QT_TRANSLATE_NOOP("command_line", "light, dark or contrast."), "theme"),
      option("cues", QT_TRANSLATE_NOOP("command_line", "thesis or safe: colours of the cues."), "cues"),
      option("view", QT_TRANSLATE_NOOP("command_line", "orbit, side, top or near."), "view"),
      option("zoom", QT_TRANSLATE_NOOP("command_line", "Notches of the wheel by which the --view of a --review is nearer; below 0 farther."), "notches"),
      option("trainee", QT_TRANSLATE_NOOP("command_line", "Show the trainee's view, for two eyes: side, over, lines, checker, anaglyph, grey, least, shutter, one, left or right."), "layout"),
      option("page", QT_TRANSLATE_NOOP("command_line", "run, lessons, courses, people, review, setup or stations."), "page"),
      option("review", QT_TRANSLATE_NOOP("command_line", "Open a recorded attempt: its id, or latest."), "attempt"),
      option("compare", QT_TRANSLATE_NOOP("command_line", "Beside the recorded attempt another one at the same lesson: its id."), "attempt"),
      option("size", QT_TRANSLATE_NOOP("command_line", "Size of the window, as in 1440x900."), "size"),
      option("screenshot", QT_TRANSLATE_NOOP("command_line", "Write a picture of the window (with --trainee: of the trainee's) and quit."),
             "file.png"),
      option("at", QT_TRANSLATE_NOOP("command_line", "When: seconds into the attempt, or after the window is there."), "seconds"),
  };
}

// given options replace the defaults
void take_options(const QCommandLineParser& parser, Launch& launch) {
  const auto text = [&](const char* name) { return parser.value(QString::fromLatin1(name)); };
  const auto given = [&](const char* name) { return parser.isSet(QString::fromLatin1(name)); };
  for (const QString& dir : parser.values(QStringLiteral("plugin-dir")))
    launch.options.plugin_dirs.push_back(dir.toStdString());
  launch.options.device = text("device").toStdString();
  launch.device_given = given("device");
  if (given("person")) launch.options.person = text("person").toStdString();
  launch.person_given = given("person");
  if (given("mode")) launch.options.mode = text("mode").toStdString();
  launch.mode_given = given("mode");
  launch.options.store_path = text("store").toStdString();
  launch.options.safe_mode = given("safe-mode");
  if (given("seed")) launch.options.settings.push_back("seed=" + text("seed").toStdString());
  // a screenshot must be reproducible: its seed is fixed
  launch.draws_seed = !given("seed") && !given("screenshot");
  launch.start = given("start");
  launch.station = text("station");
  launch.theme = text("theme");
  launch.language = text("language");
  launch.cues = text("cues");
  launch.view = text("view");
  launch.zoom = text("zoom").toFloat();
  launch.trainee = text("trainee");
  launch.page = text("page");
  launch.review = text("review");
  launch.compare = text("compare");
  launch.screenshot = text("screenshot");
  launch.screenshot_at_s = text("at").toDouble();
  const QStringList size = text("size").split(QLatin1Char('x'));
  if (size.size() == 2) launch.size = QSize(size[0].toInt(), size[1].toInt());
}

}  // namespace

Launch read_command_line(const QStringList& arguments) {
  QCommandLineParser parser;
  parser.setApplicationDescription(QCoreApplication::translate(
      "command_line", "Swage, the microsurgery trainer: runs lessons and shows progress."));
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument(QStringLiteral("lesson"),
                               QCoreApplication::translate("command_line", "Lesson file, or kept attempt, to open."),
                               QStringLiteral("[lesson.json | attempt.swage]"));
  parser.addOptions(all_options());
  parser.process(arguments);

  Launch launch;
  if (!parser.positionalArguments().isEmpty()) {
    const QString file = parser.positionalArguments().first();
    if (is_attempt(file))
      launch.attempt_file = file;
    else
      launch.options.lesson_path = file.toStdString();
  }
  take_options(parser, launch);
  launch.lesson_folders = lesson_folders();
  return launch;
}

}  // namespace swage::console
