// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/run_page.hpp"

#include <QHBoxLayout>
#include <QMessageBox>
#include <QRandomGenerator>
#include <QResizeEvent>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "console/models/lesson_files.hpp"
#include "console/models/metric_titles.hpp"
#include "console/models/said.hpp"
#include "console/models/words.hpp"
#include "console/pages/event_table.hpp"
#include "console/widgets/parts.hpp"
#include "record/store.hpp"

namespace swage::console {
namespace {

constexpr int kPreviewDelay_ms = 80;  // running through the list with the arrow keys loads only where one stays
constexpr int kMostSeed = 1000000;  // six digits can be read out and typed again

constexpr int kBottom_px = 140;  // three events, or ten cues in two columns; higher where a lesson has more
// On a page narrower or lower than these the side panels are slimmer, and the strip of events gives its room to the picture.
constexpr int kNarrow_px = 1180, kLow_px = 600;
constexpr int kSide_px = 270, kSlimSide_px = 230;        // the whole page fits a screen of 1280
constexpr int kLessons_px = 290, kSlimLessons_px = 256;  // and the titles of the lessons fit the list

}  // namespace

RunPage::RunPage(SessionOpener opener, LessonsModel* lessons, StatusStrip* strip, QWidget* parent)
    : QWidget(parent),
      control_(new RunControl(std::move(opener), this)),
      lessons_(lessons),
      strip_(strip),
      setup_(new SetupPanel(lessons, this)),
      course_(new CourseControl(lessons, setup_, this)),
      options_(*setup_),
      editing_(new LessonEditing(lessons, setup_, control_, options_, this)),
      events_(new EventLog(this)),
      shown_events_(new EventFilter(events_, this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 10, 12, 6);
  row->setSpacing(12);
  row->addWidget(setup_);
  row->addWidget(make_middle(), 1);
  row->addWidget(make_right());

  presenter_ = std::make_unique<AttemptPresenter>(AttemptPresenter::Parts{control_, setup_, &options_, bar_, events_, strip_});
  instructor_ = new InstructorControl({control_, presenter_.get(), bar_, shown_events_, this});
  presenter_->add_view(view_);
  presenter_->add_panels(now_, legend_, AttemptPresenter::For::kTrainee);
  preview_timer_.setSingleShot(true);
  preview_timer_.setInterval(kPreviewDelay_ms);
  connect(&preview_timer_, &QTimer::timeout, this, &RunPage::preview);
  connect_setup();
  connect_editing();
  connect_control();
  connect_bars();
  add_keys();
  update_state();
}

// Ctrl+Right also works again and again while nothing runs; during an attempt it belongs to the picture.
void RunPage::add_keys() {
  next_ = new QShortcut(QKeySequence(Qt::CTRL | Qt::Key_Right), this, nullptr, nullptr, Qt::WidgetWithChildrenShortcut);
  connect(next_, &QShortcut::activated, this, &RunPage::go_on);
}

QWidget* RunPage::make_middle() {
  auto* box = new QWidget(this);
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  view_ = new SceneView(box);
  bar_ = new ViewBar(box);
  column->addWidget(bar_);
  fault_ = new FaultCard(box);
  column->addWidget(fault_);
  column->addWidget(view_, 1);
  actions_ = new ActionBar(control_, box);
  column->addWidget(actions_);
  column->addWidget(make_bottom());
  return box;
}

// what happened, and what the cues mean
QWidget* RunPage::make_bottom() {
  auto* box = bottom_ = new QWidget(this);
  box->setMinimumHeight(kBottom_px);
  box->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);  // as high as the legend asks for
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(8);
  event_table_ = make_event_table(shown_events_, box);
  event_table_->setObjectName(QStringLiteral("events"));
  event_table_->setAccessibleName(tr("What happened in this attempt"));
  event_table_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
  row->addWidget(event_table_, 5);
  legend_ = new CueLegend(box);
  row->addWidget(legend_, 9);
  return box;
}

QWidget* RunPage::make_right() {
  auto* scroll = make_scroll(this);
  right_box_ = scroll;
  right_ = new QStackedWidget(scroll);
  scroll->setWidget(right_);
  now_ = new NowPanel(right_);
  result_ = new ResultPanel(right_);
  right_->addWidget(now_);
  right_->addWidget(result_);
  size_as_shown(right_);
  return scroll;
}

void RunPage::connect_setup() {
  connect(setup_, &SetupPanel::lesson_changed, &preview_timer_, qOverload<>(&QTimer::start));
  connect(setup_, &SetupPanel::mode_changed, this, &RunPage::update_cues);
  for (const auto changed : {&SetupPanel::mode_changed, &SetupPanel::lesson_changed, &SetupPanel::person_chosen})
    connect(setup_, changed, this, &RunPage::tell_subject);
  // a verdict of another lesson is gone at once, the new scene comes when the list rests
  connect(setup_, &SetupPanel::lesson_changed, this, [this] {
    if (!control_->running() && shown_lesson_ != setup_->lesson()) forget_attempt();
  });
  connect(setup_, &SetupPanel::start, this, &RunPage::start);
  connect(setup_, &SetupPanel::make_variant, editing_, &LessonEditing::make_variant);
  connect(setup_, &SetupPanel::edit_lesson, editing_, &LessonEditing::edit);
  connect(setup_, &SetupPanel::delete_lesson, editing_, &LessonEditing::remove);
}

void RunPage::connect_editing() {
  connect(editing_, &LessonEditing::changed, this, &RunPage::preview);
  connect(editing_, &LessonEditing::failed, fault_, &FaultCard::say);
  connect(editing_, &LessonEditing::try_it, this, [this] {
    setup_->set_mode(QStringLiteral("practice"));
    start();
    Q_EMIT started_elsewhere();
  });
  editing_->set_dress([this](SceneView& view) { view.set_themes(presenter_->ui_theme(), presenter_->cue_theme()); });
  editing_->set_live_values([this](const QString& lesson) {
    return shown_lesson_ == lesson ? now_->form()->changed_values() : QVector<LiveForm::Change>();
  });
}

void RunPage::connect_control() {
  connect(control_, &RunControl::opened, this, [this] { show_card(control_->card()); });
  connect(control_, &RunControl::failed, fault_, &FaultCard::show_problems);
  connect(control_, &RunControl::told, fault_, &FaultCard::show_record_warning);
  connect(control_, &RunControl::state_changed, this, &RunPage::update_state);
  connect(control_, &RunControl::frame, presenter_.get(), &AttemptPresenter::update_frame);
  connect(control_, &RunControl::pulling, presenter_.get(), &AttemptPresenter::show_pulling);
  connect(control_, &RunControl::finished, this, &RunPage::show_finished);
  connect(result_, &ResultPanel::again, this, &RunPage::start);
  connect(result_, &ResultPanel::progress, this, &RunPage::show_progress);
  connect(result_, &ResultPanel::review, this, &RunPage::review);
  connect(result_, &ResultPanel::next, this, &RunPage::go_on);
}

void RunPage::connect_bars() {
  connect(bar_, &ViewBar::view_chosen, this, &RunPage::look);
  connect(bar_, &ViewBar::cues_toggled, this, &RunPage::update_cues);
  connect(bar_, &ViewBar::insets_toggled, presenter_.get(), &AttemptPresenter::update_insets);
  connect(bar_, &ViewBar::forces_toggled, this, &RunPage::update_cues);
  connect(bar_, &ViewBar::detail_toggled, shown_events_, &EventFilter::show_technical);
  connect(bar_, &ViewBar::detail_toggled, this, &RunPage::update_cues);
  connect(bar_, &ViewBar::instructor_toggled, this, &RunPage::show_instructor);
  connect(actions_, &ActionBar::guide_toggled, presenter_.get(), &AttemptPresenter::toggle_guide);
  connect(fault_, &FaultCard::run_unrecorded, this, &RunPage::start_unrecorded);
}

void RunPage::resizeEvent(QResizeEvent* event) {
  const bool narrow = width() < kNarrow_px;
  setup_->setFixedWidth(narrow ? kSlimLessons_px : kLessons_px);
  right_box_->setFixedWidth(narrow ? kSlimSide_px : kSide_px);
  bottom_->setVisible(height() >= kLow_px);
  actions_->set_narrow(narrow);
  fold_bar();
  QWidget::resizeEvent(event);
}

// That of the slim panels: a page that is not in front is not resized, and would keep the window wide.
QSize RunPage::minimumSizeHint() const {
  const int slimmer = setup_->minimumWidth() - kSlimLessons_px + right_box_->minimumWidth() - kSlimSide_px;
  return QWidget::minimumSizeHint() - QSize(std::max(0, slimmer), 0);
}

void RunPage::fold_bar() { bar_->fold_to(width() - setup_->maximumWidth() - right_box_->maximumWidth()); }

void RunPage::set_themes(const UiTheme& ui, const CueTheme& cues) {
  presenter_->set_themes(ui, cues);
  result_->set_theme(ui);
}

void RunPage::set_base_options(const session::Options& options) {
  options_.set_base(options);
  learn_metric_labels(catalogue().plugins());
  for (const host::PluginInfo& p : catalogue().plugins()) learn_words(QString::fromStdString(p.bundle_dir));
}

MetricSaid RunPage::metric_said(const QString& lesson_path, const std::string& metric_id) {
  MetricSaid said{metric_facts(nullptr, metric_id), metric_target(lesson_path.toStdString(), metric_id, catalogue())};
  for (const host::MetricInfo& m : lesson_metrics(lesson_path.toStdString(), catalogue()))
    if (m.id == metric_id && m.evidence != SWAGE_EVIDENCE_NONE) said.facts = {m.better, QString::fromStdString(m.formula)};
  return said;
}

QString RunPage::fault_of(const QString& lesson_path) {
  if (control_->running()) return {};
  base::Problems problems;
  return control_->preview(options_.of(lesson_path), problems) ? QString() : problem_words(problems, lesson_path);
}

void RunPage::set_expert(ExpertOpener open) {
  presenter_->guide().set_expert(std::move(open));
  update_cues();
}

void RunPage::set_notice(const QString& text) { strip_->set_idle(text); }

std::unique_ptr<ArmReader> RunPage::make_arm_reader() {
  if (control_->running() || setup_->lesson().isEmpty()) return nullptr;
  return std::make_unique<ArmReader>(control_->opener(), options_.reader());
}

void RunPage::set_binding(const Binding& binding) {
  if (options_.set_binding(binding)) setup_->set_own_instrument(options_.instrument_title());
}

void RunPage::take_focus() { control_->running() ? view_->setFocus() : setup_->focus_start(); }

// A view that suits one lesson may hide the work of another.
void RunPage::look_first(const snapshot::SceneCard& card) {
  if (std::exchange(looked_, false)) return;
  presenter_->set_next_look(view_named(card.view).value_or(CameraPreset::kOrbit));
}

void RunPage::preview() {
  preview_timer_.stop();
  if (control_->running() || setup_->lesson().isEmpty()) return;
  const bool other = shown_lesson_ != setup_->lesson();
  if (other && !shown_lesson_.isEmpty()) {
    forget_attempt();
    looked_ = false;
  }
  shown_lesson_ = setup_->lesson();
  const QModelIndex chosen = lessons_->index(lessons_->row_of(shown_lesson_));
  actions_->set_reset(chosen.data(LessonsModel::kResetLabel).toString(), chosen.data(LessonsModel::kResetTip).toString());
  asked_ = read_criteria(shown_lesson_.toStdString(), catalogue());
  setup_->set_show(asked_.show);
  options_.set_show(asked_.show);
  base::Problems problems;
  const auto card = control_->preview(options_.attempt(display(), presenter_->cue_theme()), problems);
  setup_->set_startable(card != nullptr);
  if (!card) {
    const QString title = lessons_->at(lessons_->row_of(shown_lesson_)).title;
    bar_->set_title(said(title));
    fold_bar();
    presenter_->show_no_scene(title, asked_);
    return fault_->show_problems(problems);
  }
  fault_->hide_words();
  if (other) look_first(*card);
  show_card(*card);
  right_->setCurrentWidget(now_);
}

void RunPage::show_card(const snapshot::SceneCard& card) {
  bar_->set_title(said(card.title));
  fold_bar();
  presenter_->show_card(card, asked_);
}

void RunPage::start() {
  // an attempt may be a good one: a single key does not end it
  told_running_ = control_->running();
  if (told_running_) return fault_->say(tr("An attempt runs: Shift+F5 stops it, and then F5 begins anew."));
  launch(false);
}

void RunPage::start_unrecorded() {
  launch(true);
  if (control_->running()) fault_->say_unrecorded();
}

// A letter that was meant for the instrument makes another person of a name: nobody is added without a word.
bool RunPage::agree_on_person() {
  if (!setup_->person_is_new()) return true;
  const QString name = setup_->person();
  QMessageBox ask(QMessageBox::NoIcon, tr("New trainee"), tr("%1 has not practised here before. Add as a trainee?").arg(name), {}, window());
  ask.setObjectName(QStringLiteral("new_trainee"));
  QPushButton* add = ask.addButton(tr("Add and start"), QMessageBox::AcceptRole);
  ask.addButton(QMessageBox::Cancel);
  ask.setDefaultButton(add);
  ask.exec();
  if (ask.clickedButton() != add) {
    setup_->focus_person();
    return false;
  }
  setup_->know_person(name);
  return true;
}

// Also for a name of the command line, which nobody is asked about.
bool RunPage::enter_person() {
  const QString name = setup_->person();
  if (!add_person_ || name == QLatin1String(record::kGuest)) return true;
  const QString problem = add_person_(name);
  if (!problem.isEmpty()) fault_->say(problem);
  return problem.isEmpty();
}

void RunPage::launch(bool unrecorded) {
  if (control_->running() || setup_->lesson().isEmpty()) return;
  // what is about to run has been looked at, and could be built
  if (preview_timer_.isActive() || !setup_->startable()) preview();
  if (!setup_->startable()) return;
  const bool kept = !unrecorded && !asked_.show && setup_->mode() != QLatin1String("demo");
  if (kept && !(agree_on_person() && enter_person() && course_->agree())) return;
  presenter_->clear();
  instructor_->begin();
  fault_->clear();
  session::Options o = options_.attempt(display(), presenter_->cue_theme()), like = options_.lesson(display());
  if (unrecorded) o.store_path = ":none:";
  if (draws_seed_) {
    const std::string seed = "seed=" + std::to_string(QRandomGenerator::global()->bounded(1, kMostSeed));
    o.settings.push_back(seed);
    like.settings.push_back(seed);
  }
  o.display = presenter_->begin(like, guided());
  if (!control_->start(o)) return;
  opened_ = kept && !course_->reason().isEmpty() ? tr("Opened before its turn in the course: %1.").arg(course_->reason()) : QString();
  if (!opened_.isEmpty()) control_->note(opened_.toStdString());
  presenter_->guide().show();
  view_->setFocus();
}

// What is left of the last attempt belongs to its lesson.
void RunPage::forget_attempt() {
  presenter_->forget();
  right_->setCurrentWidget(now_);
}

void RunPage::update_state() {
  const bool running = control_->running(), paused = control_->state() == RunControl::State::kPaused;
  setup_->set_running(running, paused);
  next_->setEnabled(!running);
  actions_->set_running(running, paused);
  if (running) right_->setCurrentWidget(now_);
  if (!running && std::exchange(told_running_, false)) fault_->hide_words();
  if (!running) strip_->set_idle(setup_->has_lessons() ? tr("○ Ready") : tr("○ No lessons"));
  presenter_->update_state();
  update_cues();
  presenter_->update_frame();
}

// A test shows no answers: neither readings nor cues nor what happened, but in the instructor's window.
void RunPage::update_cues() {
  presenter_->update_cues();
  actions_->set_guide_allowed(presenter_->guide().possible() && !presenter_->is_test());
  event_table_->setVisible(!control_->running() || !presenter_->is_test());
}

void RunPage::show_finished() {
  const session::Result& r = control_->result();
  result_->set_targets(metric_targets(shown_lesson_.toStdString(), catalogue()));
  if (asked_.show)
    result_->show_seen(r);
  else
    result_->show_result(r, control_->card(), !r.attempt_id.empty(), instructor_->were_open());
  if (!asked_.show) result_->add_remark(opened_);
  result_->set_criteria(asked_);
  result_->set_course({});
  right_->setCurrentWidget(result_);
  presenter_->end(r.simulated_s, result_->outcome());
  Q_EMIT attempt_over();  // after which the course is read again, with this attempt
  const QString of_course = course_->standing(shown_lesson_);
  if (!of_course.isEmpty() && !asked_.show) result_->set_course(tr("In the course: %1.").arg(of_course));
  result_->set_can_go_on(setup_->has_next() || course_->row() >= 0);
}

// From the result of a lesson of a course to the one that the course asks for next, else down the list.
void RunPage::go_on() {
  const int row = course_->row(), now = lessons_->row_of(setup_->lesson());
  const bool of_course = right_->currentWidget() == result_ && !course_->standing(shown_lesson_).isEmpty();
  of_course && row >= 0 && row != now ? setup_->select_lesson(row) : setup_->select_next();
}

// who does which lesson, and in which mode, in the instructor's window
void RunPage::tell_subject() {
  const QString title = lessons_->index(lessons_->row_of(setup_->lesson())).data().toString();
  instructor_->set_subject(QStringList{person_text(setup_->person()), title, mode_text(setup_->mode())}.join(QStringLiteral("  ·  ")));
}

}  // namespace swage::console
