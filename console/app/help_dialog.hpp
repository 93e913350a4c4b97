// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QSize>

#include "console/cues/cue_theme.hpp"
#include "console/widgets/parts.hpp"

class QTabWidget;

namespace swage::console {

/// F1: keys and mouse, the meanings of the cues, and the two handbooks, in tabs. The dialog is no larger than its screen.
class HelpDialog : public QDialog {
  Q_OBJECT
 public:
  HelpDialog(const CueTheme& cues, QWidget* parent);

 private:
  QWidget* make_keys();
  static Card lesson_keys(QWidget* parent);
  static Card instrument_keys(QWidget* parent);
  static Card picture_keys(QWidget* parent);
  static Card review_keys(QWidget* parent);
  void add_tab(QWidget* page, const QString& title);
  void add_handbook(const char* name, const QString& title);

  QTabWidget* tabs_ = nullptr;
  QSize wanted_;  // px, of the largest page
};

}  // namespace swage::console
