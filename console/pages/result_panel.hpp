// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "console/cues/ui_theme.hpp"
#include "session/session.hpp"

namespace swage::console {

/// How the attempt ended: met or not yet, why in plain words, and the numbers.
class ResultPanel : public QWidget {
  Q_OBJECT
 public:
  explicit ResultPanel(QWidget* parent = nullptr);
  void set_theme(const UiTheme& theme);
  void show_result(const session::Result& result, const snapshot::SceneCard& card, bool kept);
  QString outcome() const { return outcome_->text(); }
  QString reason() const { return reason_->text(); }

 Q_SIGNALS:
  void again();
  void progress();

 private:
  void paint_outcome();
  UiTheme theme_;
  judge::Outcome state_ = judge::Outcome::kRunning;
  QLabel *outcome_, *reason_, *kept_, *problems_;
  QGridLayout* metrics_;
};

/// Why an attempt ended, in words: the doc of the event, or the event's id made readable.
QString reason_text(const std::string& reason, const judge::Script& script);

}  // namespace swage::console
