// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/app/station_messages.hpp"

#include <algorithm>

#include "console/app/station_report.hpp"
#include "record/identity.hpp"

namespace swage::console {

StationMessages::StationMessages(const WindowPages* pages, const SharedModels& models, LessonRequests* lessons, MessageStrip* strip,
                                 TraineePlace* trainee)
    : pages_(pages), models_(models), lessons_(lessons), strip_(strip), trainee_(trainee) {
  connect(models.stations, &StationLink::inbox_changed, this, &StationMessages::show);
  connect(strip, &MessageStrip::answered, this, &StationMessages::answer);
  connect(strip, &MessageStrip::changed, this, &StationMessages::show_to_trainee);
  connect(trainee, &TraineePlace::shown, this, &StationMessages::show_to_trainee);
}

void StationMessages::start(StationsOpener opener, const QString& name) {
  RunPage* run = pages_->run();
  RunControl* control = run->control();
  StationLink* stations = models_.stations;
  auto* report = new StationReport(control, run->setup(), models_.lessons, stations);
  stations->set_voice([report] { return report->now(); });
  stations->set_camera([run] { return run->view()->grab().toImage(); });
  connect(control, &RunControl::state_changed, this, [this, control] {
    strip_->set_running(control->running());
    models_.stations->tell_now();
  });
  stations->start(std::move(opener), name.isEmpty() ? QString::fromStdString(record::station()) : name);
}

// A lesson that this station does not have is answered for the trainee, who could do nothing about it.
void StationMessages::show() {
  const std::vector<record::StationMessage> all = models_.stations->inbox();
  const auto missing = std::find_if(all.begin(), all.end(), [this](const record::StationMessage& m) {
    return m.kind == StationLink::Kind::kLesson && models_.lessons->row_of(QString::fromStdString(m.body)) < 0;
  });
  if (missing != all.end()) return models_.stations->answer(missing->id, QStringLiteral("missing"));  // which comes back here
  strip_->set_messages(all);
}

void StationMessages::answer(const record::StationMessage& message, bool accepted) {
  const bool lesson = message.kind == StationLink::Kind::kLesson;
  if (lesson && accepted) {
    lessons_->select(QString::fromStdString(message.body));
    pages_->all()->go(QStringLiteral("run"));
  }
  models_.stations->answer(message.id, !lesson ? QStringLiteral("read") : accepted ? QStringLiteral("taken") : QStringLiteral("declined"));
}

void StationMessages::show_to_trainee() {
  if (!trainee_->window()) return;
  const QString words = strip_->words();
  trainee_->window()->view()->set_message(words.isEmpty() ? words : tr("%1   (F3: read)").arg(words));
}

}  // namespace swage::console
