// SPDX-License-Identifier: Apache-2.0
//
// The window on a fake session, for visual inspection without physics: preview theme cues out_prefix
#include <QApplication>
#include <QTemporaryDir>
#include <QTimer>

#include "console/app/application.hpp"
#include "console/app/main_window.hpp"
#include "fake_session.hpp"
#include "test_places.hpp"

using namespace swage;

int main(int argc, char** argv) {
  console::prepare_graphics();
  QApplication app(argc, argv);
  console::prepare_application();
  auto log = std::make_shared<test::FakeLog>();
  console::Launch launch;
  const QTemporaryDir own;
  launch.settings_file = own.filePath(QStringLiteral("settings.ini"));
  launch.lesson_folders = {QStringLiteral(SWAGE_SOURCE_DIR "/tests/console/lessons")};
  console::MainWindow window(
      {[&](const session::Options& o, base::Problems& p) { return test::open_fake(o, p, {}, log); },
       {},
       {},
       {},
       {},
       {}},
      launch);
  const QStringList args = app.arguments();
  window.set_theme(args.value(1, QStringLiteral("light")), args.value(2, QStringLiteral("thesis")));
  window.show();
  int n = 0;
  QTimer timer;
  timer.start(2300);
  QObject::connect(&timer, &QTimer::timeout, [&] {
    window.grab().save(args.value(3) + QString::number(n) + QStringLiteral(".png"));
    if (n == 0) window.run_page()->start();
    if (++n == 7) app.quit();
  });
  return app.exec();
}
