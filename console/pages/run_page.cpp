// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/run_page.hpp"

#include <QHBoxLayout>
#include <swage/abi/device.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "console/models/metric_titles.hpp"
#include "console/models/said.hpp"
#include "console/models/words.hpp"
#include "console/widgets/parts.hpp"

namespace swage::console {
namespace {

constexpr int kPreviewDelay_ms =
    80;  // running through the list with the arrow keys loads only where one stays

// the live parameter of a device led by the pointer that is told about which circle it turns a needle
constexpr char kCircleCentre[] = "circle_centre";

}  // namespace

RunPage::RunPage(SessionOpener opener, LessonsModel* lessons, StatusStrip* strip, QWidget* parent)
    : QWidget(parent),
      control_(new RunControl(std::move(opener), this)),
      lessons_(lessons),
      strip_(strip),
      setup_(new SetupPanel(lessons, this)),
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

  preview_timer_.setSingleShot(true);
  preview_timer_.setInterval(kPreviewDelay_ms);
  connect(&preview_timer_, &QTimer::timeout, this, &RunPage::preview);
  connect_setup();
  connect_control();
  connect(now_->form(), &LiveForm::changed, this, &RunPage::change);
  connect(&guide_, &GuideControl::noted, events_, &EventLog::note);
  add_view(view_);
  connect(result_, &ResultPanel::again, this, &RunPage::start);
  connect(result_, &ResultPanel::progress, this, &RunPage::show_progress);
  connect(result_, &ResultPanel::review, this, &RunPage::review);
  connect(result_, &ResultPanel::next, this, [this] { setup_->select_next(); });
  update_state();
}

void RunPage::connect_setup() {
  connect(setup_, &SetupPanel::lesson_changed, &preview_timer_, qOverload<>(&QTimer::start));
  connect(setup_, &SetupPanel::mode_changed, this, &RunPage::update_cues);
  // a verdict of another lesson is gone at once, the new scene comes when the list rests
  connect(setup_, &SetupPanel::lesson_changed, this, [this] {
    if (!control_->running() && shown_lesson_ != setup_->lesson()) forget_attempt();
  });
  connect(setup_, &SetupPanel::start, this, &RunPage::start);
  connect(setup_, &SetupPanel::make_variant, editing_, &LessonEditing::make_variant);
  connect(setup_, &SetupPanel::edit_lesson, editing_, &LessonEditing::edit);
  connect(setup_, &SetupPanel::delete_lesson, editing_, &LessonEditing::remove);
  connect(editing_, &LessonEditing::changed, this, &RunPage::preview);
  connect(editing_, &LessonEditing::failed, this, [this](const QString& words) {
    problem_->setText(words);
    problem_->show();
  });
  connect(editing_, &LessonEditing::try_it, this, [this] {
    setup_->set_mode(QStringLiteral("practice"));
    start();
    Q_EMIT started_elsewhere();
  });
  editing_->set_dress([this](SceneView& view) { view.set_themes(ui_theme_, cue_theme_); });
  editing_->set_live_values([this](const QString& lesson) {
    return shown_lesson_ == lesson ? now_->form()->changed_values() : QVector<LiveForm::Change>();
  });
}

void RunPage::connect_control() {
  connect(control_, &RunControl::opened, this, [this] { show_card(control_->card()); });
  connect(control_, &RunControl::failed, this, &RunPage::show_problems);
  connect(control_, &RunControl::told, this, &RunPage::show_record_warning);
  connect(control_, &RunControl::state_changed, this, &RunPage::update_state);
  connect(control_, &RunControl::frame, this, &RunPage::update_frame);
  connect(control_, &RunControl::finished, this, &RunPage::show_finished);
  connect(control_, &RunControl::happened, this,
          [this](const judge::Event& e) { hear(e); });
  connect(control_, &RunControl::marked, this,
          [this](double t) { events_->note(std::max(0.0, t - 2), tr("Mark")); });
}

void RunPage::set_sound(bool on, double volume) {
  sound_button_->setChecked(on);
  volume_->setValue(static_cast<int>(std::lround(100 * volume)));
}

// a test is taken without help, so it is silent
void RunPage::sound(const Reading& reading, double time_s) {
  const bool heard = sound_button_->isChecked() && cues_button_->isChecked() && !cues_hidden();
  for (const QString& name : sounds_.hear(reading.meanings, time_s, cue_theme_)) {
    if (heard) speaker_.play(tone(name));
  }
  const QString silent = speaker_.why_silent();
  if (!silent.isEmpty())
    sound_button_->setToolTip(tr("No sound device answers (%1). Cues are seen, not heard.").arg(silent));
}

void RunPage::set_themes(const UiTheme& ui, const CueTheme& cues) {
  ui_theme_ = ui;
  cue_theme_ = cues;
  for (SceneView* view : views_) view->set_themes(ui, cues);
  for (NowPanel* now : now_panels()) now->set_themes(ui, cues);
  for (CueLegend* legend : legends()) legend->set_themes(ui, cues);
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

void RunPage::set_expert(ExpertOpener open) {
  guide_.set_expert(std::move(open));
  update_cues();
}

void RunPage::set_notice(const QString& text) { strip_->set_idle(text); }

void RunPage::look(CameraPreset preset) {
  preset_ = preset;
  for (SceneView* view : views_) view->look(preset);
}

void RunPage::add_view(SceneView* view) {
  views_ += view;
  connect(view, &SceneView::pointer, control_, &RunControl::pointer);
  connect(view, &SceneView::circle, this, &RunPage::tell_circle);
  connect(view, &SceneView::control_used, this, [this](const QString& what) {
    used_ += QLatin1Char(' ') + what;
    update_hints();
  });
  if (view == view_) return;
  connect(view, &QObject::destroyed, this, [this, view] { views_.removeOne(view); });
  view->set_themes(ui_theme_, cue_theme_);
  if (have_card_) view->set_card(card_, preset_);
  view->set_instrument(view_->instrument());
  view->set_cues_shown(view_->cues_shown());
  guide_.show_in(view);
}

record::Display RunPage::display() const {
  const auto open = std::find_if(views_.rbegin(), views_.rend(), [](const SceneView* v) { return v->isVisible(); });
  record::Display out = (open != views_.rend() ? *open : view_)->display();
  out.guided = guide_.guides();
  return out;
}

// A view that changes in the middle of an attempt is noted at its moment; the head of the record says how it began.
void RunPage::tell_display() {
  const record::Display now = display();
  if (now == seen_) return;
  seen_ = now;
  control_->note("display: " + record::words(now));
}

void RunPage::change(const QString& instance, const QString& json, const QString& words) {
  const QString problem = control_->change(instance.toStdString(), json.toStdString());
  for (NowPanel* now : now_panels()) now->form()->answer(problem);
  if (problem.isEmpty() && control_->newest()) events_->note(control_->newest()->time_s, words);
}

void RunPage::update_state() {
  using State = RunControl::State;
  const State state = control_->state();
  const bool running = control_->running();
  setup_->set_running(running, state == State::kPaused);
  for (NowPanel* now : now_panels()) now->form()->set_running(running);
  for (CueLegend* legend : legends())
    if (!running) legend->set_active({});
  for (QPushButton* b : {pause_, reset_, mark_, stop_}) b->setEnabled(running);
  pause_->setText(state == State::kPaused ? tr("Resume   F6") : tr("Pause   F6"));
  show_keys_below();
  if (running) right_->setCurrentWidget(now_);
  // while it runs, the mouse over the picture is the instrument when the lesson's device is the mouse
  for (SceneView* view : views_) view->set_instrument(state == State::kRunning && by_mouse());
  update_second();
  update_hints();
  if (state == State::kRunning) {
    rate_clock_.start();
    rate_steps_ = control_->newest() ? control_->newest()->step : 0;
  }
  if (!running) strip_->set_idle(setup_->has_lessons() ? tr("○ Ready") : tr("○ No lessons"));
  if (!running) guide_.end();
  update_cues();
  update_frame();
}

bool RunPage::by_mouse() const {
  const std::vector<snapshot::CardDevice>& devices = control_->card().devices;
  return std::any_of(devices.begin(), devices.end(),
                     [](const snapshot::CardDevice& d) { return (d.flags & SWAGE_DEVICE_POINTER) != 0; });
}

// To the hand that the pointer leads, as a change of its parameters: so it is recorded, and replayed. In a mirrored lesson it moves in the mirror image.
void RunPage::tell_circle(const std::optional<NeedleCircle>& about) {
  NeedleCircle circle = about.value_or(NeedleCircle{});
  if (setup_->mirrored()) circle = mirrored(circle);
  const auto list = [](const QVector3D& v) { return nlohmann::json{v.x(), v.y(), v.z()}; };
  const nlohmann::json change = {{kCircleCentre, list(circle.centre / static_cast<float>(kMmPerM))},
                                 {"circle_axis", list(circle.axis)}};
  for (const snapshot::CardDevice& d : control_->card().devices) {
    const host::PluginInfo* plugin = catalogue().find(d.plugin);
    const bool asks = plugin == nullptr || std::any_of(plugin->params.begin(), plugin->params.end(),
                                                       [](const host::Param& p) { return p.id == kCircleCentre; });
    if (asks && (d.flags & SWAGE_DEVICE_POINTER) != 0) control_->change(d.name, change.dump());
  }
}

void RunPage::update_second() {
  view_->set_second_shown(control_->running() && by_mouse() && second_button_->isChecked());
  view_->set_loupe_shown(second_button_->isChecked());
}

void RunPage::update_cues() {
  // a test is taken without help: only the instructor's window shows cues
  cues_button_->setEnabled(!cues_hidden());
  guide_button_->setEnabled(guide_.possible() && !cues_hidden());
  const bool shown = !cues_hidden() && cues_button_->isChecked();
  for (SceneView* view : views_) view->set_cues_shown(shown);
  legend_->set_in_picture(shown);
  update_hidden();
}

void RunPage::update_frame() {
  const snapshot::Snapshot* newest = control_->newest();
  if (!newest) return;
  if (const snapshot::Snapshot* shown = control_->shown()) {
    for (SceneView* view : views_) view->show_snapshot(*shown);
  }
  guide_.move(control_->shown());
  const bool paused = control_->state() == RunControl::State::kPaused;
  if (!control_->running()) return;
  set_texts(clock_text(newest->time_s), paused ? tr("Paused") : QString());
  tell_display();
  if (paused) return;
  const Reading reading = reader_.read(*newest);
  for (NowPanel* now : now_panels()) now->show_reading(reading, newest->time_s);
  for (CueLegend* legend : legends())
    if (legend != legend_ || !cues_hidden()) legend->set_active(reading.meanings);
  for (SceneView* view : views_) view->set_task(cues_hidden() ? setup_->summary() : said(reading.phase));
  sound(reading, newest->time_s);
  for (SceneView* view : views_) view->set_hold(reading.hold.value_or(0));
  advise(reading);
  // once a second is often enough to read a number
  if (rate_clock_.elapsed() >= 1000) {
    steps_per_s_ =
        static_cast<double>(newest->step - rate_steps_) * 1000.0 / static_cast<double>(rate_clock_.elapsed());
    rate_steps_ = newest->step;
    rate_clock_.restart();
    strip_->show_health(*newest, control_->card(), steps_per_s_, control_->options().store_path != ":none:");
  }
}

}  // namespace swage::console
