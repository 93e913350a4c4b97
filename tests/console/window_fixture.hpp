// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QDialog>
#include <QMessageBox>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <memory>

#include "console/app/main_window.hpp"
#include "fake_recording.hpp"
#include "fake_session.hpp"
#include "fake_store.hpp"
#include "record/school.hpp"
#include "test_places.hpp"

namespace swage::test {

/// A window on a fake session and a fake store, with its own settings.
class WindowTest : public testing::Test {
 protected:
  void open() {
    console::Services services;
    services.open_session = [this](const session::Options& o, base::Problems& p) {
      return open_fake(o, p, script, log);
    };
    if (with_store) {
      services.open_store = [this](std::string&) {
        auto store = std::make_unique<FakeStore>(attempts);
        store->to_recover = to_recover;
        store->events_of_any = fake_events();
        store->shared = shared;
        return store;
      };
    }
    if (with_school) {
      services.open_store = [this](std::string& error) { return record::Store::open(school_file(), error); };
      services.open_school = [this](std::string& error) { return record::School::open(school_file(), error); };
    }
    services.open_stations = open_stations;
    services.open_file = [](const std::string& file, std::string& error) -> std::unique_ptr<record::Store> {
      if (file.find("damaged") != std::string::npos) error = file + " is damaged and cannot be read.";
      if (!error.empty()) return nullptr;
      return std::make_unique<FakeStore>(std::vector<record::AttemptRow>{sample_attempts().back()});
    };
    services.read_file = [this](const std::string&, const std::string&, record::Recording& out, std::string&) {
      out = fake_recording(recorded_steps);
      return true;
    };
    services.read_recording = [this](const std::string&, record::Recording& out, std::string& error) {
      out = fake_recording(recorded_steps);
      if (with_knot) out.info.script.signals.back() = {"knot", "knot.throws", "1", "Throws that are tied."};
      error = "Its file is damaged.";
      return recorded_steps > 0;
    };
    services.open_player = [this](const record::Recording& r,
                               base::Problems& problems) -> std::unique_ptr<console::Player> {
      if (!plugin_missing.empty()) {
        problems.push_back({base::Severity::kError, "lesson.json", plugin_missing});
        return nullptr;
      }
      base::Problems none;
      auto player = std::make_unique<FakePlayer>(open_fake({}, none, script, log)->card(), r.step.size());
      player->differs = differs;
      player->pull = pull;
      return player;
    };
    if (with_expert) {
      services.open_expert = [this](const session::Options& o, base::Problems& problems) -> std::unique_ptr<console::Player> {
        ++experts;
        expert_options = o;
        if (!no_expert.empty()) {
          problems.push_back({base::Severity::kError, "lesson.json", no_expert});
          return nullptr;
        }
        base::Problems none;
        return std::make_unique<FakeExpert>(open_fake({}, none, script, std::make_shared<FakeLog>())->card(), expert_passes);
      };
    }
    launch.settings_file = dir.filePath("settings.ini");
    if (launch.lesson_folders.isEmpty()) launch.lesson_folders = {QStringLiteral(SWAGE_SOURCE_DIR "/tests/console/lessons")};
    if (!first_start) launch.size = QSize(1440, 900);
    window = std::make_unique<console::MainWindow>(std::move(services), launch);
    window->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get(), kPatience_ms));
    // a bare X server has no window manager to activate the window
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
  /// Runs `what` in the next modal dialog of that name.
  template <class Do>
  void in_dialog(const char* name, Do what) {
    auto* look = new QTimer(window.get());
    QObject::connect(look, &QTimer::timeout, look, [this, look, name, what] {
      auto* dialog = window->findChild<QDialog*>(QString::fromLatin1(name));
      if (!dialog || !dialog->isVisible()) return;
      look->stop();
      what(dialog);
    });
    look->start(10);
  }
  /// F10 during a test on the only screen, which is the trainee's; `agree`: what is answered to the question.
  void ask_for_readings(bool agree) {
    in_dialog("readings_in_test", [agree](QDialog* d) {
      auto* box = qobject_cast<QMessageBox*>(d);
      for (QAbstractButton* b : box->buttons())
        if ((box->buttonRole(b) == QMessageBox::AcceptRole) == agree) return b->click();
    });
    QApplication::setActiveWindow(window.get());  // after a dialog no window is active on the offscreen platform, and no shortcut acts
    QTest::keyClick(window.get(), Qt::Key_F10);
  }
  void click(const char* button) { QTest::mouseClick(child<QPushButton>(button), Qt::LeftButton); }
  /// Waits for a condition, never for a fixed time: the limit only ends a failing test, and even a slow machine stays below it.
  template <class Condition>
  static bool eventually(Condition condition) {
    return QTest::qWaitFor(condition, kPatience_ms);
  }
  bool wait_for_time(double t) {
    return eventually([&] { return control()->newest() && control()->newest()->time_s >= t; });
  }
  /// Runs an attempt without an end to the time t.
  void run_to(double t) {
    script.rate = 20;
    script.end_s = 0;
    open();
    click("start");
    ASSERT_TRUE(wait_for_time(t));
  }
  bool wait_for_end() {
    return eventually([&] { return control()->state() == console::RunControl::State::kFinished; });
  }
  /// Waits until the scene of the chosen lesson is shown.
  bool wait_for_preview() {
    return eventually([&] { return !child<QLabel>("lesson_title")->text().isEmpty(); });
  }

  static constexpr int kPatience_ms = 60000;

  QTemporaryDir dir;
  FakeScript script;
  std::string school_place;  // of a server; "" for a file
  std::string school_file() const { return school_place.empty() ? dir.filePath("school.db").toStdString() : school_place; }

  bool with_store = true;
  bool with_school = false;  // a real store, with people and courses that can be changed
  bool with_expert = false;  // an expert for guides
  bool expert_passes = true;
  std::string no_expert;  // non-empty: why there is no expert
  int experts = 0;        // number of experts opened
  session::Options expert_options;
  console::StationsOpener open_stations;  // none: this station alone
  bool first_start = false;  // no window size is given or remembered
  int to_recover = 0;
  std::shared_ptr<FakeStore::Shared> shared = std::make_shared<FakeStore::Shared>();
  size_t recorded_steps = 2000;  // of any attempt opened for review; 0: it cannot be read
  bool with_knot = false;        // its lesson reads knots
  FakePuller::Script pull;       // what comes of pulling one
  std::string plugin_missing;    // non-empty: the missing plugin, without which the picture cannot be replayed
  uint64_t differs = ~uint64_t{0};
  std::vector<record::AttemptRow> attempts;
  std::shared_ptr<FakeLog> log = std::make_shared<FakeLog>();
  console::Launch launch;
  std::unique_ptr<console::MainWindow> window;
};

}  // namespace swage::test
