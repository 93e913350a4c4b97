// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Sound of the cues: a button and a slider, and the loudspeaker behind them. [main]
#pragma once

#include <QPushButton>
#include <QSlider>
#include <QWidget>

#include "console/cues/cue_theme.hpp"
#include "console/cues/speaker.hpp"

namespace swage::console {

class SoundControl : public QWidget {
  Q_OBJECT
 public:
  explicit SoundControl(QWidget* parent = nullptr);
  /// `volume`: loudness of the cues, 0 to 1.
  void set(bool on, double volume);
  bool on() const { return button_->isChecked(); }
  Speaker& speaker() { return speaker_; }

  /// To be called before an attempt: no cue is active.
  void reset() { sounds_.reset(); }
  /// The active cues. All are tracked, and played if `audible` and the button is pressed.
  void hear(const QStringList& meanings, double time_s, const CueTheme& theme, bool audible);

 private:
  QPushButton* button_;
  QSlider* volume_;
  CueSounds sounds_;
  Speaker speaker_;
};

}  // namespace swage::console
