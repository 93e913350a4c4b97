// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The Run page: choose at the left, watch in the middle, read at the right. What an attempt is opened with (AttemptOptions), the expert's
// ghost (GuideControl) and an instructor's own lessons (LessonEditing) are classes of their own.
#pragma once

#include <QElapsedTimer>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSlider>
#include <QStackedWidget>
#include <QTableView>
#include <QTimer>
#include <QWidget>
#include <memory>

#include "console/cues/speaker.hpp"
#include "console/link/arm_reader.hpp"
#include "console/link/run_control.hpp"
#include "console/models/event_log.hpp"
#include "console/models/lessons_model.hpp"
#include "console/models/metric_facts.hpp"
#include "console/models/reading.hpp"
#include "console/pages/attempt_options.hpp"
#include "console/pages/guide_control.hpp"
#include "console/pages/instructor_window.hpp"
#include "console/pages/lesson_editing.hpp"
#include "console/pages/now_panel.hpp"
#include "console/pages/result_panel.hpp"
#include "console/pages/setup_panel.hpp"
#include "console/pages/status_strip.hpp"
#include "console/view3d/scene_view.hpp"
#include "console/widgets/cue_legend.hpp"

namespace swage::console {

class RunPage : public QWidget {
  Q_OBJECT
 public:
  RunPage(SessionOpener opener, LessonsModel* lessons, StatusStrip* strip, QWidget* parent = nullptr);

  /// What every session is opened with; person, lesson, mode and device are set from the page.
  void set_base_options(const session::Options& options);
  /// Whether every attempt gets a seed of its own: new targets, new tremor.
  void set_draws_seed(bool on) { draws_seed_ = on; }
  /// A camera preset, now and for every lesson opened from now on.
  void look(CameraPreset preset);
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
  void add_view(SceneView* view);
  void set_placing(Placing placing) { options_.set_placing(std::move(placing)); }
  /// Reads the chosen instrument; nullptr while an attempt runs or no lesson is chosen.
  std::unique_ptr<ArmReader> make_arm_reader();
  /// A person's own instrument, chosen among those of the lesson.
  void set_binding(const Binding& binding);
  /// Who plays a lesson for a guide; without one there is none.
  void set_expert(ExpertOpener open);
  /// Live help: a ghost of an expert's instruments in the picture, at the trainee's pace. Never in a test.
  void set_guided(bool on) { guide_button_->setChecked(on); }
  void click_guide() { guide_button_->click(); }  // nothing while it is disabled
  bool guided() const { return guide_button_->isChecked(); }
  const Guide* guide() const { return guide_.guide(); }
  /// How the trainee sees the scene: in the view that was added last and is open, else in that of this page.
  record::Display display() const;
  ResultPanel* result() { return result_; }
  EventLog* events() { return events_; }
  LessonEditing* editing() { return editing_; }
  CueLegend* legend() { return legend_; }
  Speaker& speaker() { return speaker_; }
  /// Loudness of the cues, 0 to 1, and whether they sound at all.
  void set_sound(bool on, double volume);
  bool sound_on() const { return sound_button_->isChecked(); }

 public Q_SLOTS:
  void start();
  /// The same with nothing kept, because the store cannot be written; said as long as it lasts.
  void start_unrecorded();
  void make_variant() { editing_->make_variant(); }
  void edit_lesson() { editing_->edit(); }
  void delete_lesson() { editing_->remove(); }
  /// Readings, cues and events in a window of their own, for a second screen.
  void show_instructor(bool on);

 public:
  /// The keyboard goes to the instrument while an attempt runs, else to START: never to a field that takes letters.
  void take_focus();
  /// Controls that the person has used before: their hints are not shown again. "drag close drive open"
  void set_used_controls(const QString& used);
  const QString& used_controls() const { return used_; }
  bool instructor_shown() const { return instructor_ && instructor_->isVisible(); }

 Q_SIGNALS:
  /// An attempt was begun from another page: this one is to be shown.
  void started_elsewhere();
  void attempt_over();
  void show_progress();
  void review(const QString& attempt_id);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fold_view_bar();
  void fill_view_menu(QMenu* menu) const;
  QWidget* make_middle();
  QWidget* make_view_bar();
  QWidget* make_actions();
  QWidget* make_right();
  QWidget* make_bottom();
  QWidget* make_sound(QWidget* bar);
  void change(const QString& instance, const QString& json, const QString& words);
  void sound(const Reading& reading, double time_s);
  bool cues_hidden() const { return setup_->mode() == QLatin1String("test"); }
  void connect_setup();
  void connect_control();
  void preview();
  void show_card(const snapshot::SceneCard& card);
  void show_no_scene();
  void show_problems(const base::Problems& problems);
  void show_record_warning(const base::Problems& problems);
  void launch(bool unrecorded);
  void update_state();
  void update_frame();
  void update_cues();
  void update_second();
  void tell_display();
  bool by_mouse() const;
  void tell_circle(const std::optional<NeedleCircle>& about);
  void show_finished();
  void forget_attempt();
  void set_texts(const QString& clock, const QString& banner);
  void update_hidden();
  void update_hints();
  bool agree_on_person();
  void hear(const judge::Event& event);
  void advise(const Reading& reading);
  void show_keys_below();
  QList<NowPanel*> now_panels() const;
  QList<CueLegend*> legends() const;

  bool draws_seed_ = false;
  CameraPreset preset_ = CameraPreset::kOrbit;
  RunControl* control_;
  LessonsModel* lessons_;
  StatusStrip* strip_;
  SetupPanel* setup_;
  AttemptOptions options_;
  LessonEditing* editing_;
  SceneView* view_ = nullptr;
  QList<SceneView*> views_;  // that one first
  GuideControl guide_{views_};
  QLabel *title_ = nullptr, *problem_ = nullptr;
  QPushButton* unrecorded_ = nullptr;  // offered where the store refuses
  QString refused_;                    // why it refused
  QPushButton *pause_ = nullptr, *reset_ = nullptr, *mark_ = nullptr, *stop_ = nullptr,
              *cues_button_ = nullptr, *second_button_ = nullptr, *guide_button_ = nullptr;
  QList<QPushButton*> folding_;  // over the picture
  QPushButton* view_menu_ = nullptr;
  QWidget *bottom_ = nullptr, *right_box_ = nullptr;
  QStackedWidget* right_ = nullptr;
  NowPanel* now_ = nullptr;
  InstructorWindow* instructor_ = nullptr;
  QPushButton* instructor_button_ = nullptr;
  Criteria asked_;
  QString shown_lesson_, used_;
  record::Display seen_;  // while an attempt runs: as it was when last told to its record
  ResultPanel* result_ = nullptr;
  EventLog* events_;
  EventFilter* shown_events_;
  QTableView* event_table_ = nullptr;
  CueLegend* legend_ = nullptr;
  QPushButton* sound_button_ = nullptr;
  QSlider* volume_ = nullptr;
  UiTheme ui_theme_;
  CueTheme cue_theme_;
  snapshot::SceneCard card_;  // of the chosen lesson, or of the attempt
  bool have_card_ = false;
  bool holds_ = false, misplaced_ = false, dropped_ = false;  // now: jaws hold something, at the wrong place; it has fallen
  uint64_t dropped_at_ = 0;                                   // step
  CueSounds sounds_;
  Speaker speaker_;
  Reader reader_;
  QTimer preview_timer_;
  QElapsedTimer rate_clock_;
  uint64_t rate_steps_ = 0;
  double steps_per_s_ = 0;
};

}  // namespace swage::console
