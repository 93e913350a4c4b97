// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/app/close_guard.hpp"

#include <QMessageBox>
#include <QPushButton>

namespace swage::console {
namespace {

constexpr char kStoppedAtClose[] = "stopped_at_close";

}  // namespace

CloseGuard::CloseGuard(RunPage* run, Settings& settings, QWidget* window) : run_(run), settings_(settings), window_(window) {}

bool CloseGuard::agrees_to_quit() { return !run_->control()->running() || ask(); }

bool CloseGuard::agrees_to_close() {
  const RunControl* control = run_->control();
  return !control->running() || control->options().mode != "test" || ask();
}

// While it is asked the attempt waits, and goes on where the person stays.
bool CloseGuard::ask() {
  RunControl* control = run_->control();
  const bool ran = control->state() == RunControl::State::kRunning;
  if (ran) control->toggle_pause();
  const QString what = control->attempt_id().empty() ? tr("A lesson is running. Closing the window stops it.")
                                                     : tr("A lesson is running. Closing the window stops it; the attempt is kept as stopped.");
  QMessageBox box(QMessageBox::NoIcon, tr("Close Swage?"), what, {}, window_);
  box.setObjectName(QStringLiteral("stop_and_close"));
  const QPushButton* close = box.addButton(tr("Stop and close"), QMessageBox::AcceptRole);
  QPushButton* stay = box.addButton(tr("Go on"), QMessageBox::RejectRole);
  box.setDefaultButton(stay);
  box.setEscapeButton(stay);
  box.exec();
  if (box.clickedButton() == close) return true;
  if (ran && control->state() == RunControl::State::kPaused) control->toggle_pause();
  return false;
}

void CloseGuard::end_attempt() {
  RunControl* control = run_->control();
  if (control->running() && !control->attempt_id().empty()) settings_.set(kStoppedAtClose, true);
  control->stop();
}

void CloseGuard::tell_stopped() {
  if (settings_.text(kStoppedAtClose) == QLatin1String("true"))
    run_->set_notice(tr("The window was closed while a lesson ran: that attempt is kept as stopped."));
  settings_.set(kStoppedAtClose, false);
}

}  // namespace swage::console
