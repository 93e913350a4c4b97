// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Whether the cues of an attempt are heard, and how loud: a button and a slider, and the loudspeaker behind them. [main]
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

  /// Before an attempt: no cue has been on yet.
  void reset() { sounds_.reset(); }
  /// The cues that are on now. Each is followed, and heard where `audible` and the button is pressed.
  void hear(const QStringList& meanings, double time_s, const CueTheme& theme, bool audible);

 private:
  QPushButton* button_;
  QSlider* volume_;
  CueSounds sounds_;
  Speaker speaker_;
};

}  // namespace swage::console
