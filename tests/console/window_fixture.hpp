// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QTemporaryDir>
#include <QTest>
#include <memory>

#include "console/app/main_window.hpp"
#include "fake_session.hpp"
#include "fake_store.hpp"

namespace swage::test {

/// A window on a fake session and a fake store, with settings of its own.
class WindowTest : public testing::Test {
 protected:
  void open() {
    console::Doors doors;
    doors.open_session = [this](const session::Options& o, base::Problems& p) {
      return open_fake(o, p, script, log);
    };
    if (with_store) {
      doors.open_store = [this](std::string&) {
        auto store = std::make_unique<FakeStore>(attempts);
        store->to_recover = to_recover;
        return store;
      };
    }
    launch.settings_file = dir.filePath("settings.ini");
    launch.lesson_folders = {QStringLiteral(SWAGE_SOURCE_DIR "/tests/console/lessons")};
    window = std::make_unique<console::MainWindow>(std::move(doors), launch);
    window->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
    // a bare X server has no window manager that would do it
    QApplication::setActiveWindow(window.get());
  }
  console::RunPage* page() { return window->run_page(); }
  console::RunControl* control() { return page()->control(); }
  template <class W>
  W* child(const char* name) {
    W* found = window->findChild<W*>(QString::fromLatin1(name));
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  void click(const char* button) { QTest::mouseClick(child<QPushButton>(button), Qt::LeftButton); }
  bool wait_for_time(double t) {
    return QTest::qWaitFor([&] { return control()->newest() && control()->newest()->time_s >= t; }, 20000);
  }

  QTemporaryDir dir;
  FakeScript script;
  bool with_store = true;
  int to_recover = 0;
  std::vector<record::AttemptRow> attempts;
  std::shared_ptr<FakeLog> log = std::make_shared<FakeLog>();
  console::Launch launch;
  std::unique_ptr<console::MainWindow> window;
};

}  // namespace swage::test
