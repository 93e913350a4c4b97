// SPDX-License-Identifier: LGPL-3.0-or-later
#include <signal.h>

#include <QApplication>
#include <QTemporaryDir>
#include <cstdio>
#include <cstdlib>

#include "console/app/application.hpp"
#include "console/app/command_line.hpp"
#include "console/app/end_signals.hpp"
#include "console/app/language.hpp"
#include "console/app/main_window.hpp"
#include "console/app/screenshot.hpp"
#include "console/app/session_player.hpp"
#include "console/models/lessons_model.hpp"
#include "record/address.hpp"
#include "session/bounded_call.hpp"
#include "session/knot_copy.hpp"

using namespace swage;

namespace {

// an unknown language ends the program with the list of known ones
void choose_language() {
  const QString wanted = console::wanted_language(QCoreApplication::arguments(), console::Settings());
  if (console::use_language(wanted)) return;
  std::fprintf(stderr, "swage-console: --language: \"%s\" is not there; allowed are %s.\n", qPrintable(wanted),
               qPrintable(console::languages().join(QStringLiteral(", "))));
  std::exit(2);
}

// real sessions, stores and files; tests use doubles
console::Services services_of(const session::Options& options) {
  console::Services services;
  services.open_session = &session::Session::open;
  services.open_expert = &console::open_session_expert;
  if (options.store_path != ":none:") {
    services.open_store = [where = options.store_path](std::string& error) {
      return record::Store::open_as_allowed(where, error);
    };
    services.open_school = [where = options.store_path](std::string& error) {
      return record::School::open(where, error);
    };
  }
  if (record::is_postgres(options.store_path))
    services.open_stations = [where = options.store_path](std::string& error) { return record::Stations::open(where, error); };
  services.read_recording = [where = options.store_path](const std::string& id, record::Recording& out,
                                                      std::string& error) {
    return record::read_recording(where.empty() ? record::Store::default_path() : where, id, out, error);
  };
  services.read_export = [where = options.store_path](const std::string& file, const record::Selection& which,
                                                   std::vector<record::Exported>& out, std::string& error) {
    return record::read_for_export(file.empty() ? where : file, which, out, error);
  };
  services.open_player = [dirs = options.plugin_dirs](const record::Recording& recording,
                                                   base::Problems& problems) {
    return console::open_session_player(recording, dirs, console::lesson_file(session::kPullLesson).toStdString(), problems);
  };
  services.open_file = [](const std::string& file, std::string& error) {
    return record::Store::open_to_read(file, error);
  };
  services.read_file = [](const std::string& file, const std::string& id, record::Recording& out, std::string& error) {
    return record::read_recording(file, id, out, error);
  };
  return services;
}

int run(int argc, char** argv) {
  // a file beyond the size limit (RLIMIT_FSIZE) becomes a write error with its sentence instead of ending the program
  signal(SIGXFSZ, SIG_IGN);
  if (console::asks_for_text(argc, argv)) {
    QCoreApplication text_only(argc, argv);
    console::name_application();
    choose_language();
    console::read_command_line(QCoreApplication::arguments());
    return 0;
  }
  console::prepare_graphics();
  console::expect_display();
  QApplication app(argc, argv);
  console::display_is_there();
  console::prepare_application();
  choose_language();
  console::Launch launch = console::read_command_line(app.arguments());
  launch.options.pull_lesson = console::lesson_file(session::kPullLesson).toStdString();

  // a screenshot for the documentation uses the default settings
  const QTemporaryDir own;
  if (!launch.screenshot.isEmpty()) launch.settings_file = own.filePath(QStringLiteral("settings.ini"));

  console::MainWindow window(services_of(launch.options), launch);
  const console::EndSignals signals([&window] { window.leave(); });
  window.show();
  if (!launch.screenshot.isEmpty()) {
    new console::Screenshot(&window, launch.screenshot, launch.screenshot_at_s, launch.start);
  }
  return app.exec();
}

}  // namespace

int main(int argc, char** argv) { return session::end_program(run(argc, argv)); }
