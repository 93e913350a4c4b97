// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/link/run_control.hpp"

#include "console/models/said.hpp"
#include "console/view3d/scene_parts.hpp"

namespace swage::console {
namespace {

constexpr int kPoll_ms = 16;  // display rate; polling does not delay the session
constexpr int kPulling_ms = 12;        // of each poll, once an attempt has ended and its knot is being pulled
constexpr uint64_t kPullSteps = 5;  // between two looks at the clock; a step takes some 0.6 ms

}  // namespace

RunControl::RunControl(SessionOpener opener, QObject* parent)
    : QObject(parent), opener_(std::move(opener)), latest_(std::make_unique<snapshot::Snapshot>()) {
  timer_.setTimerType(Qt::PreciseTimer);
  timer_.setInterval(kPoll_ms);
  connect(&timer_, &QTimer::timeout, this, &RunControl::poll);
  clock_.start();
}

RunControl::~RunControl() {
  if (session_ && running()) session_->stop();
}

std::unique_ptr<snapshot::SceneCard> RunControl::preview(const session::Options& options,
                                                         std::vector<base::Problem>& problems) {
  session::Options quiet = options;
  quiet.store_path = ":none:";
  const std::unique_ptr<session::Session> session = opener_(quiet, problems);
  return session ? std::make_unique<snapshot::SceneCard>(session->card()) : nullptr;
}

const snapshot::Snapshot* RunControl::shown() { return source_.sample(wall_s()); }

bool RunControl::start(const session::Options& options) {
  if (running()) return false;
  session_.reset();
  std::vector<base::Problem> problems;
  session_ = opener_(options, problems);
  if (!session_) {
    set_state(State::kIdle);
    Q_EMIT failed(problems);
    return false;
  }
  options_ = options;
  card_ = session_->card();
  result_ = {};
  source_.clear();
  Q_EMIT opened();
  if (!problems.empty()) Q_EMIT told(problems);
  attempt_id_ = session_->result().attempt_id;
  session_->start();
  set_state(options.start_paused ? State::kPaused : State::kRunning);
  timer_.start();
  return true;
}

void RunControl::toggle_pause() {
  if (!running() || session_->finished()) return;
  const bool pause = state_ == State::kRunning;
  session_->pause(pause);
  set_state(pause ? State::kPaused : State::kRunning);
}

void RunControl::reset_work() {
  if (!running()) return;
  for (uint32_t i = 0; i < card_.objects.size(); ++i) {
    if (role_of(card_, i) == Role::kWork) session_->reset_object(card_.objects[i].name);
  }
}

void RunControl::mark() {
  if (!running()) return;
  session_->mark("");
  Q_EMIT marked(newest() ? newest()->time_s : 0);
}

void RunControl::note(const std::string& text) {
  if (running()) session_->mark(text);
}

void RunControl::stop() {
  if (!running()) return;
  session_->stop();
  finish();
}

void RunControl::pointer(const swage_pointer& input, qint64 due_ns) {
  if (state_ == State::kRunning) session_->pointer(input, due_ns);
}

QString RunControl::change(const std::string& instance, const std::string& json) {
  if (!running()) return tr("Nothing runs.");
  base::Problems problems;
  if (session_->change(instance, json, problems)) return {};
  return problems.empty() ? tr("It was refused.") : said_message(problems.front().message);
}

void RunControl::poll() {
  if (!session_) return;
  const bool over = session_->finished();
  if (over && running() && pull_on()) return;
  if (session_->latest(*latest_)) source_.push(*latest_, wall_s());
  for (judge::Event event; session_->next_event(event);) Q_EMIT happened(event);
  Q_EMIT frame();
  if (over && running()) finish();
}

/// Pulls the knot of a passed attempt for a while. False when there is nothing left to pull.
bool RunControl::pull_on() {
  QElapsedTimer clock;
  clock.start();
  session::PullProgress now;
  do {
    if (!session_->pull_knot(kPullSteps, now)) return false;
  } while (clock.elapsed() < kPulling_ms);
  Q_EMIT pulling(now.bears, now.load);
  return true;
}

void RunControl::finish() {
  timer_.stop();
  session_->wait();  // the session has finished: this stops its threads, after which the result is complete
  // shows the final state
  if (session_->latest(*latest_)) source_.push(*latest_, wall_s());
  for (judge::Event event; session_->next_event(event);) Q_EMIT happened(event);
  result_ = session_->result();
  attempt_id_ = result_.attempt_id;
  set_state(State::kFinished);
  Q_EMIT frame();
  Q_EMIT finished();
}

void RunControl::set_state(State state) {
  if (state_ == state) return;
  state_ = state;
  Q_EMIT state_changed();
}

}  // namespace swage::console
