// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/instructor_control.hpp"

#include <QGuiApplication>
#include <QMessageBox>
#include <QPushButton>
#include <QScreen>
#include <utility>

namespace swage::console {

InstructorControl::InstructorControl(const Parts& parts) : QObject(parts.page), parts_(parts) {
  connect(parts.control, &RunControl::frame, this, &InstructorControl::watch);
}

void InstructorControl::set_subject(const QString& words) {
  subject_ = words;
  if (window_) window_->set_subject(words);
}

QScreen* InstructorControl::trainees_screen() const { return parts_.presenter->trainees_view()->window()->screen(); }

// Moves the window to a screen that the trainee does not see; false without one.
bool InstructorControl::go_elsewhere() {
  if (window_->isVisible() && window_->screen() != trainees_screen()) return true;
  for (QScreen* screen : QGuiApplication::screens()) {
    if (screen == trainees_screen()) continue;
    window_->setScreen(screen);
    window_->move(screen->availableGeometry().topLeft() + QPoint(20, 20));
    return true;
  }
  return false;
}

bool InstructorControl::ask() {
  QMessageBox box(QMessageBox::NoIcon, tr("Readings in a test"),
                  tr("The trainee sees this screen. If the readings are shown, the attempt and its result tell that they were open."), {},
                  parts_.page->window());
  box.setObjectName(QStringLiteral("readings_in_test"));
  const QPushButton* show = box.addButton(tr("Show them"), QMessageBox::AcceptRole);
  box.setDefaultButton(box.addButton(QMessageBox::Cancel));
  box.exec();
  return box.clickedButton() == show && in_test();
}

void InstructorControl::tell_open() {
  if (std::exchange(were_open_, true)) return;
  parts_.control->note(tr("The readings were open on the trainee's screen.").toStdString());
}

// Either window may have been moved.
void InstructorControl::watch() {
  if (agreed_ || !in_test() || !shown() || window_->screen() != trainees_screen()) return;
  tell_open();
  show(false);
}

void InstructorControl::begin() {
  were_open_ = agreed_ = false;
  if (parts_.presenter->is_test() && shown() && !go_elsewhere()) show(false);
}

void InstructorControl::show(bool on) {
  if (on && !window_) {
    window_ = new InstructorWindow(parts_.events, parts_.page);
    connect(window_, &InstructorWindow::closed, this, [this] { parts_.bar->set_instructor(false); });
    parts_.presenter->add_panels(window_->now(), window_->legend(), AttemptPresenter::For::kInstructor);
    window_->set_subject(subject_);
  }
  if (on && !shown() && in_test() && !go_elsewhere()) {
    on = agreed_ = ask();
    if (on) tell_open();
  }
  if (window_) window_->setVisible(on);
  parts_.bar->set_instructor(on);
}

}  // namespace swage::console
