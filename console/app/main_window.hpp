// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QMainWindow>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

#include "console/app/command_line.hpp"
#include "console/app/pages.hpp"
#include "console/app/settings.hpp"
#include "console/app/trainee_place.hpp"
#include "console/link/station_link.hpp"
#include "console/models/lessons_model.hpp"
#include "console/pages/courses_page.hpp"
#include "console/pages/lessons_page.hpp"
#include "console/pages/people_page.hpp"
#include "console/pages/review_page.hpp"
#include "console/pages/run_page.hpp"
#include "console/pages/setup_page.hpp"
#include "console/pages/stations_page.hpp"
#include "console/widgets/message_strip.hpp"

namespace swage::console {

/// The window's ways into the framework; tests put doubles behind them.
struct Services {
  SessionOpener open_session;
  StoreOpener open_store;  // none: nothing is kept
  RecordingReader read_recording;
  PlayerOpener open_player;
  FileOpener open_file;  // an attempt out of a file
  FileReader read_file;
  SchoolOpener open_school = {};  // none: people and courses cannot be changed
  ExpertOpener open_expert = {};  // none: nobody guides
  ExportReader read_export = {};   // none: exports do not say what was measured with
  StationsOpener open_stations = {};  // none: there is only this station
};

class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  MainWindow(Services services, const Launch& launch, QWidget* parent = nullptr);
  ~MainWindow() override;

  RunPage* run_page() { return run_; }
  PeoplePage* people_page() { return people_; }
  ReviewPage* review_page() { return review_; }
  LessonsPage* lessons_page() { return lessons_page_; }
  CoursesPage* courses_page() { return courses_; }
  SchoolDesk* desk() { return &desk_; }
  StationsPage* stations_page() { return stations_page_; }
  StationLink* stations() { return stations_; }
  MessageStrip* messages() { return messages_; }
  /// More sections can be added to it: equipment has its own.
  SetupPage* setup_page() { return setup_; }
  /// The trainee's window; nullptr while it is closed.
  TraineeWindow* trainee() { return trainee_->window(); }
  void set_theme(const QString& ui, const QString& cues);
  const QString& ui_theme() const { return ui_id_; }

 public Q_SLOTS:
  /// "run", "people"...: Page::id.
  void show_page(const QString& id) { pages_->go(id); }
  void show_help();
  void toggle_trainee() { trainee_->toggle(); }
  /// Calibration of a jaw sensor.
  void show_calibration();
  void review(const QString& attempt_id);
  /// Asks for a file with an attempt and shows it on the Review page.
  void open_attempt();
  void review_file(const QString& file);
  /// The attempt ends as with Stop, what is remembered is written, the program goes: for a signal that asks for it.
  void leave();
  /// Closes the window; while a lesson runs only if the person wants that.
  void quit();

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void add_pages(Services& services);
  void connect_pages();
  void connect_lesson_files();
  void fill_top_bar();
  void select_lesson(const QString& path);
  QVector<LessonMetric> metrics_of(const QString& lesson_id);
  void add_actions();
  void fit_screen();
  void enter_run();
  bool agree_to_stop();
  void tell_stopped();
  void offer_languages();
  CueTheme cue_theme(const QString& id, bool dark) const;
  void restore(const Launch& launch);
  void select_first(const Launch& launch);
  void review_given(const Launch& launch);
  void remember();
  void connect_instrument();
  const SceneView* shown_view() const;
  void add_stations();
  void start_stations(StationsOpener opener, const QString& name);
  void show_messages();
  void answer_message(const record::StationMessage& message, bool accepted);
  void show_message_to_trainee();

  Settings settings_;
  QTimer frames_timer_;
  bool fits_ = false;  // into its screen, frame and all, once it is seen
  LessonsModel lessons_;
  StoreLink store_;
  SchoolDesk desk_;
  QString ui_id_, cues_id_;
  std::unique_ptr<TraineePlace> trainee_;
  StatusStrip* strip_ = nullptr;
  MessageStrip* messages_ = nullptr;
  Pages* pages_ = nullptr;
  RunPage* run_ = nullptr;
  LessonsPage* lessons_page_ = nullptr;
  CoursesPage* courses_ = nullptr;
  PeoplePage* people_ = nullptr;
  ReviewPage* review_ = nullptr;
  SetupPage* setup_ = nullptr;
  StationsPage* stations_page_ = nullptr;
  StationLink* stations_;  // outlives the members, as pages are hidden after them
};

}  // namespace swage::console
