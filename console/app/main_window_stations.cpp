// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The main window among the stations of a school: what it says of itself, what instructors say to it, and the page that sees all.
#include <QAction>
#include <algorithm>

#include "console/app/main_window.hpp"
#include "record/identity.hpp"

namespace swage::console {
namespace {

using Kind = record::StationMessage::Kind;

record::StationState state_of(RunControl::State state) {
  switch (state) {
    case RunControl::State::kRunning:
      return record::StationState::kRunning;
    case RunControl::State::kPaused:
      return record::StationState::kPaused;
    case RunControl::State::kFinished:
      return record::StationState::kFinished;
    default:
      return record::StationState::kIdle;
  }
}

void take_snapshot(const snapshot::Snapshot& s, const Reading& reading, record::StationNow& now) {
  now.step = s.step;
  now.time_s = s.time_s;
  now.score = s.score;
  if (reading.force) now.force_N = *reading.force;
  now.phase = reading.phase.toStdString();
  for (const QString& meaning : reading.meanings) now.cues.push_back(meaning.toStdString());
  now.late = s.health.late;
  now.dropped = s.health.dropped;
  now.solver = s.health.solver.steps;
  now.stopped = s.health.quarantined;
  now.silent_devices = static_cast<uint64_t>(
      std::count_if(s.device, s.device + std::min(s.n_device, snapshot::kMaxDevices), [](const auto& d) { return d.stale != 0; }));
}

}  // namespace

void MainWindow::add_stations() {
  stations_page_ = new StationsPage(stations_, &lessons_, pages_);
  pages_->add({QStringLiteral("stations"), tr("Stations"), tr("Who does what at every station, now?"), stations_page_, true,
               [this] { stations_page_->focus_stations(); },
               [this](const UiTheme&, const CueTheme& cues) { stations_page_->set_cues(cues); }});
  connect(stations_, &StationLink::inbox_changed, this, &MainWindow::show_messages);
  connect(messages_, &MessageStrip::answered, this, &MainWindow::answer_message);
  connect(messages_, &MessageStrip::changed, this, &MainWindow::show_message_to_trainee);
  const auto add = [this](const QString& text, const QKeySequence& key, void (MessageStrip::*call)()) {
    auto* action = new QAction(text, this);
    action->setShortcut(key);
    action->setShortcutContext(Qt::ApplicationShortcut);  // also in the trainee's view
    connect(action, &QAction::triggered, messages_, call);
    addAction(action);
  };
  add(tr("Message read, lesson taken"), Qt::Key_F3, &MessageStrip::accept);
  add(tr("Lesson not now"), Qt::SHIFT | Qt::Key_F3, &MessageStrip::decline);
}

void MainWindow::start_stations(StationsOpener opener, const QString& name) {
  RunControl* control = run_->control();
  connect(control, &RunControl::opened, this, [this, control] { reading_ = Reader(control->card()); });
  stations_->set_voice([this] { return station_now(); });
  stations_->set_camera([this] { return run_->view()->grab().toImage(); });
  connect(control, &RunControl::state_changed, this, [this, control] {
    messages_->set_running(control->running());
    stations_->tell_now();
  });
  stations_->start(std::move(opener), name.isEmpty() ? QString::fromStdString(record::station()) : name);
}

record::StationNow MainWindow::station_now() const {
  const RunControl* control = run_->control();
  record::StationNow now;
  now.state = state_of(control->state());
  now.person = run_->setup()->person().toStdString();
  now.mode = run_->setup()->mode().toStdString();
  if (control->state() == RunControl::State::kIdle) {
    const int row = lessons_.row_of(run_->setup()->lesson());
    if (row >= 0) now.lesson_id = lessons_.at(row).id.toStdString(), now.lesson_title = lessons_.at(row).title.toStdString();
    return now;
  }
  now.lesson_id = control->card().lesson_id;
  now.lesson_title = control->card().title;
  now.attempt_id = control->attempt_id();
  now.recorded = !now.attempt_id.empty();
  if (const snapshot::Snapshot* newest = control->newest()) take_snapshot(*newest, reading_.read(*newest), now);
  return now;
}

// A lesson that this station does not have is answered for the trainee, who could do nothing about it.
void MainWindow::show_messages() {
  const std::vector<record::StationMessage> all = stations_->inbox();
  const auto missing = std::find_if(all.begin(), all.end(), [this](const record::StationMessage& m) {
    return m.kind == Kind::kLesson && lessons_.row_of(QString::fromStdString(m.body)) < 0;
  });
  if (missing != all.end()) return stations_->answer(missing->id, QStringLiteral("missing"));  // which comes back here
  messages_->set_messages(all);
}

void MainWindow::answer_message(const record::StationMessage& message, bool accepted) {
  const bool lesson = message.kind == Kind::kLesson;
  if (lesson && accepted) {
    select_lesson(QString::fromStdString(message.body));
    show_page(QStringLiteral("run"));
  }
  stations_->answer(message.id, !lesson ? QStringLiteral("read") : accepted ? QStringLiteral("taken") : QStringLiteral("declined"));
}

void MainWindow::show_message_to_trainee() {
  if (!trainee()) return;
  const QString words = messages_->words();
  trainee()->view()->set_message(words.isEmpty() ? words : tr("%1   (F3: read)").arg(words));
}

}  // namespace swage::console
