// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/app/station_report.hpp"

#include <algorithm>

namespace swage::console {
namespace {

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

StationReport::StationReport(const RunControl* control, const SetupPanel* setup, const LessonsModel* lessons, QObject* parent)
    : QObject(parent), control_(control), setup_(setup), lessons_(lessons) {
  connect(control, &RunControl::opened, this, [this] { reading_ = Reader(control_->card()); });
}

record::StationNow StationReport::now() const {
  record::StationNow now;
  now.state = state_of(control_->state());
  now.person = setup_->person().toStdString();
  now.mode = setup_->mode().toStdString();
  if (control_->state() == RunControl::State::kIdle) {
    const int row = lessons_->row_of(setup_->lesson());
    if (row >= 0) now.lesson_id = lessons_->at(row).id.toStdString(), now.lesson_title = lessons_->at(row).title.toStdString();
    return now;
  }
  now.lesson_id = control_->card().lesson_id;
  now.lesson_title = control_->card().title;
  now.attempt_id = control_->attempt_id();
  now.recorded = !now.attempt_id.empty();
  if (const snapshot::Snapshot* newest = control_->newest()) take_snapshot(*newest, reading_.read(*newest), now);
  return now;
}

}  // namespace swage::console
