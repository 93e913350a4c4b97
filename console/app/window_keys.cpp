// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/app/window_keys.hpp"

#include <QAction>

namespace swage::console {

void WindowKeys::add(const QString& text, const QKeySequence& key, const std::function<void()>& call) {
  auto* action = new QAction(text, window_);
  action->setShortcut(key);
  action->setShortcutContext(Qt::ApplicationShortcut);
  connect(action, &QAction::triggered, this, call);
  window_->addAction(action);
}

void WindowKeys::add_attempt(RunPage* run, Pages* pages) {
  RunControl* control = run->control();
  add(tr("Start"), Qt::Key_F5, [run, pages] {
    pages->go(QStringLiteral("run"));
    run->start();
  });
  add(tr("Pause"), Qt::Key_F6, [control] { control->toggle_pause(); });
  add(tr("Put back"), Qt::Key_F7, [control] { control->reset_work(); });
  add(tr("Mark"), Qt::Key_F8, [control] { control->mark(); });
  add(tr("Stop"), Qt::SHIFT | Qt::Key_F5, [control] { control->stop(); });
  add(tr("Guide"), Qt::Key_F4, [run] { run->click_guide(); });
  add(tr("Instructor"), Qt::Key_F10, [run] { run->show_instructor(!run->instructor_shown()); });
}

void WindowKeys::add_messages(MessageStrip* messages) {
  add(tr("Message read, lesson taken"), Qt::Key_F3, [messages] { messages->accept(); });
  add(tr("Lesson not now"), Qt::SHIFT | Qt::Key_F3, [messages] { messages->decline(); });
}

void WindowKeys::add_edits(QUndoGroup* edits) {
  for (const bool undo : {true, false}) {
    QAction* action = undo ? edits->createUndoAction(window_) : edits->createRedoAction(window_);
    action->setShortcuts(undo ? QKeySequence::Undo : QKeySequence::Redo);
    // the same key twice is ambiguous, and then does nothing: where it is the desktop's own it stands once
    if (const QKeySequence usual(Qt::CTRL | Qt::Key_Y); !undo && !action->shortcuts().contains(usual))
      action->setShortcuts(action->shortcuts() + QList<QKeySequence>{usual});
    action->setShortcutContext(Qt::ApplicationShortcut);
    window_->addAction(action);
  }
}

}  // namespace swage::console
