// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/attempt_presenter.hpp"

#include <QLocale>
#include <algorithm>
#include <limits>

#include "console/models/live_params.hpp"
#include "console/models/said.hpp"
#include "console/models/words.hpp"

namespace swage::console {
namespace {

// the thesis: 0.6 N holds a needle well
constexpr double kThesisLow_N = 0.4, kThesisHigh_N = 0.9;

constexpr double kMarked_s = 2;            // a mark refers to a moment just before the key press
constexpr qint64 kHealthPeriod_ms = 1000;  // a number cannot be read more often than once a second

bool any_has(const snapshot::SceneCard& card, const char* trait) {
  return std::any_of(card.objects.begin(), card.objects.end(), [trait](const snapshot::CardObject& object) {
    return std::find(object.traits.begin(), object.traits.end(), trait) != object.traits.end();
  });
}

/// A needle, and something to drive it through.
bool drives_a_needle(const snapshot::SceneCard& card) { return any_has(card, SWAGE_TRAIT_PIERCING) && any_has(card, SWAGE_TRAIT_PIERCEABLE); }

}  // namespace

AttemptPresenter::AttemptPresenter(const Parts& parts, QObject* parent)
    : QObject(parent), parts_(parts), control_(parts.control), hand_(parts.control, parts.options->catalogue()) {
  connect(control_, &RunControl::happened, this, &AttemptPresenter::hear);
  connect(control_, &RunControl::marked, this,
          [this](double t) { parts_.events->note(std::max(0.0, t - kMarked_s), tr("Mark")); });
  connect(parts_.bar, &ViewBar::next_view_wanted, this, &AttemptPresenter::look_next);
  connect(&guide_, &GuideControl::noted, parts_.events, &EventLog::note);
}

void AttemptPresenter::add_view(SceneView* view) {
  views_ += view;
  connect(view, &SceneView::pointer, control_, &RunControl::pointer);
  connect(view, &SceneView::circle, this,
          [this](const std::optional<NeedleCircle>& about) {
            const QString refused = hand_.turn_about(about, parts_.setup->mirrored());
            if (!refused.isEmpty()) parts_.events->note(control_->newest() ? control_->newest()->time_s : 0, refused);
          });
  connect(view, &SceneView::control_used, this, [this](const QString& what) {
    advice_.use(what);
    update_hints();
  });
  const SceneView* first = views_.first();
  if (view == first) return;
  connect(view, &QObject::destroyed, this, [this, view] { views_.removeOne(view); });
  view->set_themes(ui_theme_, cue_theme_);
  if (have_card_) view->set_card(card_, preset_);
  view->set_instrument(first->instrument());
  view->set_cues_shown(first->cues_shown());
  view->set_texts(first->words().clock, first->words().banner);
  view->set_task(first->words().task);
  guide_.show_in(view);
}

void AttemptPresenter::remove_view(SceneView* view) {
  if (view == views_.first() || !views_.removeOne(view)) return;
  disconnect(view, nullptr, this, nullptr);
  disconnect(view, nullptr, control_, nullptr);
  view->set_ghost(nullptr);
  view->set_instrument(false);
  view->set_control_hints({});
}

void AttemptPresenter::add_panels(NowPanel* now, CueLegend* legend, For reader) {
  panels_ += {now, legend, reader};
  connect(now->form(), &LiveForm::changed, this, &AttemptPresenter::change);
  if (panels_.size() == 1) return;
  now->set_themes(ui_theme_, cue_theme_);
  legend->set_themes(ui_theme_, cue_theme_);
  if (!have_card_) return;
  set_scene(panels_.last());
  now->set_running(control_->running());
}

void AttemptPresenter::set_themes(const UiTheme& ui, const CueTheme& cues) {
  ui_theme_ = ui;
  cue_theme_ = cues;
  for (SceneView* view : views_) view->set_themes(ui, cues);
  for (const Panels& p : panels_) {
    p.now->set_themes(ui, cues);
    p.legend->set_themes(ui, cues);
  }
}

void AttemptPresenter::look(CameraPreset preset) {
  set_next_look(preset);
  for (SceneView* view : views_) view->look(preset);
  if (preset == CameraPreset::kSide) advice_.use(QStringLiteral("side"));
  update_hints();
}

void AttemptPresenter::set_next_look(CameraPreset preset) {
  preset_ = preset;
  parts_.bar->show_view(preset);
}

void AttemptPresenter::look_next() { look(view_after(preset_)); }

void AttemptPresenter::set_scene(const Panels& p) {
  const std::string lesson = parts_.setup->lesson().toStdString();
  const host::Catalogue& catalogue = parts_.options->catalogue();
  // a demonstration judges no force
  const ForceBand usual = asked_.show ? ForceBand{0, std::numeric_limits<double>::infinity()} : ForceBand{kThesisLow_N, kThesisHigh_N};
  p.now->set_scene(reader_, force_band(lesson, catalogue).value_or(usual), parts_.setup->task(), asked_);
  p.now->form()->set_params(live_params(lesson, card_, catalogue));
  p.legend->set_meanings(Reader::meanings(card_));
}

void AttemptPresenter::show_card(const snapshot::SceneCard& card, const Criteria& asked) {
  card_ = card;
  asked_ = asked;
  have_card_ = true;
  reader_ = Reader(card);
  for (const Panels& p : panels_) set_scene(p);
  for (SceneView* view : views_) view->set_card(card, preset_);
  update_hidden();
}

void AttemptPresenter::show_no_scene(const QString& title, const Criteria& asked) {
  snapshot::SceneCard none;
  none.title = title.toStdString();
  show_card(none, asked);
  have_card_ = false;
}

void AttemptPresenter::forget() {
  parts_.events->clear();
  set_texts({}, {});
  for (SceneView* view : views_) view->set_hold(0);
}

void AttemptPresenter::clear() {
  parts_.events->clear();
  advice_.reset();
  for (const Panels& p : panels_) p.now->set_advice({});
  parts_.bar->sound()->reset();
}

record::Display AttemptPresenter::begin(const session::Options& like, bool guide_wanted) {
  guide_.begin(like, guide_wanted && !is_test());
  return seen_ = display();
}

void AttemptPresenter::end(double simulated_s, const QString& banner) {
  for (SceneView* view : views_) view->set_hold(0);
  set_texts(clock_text(simulated_s), banner);
}

void AttemptPresenter::show_pulling(double bears_N, double load_N) {
  const snapshot::Snapshot* newest = control_->newest();
  const auto mN = [](double N) { return QLocale().toString(1e3 * N, 'f', 0); };
  set_texts(clock_text(newest ? newest->time_s : 0), tr("Pulling the knot: %1 of %2").arg(mN(bears_N), with_unit(mN(load_N), "mN")));
}

const SceneView* AttemptPresenter::trainees_view() const {
  const auto open = std::find_if(views_.rbegin(), views_.rend(), [](const SceneView* v) { return v->isVisible(); });
  return open != views_.rend() ? *open : views_.first();
}

record::Display AttemptPresenter::display() const {
  record::Display out = trainees_view()->display();
  out.guided = guide_.guides();
  return out;
}

// A change of the view during an attempt is recorded with its time; the head of the record has the view at the start.
void AttemptPresenter::tell_display() {
  const record::Display now = display();
  if (now == seen_) return;
  seen_ = now;
  control_->note("display: " + record::words(now));
}

void AttemptPresenter::change(const QString& instance, const QString& json, const QString& words) {
  const QString problem = control_->change(instance.toStdString(), json.toStdString());
  for (const Panels& p : panels_) p.now->form()->answer(problem);
  if (problem.isEmpty() && control_->newest()) parts_.events->note(control_->newest()->time_s, words);
}

void AttemptPresenter::hear(const judge::Event& event) {
  const judge::Script& script = control_->card().script;
  parts_.events->add(event, script, control_->card().dt);
  if (event.event >= script.events.size()) return;
  advice_.hear(script.events[event.event].id, event.step);
  update_hints();
}

void AttemptPresenter::update_state() {
  const bool running = control_->running(), moves = control_->state() == RunControl::State::kRunning;
  for (const Panels& p : panels_) {
    p.now->form()->set_running(running);
    if (!running) p.legend->set_active({});
  }
  // during an attempt, the mouse over the picture is the instrument when the lesson's device is the mouse
  for (SceneView* view : views_) view->set_instrument(moves && hand_.is_led());
  update_insets();
  update_hints();
  if (moves) {
    rate_clock_.start();
    rate_steps_ = control_->newest() ? control_->newest()->step : 0;
  }
  if (!running) guide_.end();
}

// the second view shows the depth to a person with a mouse only
void AttemptPresenter::update_insets() {
  SceneView* own = views_.first();
  own->set_second_shown(control_->running() && hand_.is_led() && parts_.bar->insets_on());
  own->set_loupe_shown(parts_.bar->insets_on());
}

// no help in a test: only the instructor's panels show cues
void AttemptPresenter::update_cues() {
  parts_.bar->set_cues_allowed(!is_test());
  const bool shown = !is_test() && parts_.bar->cues_on();
  for (SceneView* view : views_) view->set_cues_shown(shown);
  views_.first()->set_forces_shown(!is_test() && parts_.bar->forces_on());
  views_.first()->set_stress_shown(!is_test() && parts_.bar->detail_on());
  for (const Panels& p : panels_)
    if (p.reader == For::kTrainee) p.legend->set_in_picture(shown);
  update_hidden();
}

void AttemptPresenter::update_hidden() {
  for (const Panels& p : panels_) {
    if (p.reader == For::kTrainee) p.now->set_readings_hidden(control_->running() && is_test());
    p.now->set_running(control_->running());
  }
}

void AttemptPresenter::update_frame() {
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
  const bool changed = advice_.read(reading, newest->step);
  show_reading(reading, newest->time_s);
  if (changed) update_hints();
  show_health(*newest);
}

void AttemptPresenter::show_reading(const Reading& reading, double time_s) {
  const bool test = is_test();
  const QString advice = advice_.words(hand_.is_led());
  for (const Panels& p : panels_) {
    p.now->show_reading(reading, time_s);
    p.now->set_advice(advice);
    if (p.reader == For::kInstructor || !test) p.legend->set_active(reading.meanings);
  }
  for (SceneView* view : views_) {
    view->set_task(test ? parts_.setup->summary() : said(reading.phase));
    view->set_hold(reading.hold.value_or(0));
  }
  // no help in a test: it is silent
  parts_.bar->sound()->hear(reading.meanings, time_s, cue_theme_, parts_.bar->cues_on() && !test);
}

void AttemptPresenter::show_health(const snapshot::Snapshot& newest) {
  const qint64 passed_ms = rate_clock_.elapsed();
  if (passed_ms < kHealthPeriod_ms) return;
  const double steps_per_s = static_cast<double>(newest.step - rate_steps_) * 1000.0 / static_cast<double>(passed_ms);
  rate_steps_ = newest.step;
  rate_clock_.restart();
  parts_.strip->show_health(newest, control_->card(), steps_per_s, control_->options().store_path != ":none:");
}

void AttemptPresenter::set_texts(const QString& clock, const QString& banner) {
  for (SceneView* view : views_) view->set_texts(clock, banner);
}

void AttemptPresenter::toggle_guide(bool on) {
  if (control_->running()) guide_.toggle(on && !is_test(), control_->shown());
}

void AttemptPresenter::set_used_controls(const QString& used) {
  advice_.set_used(used);
  update_hints();
}

// In a test, hints that reveal an answer are hidden.
void AttemptPresenter::update_hints() {
  ControlHints hints;
  if (control_->running() && hand_.is_led())
    hints = advice_.hints(is_test(), drives_a_needle(card_), preset_);
  for (SceneView* view : views_) view->set_control_hints(hints);
}

}  // namespace swage::console
