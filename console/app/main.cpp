// SPDX-License-Identifier: LGPL-3.0-or-later
#include <QApplication>
#include <QTemporaryDir>

#include "console/app/application.hpp"
#include "console/app/command_line.hpp"
#include "console/app/main_window.hpp"
#include "console/app/screenshot.hpp"

using namespace swage;

int main(int argc, char** argv) {
  console::prepare_graphics();
  QApplication app(argc, argv);
  console::prepare_application();
  console::Launch launch = console::read_command_line(app.arguments());

  // a picture for the documentation shows the program as it is delivered
  const QTemporaryDir own;
  if (!launch.screenshot.isEmpty()) launch.settings_file = own.filePath(QStringLiteral("settings.ini"));

  console::Doors doors;
  doors.open_session = &session::Session::open;
  if (launch.options.store_path != ":none:") {
    doors.open_store = [where = launch.options.store_path](std::string& error) {
      return record::Store::open(where, error);
    };
  }
  console::MainWindow window(std::move(doors), launch);
  window.show();
  if (!launch.screenshot.isEmpty()) {
    new console::Screenshot(&window, launch.screenshot, launch.screenshot_at_s, launch.start);
  }
  return app.exec();
}
