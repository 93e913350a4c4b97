// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The main window, who sits at it and with what: the keyboard, a person's instrument, its sensor; how it is left, and what it says at the
// next start.
#include <QCloseEvent>
#include <QKeyEvent>
#include <QMessageBox>
#include <QPushButton>

#include "console/app/calibration_dialog.hpp"
#include "console/app/language.hpp"
#include "console/app/main_window.hpp"

namespace swage::console {
namespace {

constexpr char kStoppedAtClose[] = "stopped_at_close";

}  // namespace

// Enter presses the button that has the keyboard, as Space does: Qt leaves that to dialogs.
void MainWindow::keyPressEvent(QKeyEvent* event) {
  const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  auto* button = enter && !event->isAutoRepeat() ? qobject_cast<QPushButton*>(focusWidget()) : nullptr;
  if (!button) return QMainWindow::keyPressEvent(event);
  button->click();
}

// Who was entered on another page is known here.
void MainWindow::enter_run() {
  SetupPanel* setup = run_->setup();
  if (!run_->control()->running()) setup->set_people(people_->people()->names(), setup->person());
  run_->take_focus();
}

// Each person's own instrument is taken up with the name.
void MainWindow::connect_instrument() {
  setup_->set_devices(held_devices(run_->catalogue()));
  const auto take = [this] {
    const QString person = run_->setup()->person();
    const Binding binding = read_binding(settings_, person);
    setup_->show_binding(binding, person);
    run_->set_binding(binding);
  };
  connect(run_->setup(), &SetupPanel::person_chosen, this, take);
  connect(setup_, &SetupPage::binding_chosen, this, [this](const Binding& binding) {
    console::remember(binding, run_->setup()->person(), settings_);
    run_->set_binding(binding);
  });
  take();
}

void MainWindow::show_calibration() {
  auto* dialog = new CalibrationDialog(UiTheme::stock(ui_id_), {}, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &CalibrationDialog::kept, this, [this] { setup_->show_calibrations(stored_calibrations()); });
  dialog->show();
}

// While it is asked the attempt waits, and goes on where the person stays.
bool MainWindow::agree_to_stop() {
  RunControl* control = run_->control();
  const bool ran = control->state() == RunControl::State::kRunning;
  if (ran) control->toggle_pause();
  const QString what = control->attempt_id().empty() ? tr("A lesson is running. Closing the window stops it.")
                                                     : tr("A lesson is running. Closing the window stops it; the attempt is kept as stopped.");
  QMessageBox ask(QMessageBox::Question, tr("Close Swage?"), what, {}, this);
  ask.setObjectName(QStringLiteral("stop_and_close"));
  const QPushButton* close = ask.addButton(tr("Stop and close"), QMessageBox::AcceptRole);
  QPushButton* stay = ask.addButton(tr("Go on"), QMessageBox::RejectRole);
  ask.setDefaultButton(stay);
  ask.setEscapeButton(stay);
  ask.exec();
  if (ask.clickedButton() == close) return true;
  if (ran && control->state() == RunControl::State::kPaused) control->toggle_pause();
  return false;
}

void MainWindow::quit() {
  RunControl* control = run_->control();
  if (control->running() && !agree_to_stop()) return;
  control->stop();
  close();
}

// A test is not lost unasked. Of practice the next start says what became of it.
void MainWindow::closeEvent(QCloseEvent* event) {
  RunControl* control = run_->control();
  if (control->running() && control->options().mode == "test" && !agree_to_stop()) return event->ignore();
  if (control->running() && !control->attempt_id().empty()) settings_.set(kStoppedAtClose, true);
  control->stop();
  remember();
  trainee_->close();
  event->accept();
}

void MainWindow::offer_languages() {
  QStringList names;
  for (const QString& code : languages()) names += language_name(code);
  setup_->show_languages(languages(), names, settings_.text("language"));
  connect(setup_, &SetupPage::language_chosen, this, [this](const QString& code) { settings_.set("language", code); });
}

void MainWindow::tell_stopped() {
  if (settings_.text(kStoppedAtClose) == QLatin1String("true"))
    run_->set_notice(tr("The window was closed while a lesson ran: that attempt is kept as stopped."));
  settings_.set(kStoppedAtClose, false);
}

}  // namespace swage::console
