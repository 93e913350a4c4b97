// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The instructor's window: readings, cues and events of the attempt, also in a test, in which the trainee's page hides them.
#pragma once

#include <QAbstractItemModel>
#include <QLabel>
#include <QWidget>

#include "console/pages/now_panel.hpp"
#include "console/widgets/cue_legend.hpp"

namespace swage::console {

class InstructorWindow : public QWidget {
  Q_OBJECT
 public:
  /// `events`: the model of the page's event list.
  explicit InstructorWindow(QAbstractItemModel* events, QWidget* parent);
  NowPanel* now() { return now_; }
  CueLegend* legend() { return legend_; }
  /// Who does what: "Ben Okoye · Insertion · Test".
  void set_subject(const QString& words) { subject_->setText(words); }

 Q_SIGNALS:
  void closed();

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  NowPanel* now_;
  CueLegend* legend_;
  QLabel* subject_ = nullptr;
};

}  // namespace swage::console
