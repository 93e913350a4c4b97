// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The Run page: choose at the left, watch in the middle, read at the right. It puts its parts together, opens lessons and attempts, and
// passes on what one part says to another. The parts: what an attempt is opened with (AttemptOptions), what is shown of it
// (AttemptPresenter, with the expert's ghost and hints), the bars over and below the picture (ViewBar, ActionBar), why a lesson cannot run
// (FaultCard), an instructor's own lessons (LessonEditing).
#pragma once

#include <QShortcut>
#include <QStackedWidget>
#include <QTableView>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "console/link/arm_reader.hpp"
#include "console/link/run_control.hpp"
#include "console/models/event_log.hpp"
#include "console/models/lessons_model.hpp"
#include "console/models/metric_facts.hpp"
#include "console/pages/action_bar.hpp"
#include "console/pages/attempt_options.hpp"
#include "console/pages/attempt_presenter.hpp"
#include "console/pages/course_control.hpp"
#include "console/pages/fault_card.hpp"
#include "console/pages/instructor_control.hpp"
#include "console/pages/lesson_editing.hpp"
#include "console/pages/result_panel.hpp"
#include "console/pages/setup_panel.hpp"
#include "console/pages/view_bar.hpp"

namespace swage::console {

/// Enters a person, by name, in the store before an attempt is kept; nothing happens where the person is there. Returns why that failed,
/// as a sentence; "" on success.
using PersonAdder = std::function<QString(const QString& name)>;

class RunPage : public QWidget {
  Q_OBJECT
 public:
  RunPage(SessionOpener opener, LessonsModel* lessons, StatusStrip* strip, QWidget* parent = nullptr);

  /// What every session is opened with; person, lesson, mode and device are set from the page.
  void set_base_options(const session::Options& options);
  /// Whether every attempt gets a seed of its own: new targets, new tremor.
  void set_draws_seed(bool on) { draws_seed_ = on; }
  /// A camera preset, now and for every lesson opened from now on.
  /// Shows a view, which stays when a lesson is chosen for the first time.
  void look(CameraPreset preset) { looked_ = true, presenter_->look(preset); }
  void set_themes(const UiTheme& ui, const CueTheme& cues);
  /// Shown at the bottom until the next start.
  void set_notice(const QString& text);
  RunControl* control() { return control_; }
  /// Why a lesson cannot run; "" where its scene can be built, or while an attempt runs.
  QString fault_of(const QString& lesson_path);
  /// What a lesson says about a metric, in its plugin's card.
  MetricSaid metric_said(const QString& lesson_path, const std::string& metric_id);
  const host::Catalogue& catalogue() const { return options_.catalogue(); }
  SetupPanel* setup() { return setup_; }
  SceneView* view() { return view_; }
  /// Another view of the same attempt, a trainee's; it shows what there is and goes on with it until it is destroyed.
  void add_view(SceneView* view) { presenter_->add_view(view); }
  /// Gives that view up, for something else to be shown in it.
  void remove_view(SceneView* view) { presenter_->remove_view(view); }
  void set_placing(Placing placing) { options_.set_placing(std::move(placing)); }
  /// Reads the chosen instrument; nullptr while an attempt runs or no lesson is chosen.
  std::unique_ptr<ArmReader> make_arm_reader();
  /// A person's own instrument, chosen among those of the lesson.
  void set_binding(const Binding& binding);
  /// Who plays a lesson for a guide; without one there is none.
  void set_expert(ExpertOpener open);
  /// A person whom nobody entered would have the name as code, which exports say.
  void set_person_adder(PersonAdder add) { add_person_ = std::move(add); }
  void set_course_finder(CourseFinder find) { course_->set_finder(std::move(find)); }
  /// Reads the course of the person again.
  void show_course() { course_->refresh(); }
  /// Live help: a ghost of an expert's instruments in the picture, at the trainee's pace. Never in a test.
  void set_guided(bool on) { actions_->set_guide(on); }
  void click_guide() { actions_->click_guide(); }  // nothing while it is disabled
  bool guided() const { return actions_->guide_on(); }
  const Guide* guide() const { return std::as_const(*presenter_).guide().guide(); }
  /// How the trainee sees the scene: in the view that was added last and is open, else in that of this page.
  record::Display display() const { return presenter_->display(); }
  ResultPanel* result() { return result_; }
  EventLog* events() { return events_; }
  LessonEditing* editing() { return editing_; }
  CueLegend* legend() { return legend_; }
  Speaker& speaker() { return bar_->sound()->speaker(); }
  /// Loudness of the cues, 0 to 1, and whether they sound at all.
  void set_sound(bool on, double volume) { bar_->sound()->set(on, volume); }
  bool sound_on() const { return bar_->sound()->on(); }

 public Q_SLOTS:
  void start();
  /// The same with nothing kept, because the store cannot be written; said as long as it lasts.
  void start_unrecorded();
  void make_variant() { editing_->make_variant(); }
  void edit_lesson() { editing_->edit(); }
  void delete_lesson() { editing_->remove(); }
  /// Readings, cues and events in a window of their own, for a second screen.
  void show_instructor(bool on) { instructor_->show(on); }

 public:
  QSize minimumSizeHint() const override;
  /// The keyboard goes to the instrument while an attempt runs, else to START: never to a field that takes letters.
  void take_focus();
  /// Controls that the person has used before: their hints are not shown again. "drag close drive open"
  void set_used_controls(const QString& used) { presenter_->set_used_controls(used); }
  const QString& used_controls() const { return presenter_->used_controls(); }
  bool instructor_shown() const { return instructor_->shown(); }

 Q_SIGNALS:
  /// An attempt was begun from another page: this one is to be shown.
  void started_elsewhere();
  void attempt_over();
  void show_progress();
  void review(const QString& attempt_id);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* make_middle();
  QWidget* make_bottom();
  QWidget* make_right();
  void connect_setup();
  void connect_editing();
  void connect_control();
  void connect_bars();
  void add_keys();
  void fold_bar();
  void preview();
  void show_card(const snapshot::SceneCard& card);
  void look_first(const snapshot::SceneCard& card);
  void launch(bool unrecorded);
  bool agree_on_person();
  bool enter_person();
  void update_state();
  void update_cues();
  void show_finished();
  void forget_attempt();
  void go_on();
  void tell_subject();

  bool draws_seed_ = false;
  bool told_running_ = false;  // a second start was answered with words; they go with the attempt
  PersonAdder add_person_;
  RunControl* control_;
  LessonsModel* lessons_;
  StatusStrip* strip_;
  SetupPanel* setup_;
  CourseControl* course_;
  AttemptOptions options_;
  LessonEditing* editing_;
  EventLog* events_;
  EventFilter* shown_events_;
  SceneView* view_ = nullptr;
  ViewBar* bar_ = nullptr;
  FaultCard* fault_ = nullptr;
  ActionBar* actions_ = nullptr;
  QWidget *bottom_ = nullptr, *right_box_ = nullptr;
  QTableView* event_table_ = nullptr;
  CueLegend* legend_ = nullptr;
  QStackedWidget* right_ = nullptr;
  NowPanel* now_ = nullptr;
  ResultPanel* result_ = nullptr;
  InstructorControl* instructor_ = nullptr;
  QShortcut* next_ = nullptr;
  QString opened_;  // an instructor's reason for this attempt before its turn in a course, as a sentence; ""
  Criteria asked_;                          // of the lesson whose scene is shown
  QString shown_lesson_;                    // that lesson
  bool looked_ = false;                     // a view was asked for before the first lesson was shown
  QTimer preview_timer_;
  std::unique_ptr<AttemptPresenter> presenter_;  // goes before the widgets that it writes to
};

}  // namespace swage::console
