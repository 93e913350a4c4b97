// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The sounds of cues, made by arithmetic: pitch tells the spot, the number of knocks tells the tips.
#pragma once

#include <QHash>
#include <QString>
#include <QStringList>
#include <vector>

#include "console/cues/cue_theme.hpp"

namespace swage::console {

/// Mono samples, -1 to 1.
using Pcm = std::vector<float>;
inline constexpr int kSoundRate_Hz = 48000;

/// The names that a theme may use.
QStringList tone_names();
/// A sound of 60 to 500 ms that begins and ends in silence; empty for "" and for a name that is not known.
Pcm tone(const QString& name);

/// Which sounds belong to what is shown now: one when a meaning appears, again and again while there is too much force.
/// Makes no sound itself; call at display rate.
class CueSounds {
 public:
  void reset();
  /// `meanings`: all cues now shown. `time_s` of the attempt. Returns names of sounds, usually none.
  QStringList hear(const QStringList& meanings, double time_s, const CueTheme& theme);

 private:
  QStringList before_;
  QHash<QString, double> played_s_;
};

}  // namespace swage::console
