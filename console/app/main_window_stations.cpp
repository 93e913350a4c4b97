// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The main window among the stations of a school: what it says of itself, what instructors say to it, and the page that sees all.
#include <QAction>
#include <algorithm>

#include "console/app/main_window.hpp"
#include "console/app/station_report.hpp"
#include "record/identity.hpp"

namespace swage::console {
namespace {

using Kind = record::StationMessage::Kind;

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
  auto* report = new StationReport(control, run_->setup(), &lessons_, this);
  stations_->set_voice([report] { return report->now(); });
  stations_->set_camera([this] { return run_->view()->grab().toImage(); });
  connect(control, &RunControl::state_changed, this, [this, control] {
    messages_->set_running(control->running());
    stations_->tell_now();
  });
  stations_->start(std::move(opener), name.isEmpty() ? QString::fromStdString(record::station()) : name);
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
