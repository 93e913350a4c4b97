// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The main window. It puts its parts together: the pages (WindowPages), where it stands (WindowPlace), its look (WindowTheme), its keys
// (WindowKeys), what is remembered of the Run page (RunMemory), lessons (LessonRequests) and attempts (AttemptOpener) that are asked for,
// the trainee's place (TraineePlace), a person's instrument (OwnInstrument), other stations (StationMessages), how it is left (CloseGuard).
#pragma once

#include <QMainWindow>
#include <memory>

#include "console/app/attempt_opener.hpp"
#include "console/app/close_guard.hpp"
#include "console/app/command_line.hpp"
#include "console/app/frame_rate.hpp"
#include "console/app/lesson_requests.hpp"
#include "console/app/own_instrument.hpp"
#include "console/app/run_memory.hpp"
#include "console/app/services.hpp"
#include "console/app/settings.hpp"
#include "console/app/station_messages.hpp"
#include "console/app/trainee_place.hpp"
#include "console/app/window_pages.hpp"
#include "console/app/window_place.hpp"
#include "console/app/window_theme.hpp"
#include "console/widgets/message_strip.hpp"

namespace swage::console {

class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  MainWindow(Services services, const Launch& launch, QWidget* parent = nullptr);
  ~MainWindow() override;

  RunPage* run_page() { return pages_->run(); }
  PeoplePage* people_page() { return pages_->people(); }
  ReviewPage* review_page() { return pages_->review(); }
  LessonsPage* lessons_page() { return pages_->lessons(); }
  CoursesPage* courses_page() { return pages_->courses(); }
  SchoolDesk* desk() { return &desk_; }
  StationsPage* stations_page() { return pages_->stations(); }
  StationLink* stations() { return stations_; }
  MessageStrip* messages() { return messages_; }
  /// More sections can be added to it: equipment has its own.
  SetupPage* setup_page() { return pages_->setup(); }
  /// The trainee's window; nullptr while it is closed.
  TraineeWindow* trainee() { return trainee_->window(); }
  void set_theme(const QString& ui, const QString& cues) { theme_->set(ui, cues); }
  const QString& ui_theme() const { return theme_->ui(); }

 public Q_SLOTS:
  /// "run", "people"...: Page::id.
  void show_page(const QString& id) { pages_->all()->go(id); }
  void show_help();
  void toggle_trainee() { trainee_->toggle(); }
  /// Calibration of a jaw sensor.
  void show_calibration();
  void review_file(const QString& file) { attempts_->open_file(file); }
  /// The attempt ends as with Stop, what is remembered is written, the program goes: for a signal that asks for it.
  void leave();
  /// Closes the window; while a lesson runs only if the person wants that.
  void quit();

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  Pages* make_middle();
  void make_parts(Pages* pages, Services& services);
  void connect_setup();
  void show_store(const Launch& launch);
  void fill_top_bar();
  void add_keys();
  void restore(const Launch& launch);
  void open_given(const Launch& launch);
  void remember();

  Settings settings_;
  LessonsModel lessons_;
  StoreLink store_;
  SchoolDesk desk_;
  StationLink* stations_;  // outlives the members, as pages are hidden after them
  StatusStrip* strip_ = nullptr;
  MessageStrip* messages_ = nullptr;
  std::unique_ptr<WindowPages> pages_;
  std::unique_ptr<TraineePlace> trainee_;
  std::unique_ptr<WindowPlace> place_;
  std::unique_ptr<WindowTheme> theme_;
  std::unique_ptr<RunMemory> memory_;
  std::unique_ptr<FrameRate> frames_;
  std::unique_ptr<LessonRequests> requests_;
  std::unique_ptr<AttemptOpener> attempts_;
  std::unique_ptr<OwnInstrument> instrument_;
  std::unique_ptr<StationMessages> station_;
  std::unique_ptr<CloseGuard> guard_;
};

}  // namespace swage::console
