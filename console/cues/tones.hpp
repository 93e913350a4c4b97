// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Synthesised sounds of cues: the pitch tells the grasp position, the number of knocks whether the tips are used.
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
/// A sound of 60 to 500 ms that begins and ends in silence; empty for "" and for an unknown name.
Pcm tone(const QString& name);

/// Selects the sounds for the cues shown: one when a meaning appears, repeated ones during excess force.
/// Only returns names; to be called at display rate.
class CueSounds {
 public:
  void reset();
  /// `meanings`: all cues now shown. `time_s`: of the attempt. Returns names of sounds, usually none.
  QStringList hear(const QStringList& meanings, double time_s, const CueTheme& theme);

 private:
  QStringList before_;
  QHash<QString, double> played_s_;
};

}  // namespace swage::console
