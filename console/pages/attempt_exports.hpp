// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Files of the reviewed attempt: a report to print, behind a button; the attempt, its signals and a summary for other programs, in a menu, so
// that the page's title has room.
#pragma once

#include <QAction>
#include <QPushButton>
#include <QVector>
#include <QWidget>

#include "console/link/reviewed_attempt.hpp"

namespace swage::console {

class AttemptExports : public QWidget {
  Q_OBJECT
 public:
  /// The attempt outlives the exports.
  AttemptExports(const ReviewedAttempt& attempt, QWidget* parent);
  /// False while no attempt is shown.
  void set_available(bool on);
  /// Each writes a file. Returns "" or the error.
  QString write_swage(const QString& file) const;
  QString write_signals(const QString& file) const;
  QString write_summary(const QString& file) const;
  QString write_report(const QString& file) const;

 Q_SIGNALS:
  /// Where a file was saved, or why not.
  void told(const QString& words);

 private:
  using Write = QString (AttemptExports::*)(const QString&) const;
  void add_action(const QString& text, const char* name, const QString& title, const QString& ending, const QString& tip,
                  const QKeySequence& key, Write write);
  void save(const QString& title, const QString& ending, Write write);

  const ReviewedAttempt& attempt_;
  QPushButton *report_, *export_;
  QVector<QAction*> actions_;
};

}  // namespace swage::console
