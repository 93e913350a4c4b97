// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The keys that work on every page, and in the trainee's window. [main]
#pragma once

#include <QKeySequence>
#include <QUndoGroup>
#include <QWidget>
#include <functional>

#include "console/app/pages.hpp"
#include "console/pages/run_page.hpp"
#include "console/widgets/message_strip.hpp"

namespace swage::console {

class WindowKeys : public QObject {
  Q_OBJECT
 public:
  /// `window`: has the actions; outlives what their calls use.
  explicit WindowKeys(QWidget* window) : QObject(window), window_(window) {}
  void add(const QString& text, const QKeySequence& key, const std::function<void()>& call);
  /// What is done with an attempt. F5 shows the Run page first.
  void add_attempt(RunPage* run, Pages* pages);
  void add_messages(MessageStrip* messages);
  /// Undo and redo, with the keys of the desktop.
  void add_edits(QUndoGroup* edits);

 private:
  QWidget* window_;
};

}  // namespace swage::console
