// SPDX-License-Identifier: LGPL-3.0-or-later
//
// An attempt on the Run page: its start, its scene before that, its end, and what of it a trainee may see.
#include <QMessageBox>
#include <QRandomGenerator>
#include <limits>

#include "console/models/lesson_files.hpp"
#include "console/models/live_params.hpp"
#include "console/models/said.hpp"
#include "console/models/words.hpp"
#include "console/pages/run_page.hpp"
#include "record/recorder.hpp"

namespace swage::console {
namespace {

// the thesis: 0.6 N holds a needle well
constexpr double kThesisLow_N = 0.4, kThesisHigh_N = 0.9;

// Problems told at once, of two lines each or more: with more the picture has no room at 800 pixels of height.
constexpr qsizetype kMostProblems = 5;

constexpr int kMostSeed = 1000000;  // six digits can be read out and typed again

}  // namespace

std::unique_ptr<ArmReader> RunPage::make_arm_reader() {
  if (control_->running() || setup_->lesson().isEmpty()) return nullptr;
  return std::make_unique<ArmReader>(control_->opener(), options_.reader());
}

void RunPage::set_binding(const Binding& binding) {
  if (options_.set_binding(binding)) setup_->set_own_instrument(options_.instrument_title());
}

void RunPage::start() { launch(false); }

void RunPage::start_unrecorded() {
  launch(true);
  if (!control_->running()) return;
  problem_->setText(tr("▲ NOT RECORDED: nothing of this attempt is kept. %1").arg(refused_));
  problem_->show();
}

void RunPage::take_focus() { control_->running() ? view_->setFocus() : setup_->focus_start(); }

// A letter that was meant for the instrument makes another person of a name: nobody is added without a word.
bool RunPage::agree_on_person() {
  if (!setup_->person_is_new()) return true;
  const QString name = setup_->person();
  QMessageBox ask(QMessageBox::Question, tr("New trainee"), tr("%1 has not practised here before. Add as a trainee?").arg(name), {}, window());
  ask.setObjectName(QStringLiteral("new_trainee"));
  const QPushButton* add = ask.addButton(tr("Add and start"), QMessageBox::AcceptRole);
  ask.setDefaultButton(ask.addButton(QMessageBox::Cancel));
  ask.exec();
  if (ask.clickedButton() != add) {
    setup_->focus_person();
    return false;
  }
  setup_->know_person(name);
  return true;
}

void RunPage::launch(bool unrecorded) {
  if (control_->running() || setup_->lesson().isEmpty()) return;
  // what is about to run has been looked at, and could be built
  if (preview_timer_.isActive() || !setup_->startable()) preview();
  if (!setup_->startable()) return;
  const bool kept = !unrecorded && !asked_.show && setup_->mode() != QLatin1String("demo");
  if (kept && !agree_on_person()) return;
  events_->clear();
  holds_ = misplaced_ = dropped_ = false;
  for (NowPanel* now : now_panels()) now->set_advice({});
  sounds_.reset();
  problem_->hide();
  unrecorded_->hide();
  session::Options o = options_.attempt(display(), cue_theme_), like = options_.lesson(display());
  if (unrecorded) o.store_path = ":none:";
  if (draws_seed_) {
    const std::string seed = "seed=" + std::to_string(QRandomGenerator::global()->bounded(1, kMostSeed));
    o.settings.push_back(seed);
    like.settings.push_back(seed);
  }
  guide_.begin(like, guided() && !cues_hidden());
  seen_ = o.display = display();
  if (!control_->start(o)) return;
  guide_.show();
  view_->setFocus();
}

// What is left of the last attempt belongs to its lesson.
void RunPage::forget_attempt() {
  events_->clear();
  set_texts({}, {});
  for (SceneView* view : views_) view->set_hold(0);
  right_->setCurrentWidget(now_);
}

void RunPage::preview() {
  preview_timer_.stop();
  if (control_->running() || setup_->lesson().isEmpty()) return;
  if (!shown_lesson_.isEmpty() && shown_lesson_ != setup_->lesson()) {
    forget_attempt();
    preset_ = CameraPreset::kOrbit;  // a view that suits one lesson may hide the work of another
  }
  shown_lesson_ = setup_->lesson();
  asked_ = read_criteria(shown_lesson_.toStdString(), catalogue());
  setup_->set_show(asked_.show);
  options_.set_show(asked_.show);
  base::Problems problems;
  const auto card = control_->preview(options_.attempt(display(), cue_theme_), problems);
  problem_->setVisible(!card);
  setup_->set_startable(card != nullptr);
  if (!card) {
    show_no_scene();
    return show_problems(problems);
  }
  show_card(*card);
  right_->setCurrentWidget(now_);
}

QList<NowPanel*> RunPage::now_panels() const {
  QList<NowPanel*> all{now_};
  if (instructor_) all += instructor_->now();
  return all;
}

QList<CueLegend*> RunPage::legends() const {
  QList<CueLegend*> all{legend_};
  if (instructor_) all += instructor_->legend();
  return all;
}

void RunPage::show_card(const snapshot::SceneCard& card) {
  title_->setText(said(card.title));
  fold_view_bar();
  reader_ = Reader(card);
  const std::string lesson = setup_->lesson().toStdString();
  // what only shows something judges no force
  const ForceBand usual = asked_.show ? ForceBand{0, std::numeric_limits<double>::infinity()} : ForceBand{kThesisLow_N, kThesisHigh_N};
  const std::optional<ForceBand> band = force_band(lesson, catalogue());
  for (NowPanel* now : now_panels()) {
    now->set_scene(reader_, band.value_or(usual), setup_->task(), asked_);
    now->form()->set_params(live_params(lesson, card, catalogue()));
  }
  for (CueLegend* legend : legends()) legend->set_meanings(Reader::meanings(card));
  card_ = card;
  have_card_ = true;
  for (SceneView* view : views_) view->set_card(card, preset_);
  update_hidden();
}

// A lesson that cannot run shows its name and task, and nothing of the lesson before.
void RunPage::show_no_scene() {
  const LessonEntry lesson = lessons_->at(lessons_->row_of(setup_->lesson()));
  snapshot::SceneCard none;
  none.title = (lesson.title).toStdString();
  show_card(none);
  have_card_ = false;
}

QString RunPage::fault_of(const QString& lesson_path) {
  if (control_->running()) return {};
  base::Problems problems;
  return control_->preview(options_.of(lesson_path), problems) ? QString() : problem_words(problems, lesson_path);
}

// an attempt that is kept elsewhere than asked says so while it runs
void RunPage::show_record_warning(const base::Problems& problems) {
  for (const base::Problem& p : problems) {
    if (p.severity == base::Severity::kNote || !p.where.starts_with(record::kRecordPlace)) continue;
    problem_->setText(QStringLiteral("▲ ") + QString::fromStdString(p.message));
    problem_->show();
  }
}

void RunPage::show_problems(const base::Problems& problems) {
  QStringList lines;
  // where the record is all that is missing, the lesson itself can run
  bool only_record = false;
  for (const base::Problem& p : problems) {
    if (p.severity != base::Severity::kError) continue;
    only_record = p.where.starts_with(record::kRecordPlace);
    if (!only_record) break;
    refused_ = QString::fromStdString(p.message);
  }
  unrecorded_->setVisible(only_record);
  for (const base::Problem& p : problems) lines += QString::fromStdString(p.where + "\n    " + p.message);
  problem_->setToolTip(lines.join(QLatin1Char('\n')));
  const qsizetype more = lines.size() - kMostProblems;
  lines = lines.first(std::min(lines.size(), kMostProblems));
  if (more > 0) lines += more == 1 ? tr("… and one more.") : tr("… and %1 more.").arg(more);
  problem_->setText(tr("This lesson cannot run:") + QLatin1Char('\n') + lines.join(QLatin1Char('\n')));
  problem_->show();
}

void RunPage::set_texts(const QString& clock, const QString& banner) {
  for (SceneView* view : views_) view->set_texts(clock, banner);
}

void RunPage::show_finished() {
  const session::Result& r = control_->result();
  result_->set_free_time(metric_target(shown_lesson_.toStdString(), "time.task", catalogue()).high.value_or(0));
  if (asked_.show)
    result_->show_seen(r);
  else
    result_->show_result(r, control_->card(), !r.attempt_id.empty());
  result_->set_criteria(asked_);
  result_->set_can_go_on(setup_->has_next());
  right_->setCurrentWidget(result_);
  for (SceneView* view : views_) view->set_hold(0);
  set_texts(clock_text(r.simulated_s), result_->outcome());
  Q_EMIT attempt_over();
}

// A test shows no answers: neither readings nor cues nor what happened, but in the instructor's window.
void RunPage::update_hidden() {
  const bool hidden = control_->running() && cues_hidden();
  now_->set_readings_hidden(hidden);
  for (NowPanel* now : now_panels()) now->set_running(control_->running());
  event_table_->setVisible(!hidden);
}

void RunPage::show_instructor(bool on) {
  if (on && !instructor_) {
    instructor_ = new InstructorWindow(shown_events_, this);
    connect(instructor_, &InstructorWindow::closed, this, [this] { instructor_button_->setChecked(false); });
    instructor_->now()->set_themes(ui_theme_, cue_theme_);
    instructor_->legend()->set_themes(ui_theme_, cue_theme_);
    connect(instructor_->now()->form(), &LiveForm::changed, this, &RunPage::change);
    if (have_card_) show_card(snapshot::SceneCard(card_));
  }
  if (instructor_) instructor_->setVisible(on);
  instructor_button_->setChecked(on);
}

void RunPage::set_used_controls(const QString& used) {
  used_ = used;
  update_hints();
}

// What falls is told until it is held or back again; a thread that slips is not put back.
void RunPage::hear(const judge::Event& event) {
  const judge::Script& script = control_->card().script;
  events_->add(event, script, control_->card().dt);
  if (event.event >= script.events.size()) return;
  const std::string& id = script.events[event.event].id;
  if (id == "needle.dropped" || id == "thing.dropped" || id == "ring.dropped") dropped_ = true, dropped_at_ = event.step;
  if (id == "host.reset") dropped_ = false;
  update_hints();
}

// Beside what the phase asks: how what has fallen comes back, and that what is held at the wrong place is let go of.
void RunPage::advise(const Reading& reading) {
  const bool holds = reading.held.value_or(false), misplaced = holds && reading.spot == false;
  if (holds && control_->newest()->step > dropped_at_) dropped_ = false;  // a picture may be older than what happened
  const QString words = dropped_                  ? tr("Dropped: put it back with F7, or take it where it lies.")
                        : misplaced && by_mouse() ? tr("Held at the wrong place: open the jaws (B), and take it at the mark.")
                        : misplaced               ? tr("Held at the wrong place: open the jaws, and take it at the mark.")
                                                  : QString();
  for (NowPanel* now : now_panels()) now->set_advice(words);
  if (holds == holds_ && misplaced == misplaced_) return;
  holds_ = holds, misplaced_ = misplaced;
  update_hints();
}

// A control is told when it is needed, until it was used once, in this attempt or an earlier one. A test is taken without what tells an answer.
void RunPage::update_hints() {
  const bool told = control_->running() && by_mouse();
  const auto wanted = [&](const char* what) { return told && !used_.contains(QLatin1String(what)); };
  const bool drives = std::any_of(card_.objects.begin(), card_.objects.end(), [](const snapshot::CardObject& o) {
    return std::find(o.traits.begin(), o.traits.end(), SWAGE_TRAIT_PIERCEABLE) != o.traits.end();
  });
  const bool told_more = told && !cues_hidden();
  const ControlHints hints{wanted("drag"), wanted("close"), drives && holds_ && wanted("drive"), told_more && misplaced_ && wanted("open"),
                           told_more && dropped_};
  for (SceneView* view : views_) view->set_control_hints(hints);
}

}  // namespace swage::console
