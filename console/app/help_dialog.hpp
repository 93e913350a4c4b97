// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QDialog>

#include "console/cues/cue_theme.hpp"

namespace swage::console {

/// F1: keys, mouse, and what the cues mean.
class HelpDialog : public QDialog {
  Q_OBJECT
 public:
  HelpDialog(const CueTheme& cues, QWidget* parent);
};

}  // namespace swage::console
