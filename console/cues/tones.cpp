// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/cues/tones.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace swage::console {
namespace {

constexpr double kLow_Hz = 260, kHigh_Hz = 780;  // an octave and a half apart, so that they are not confused
constexpr double kKnock_s = 0.05;                // two knocks and the gap between fit into 120 ms
constexpr double kGap_s = 0.07;                  // from knock to knock
constexpr double kEdge_s = 0.003;                // fade at both ends: a shorter one clicks
constexpr double kAgain_s = 0.35;                // between two rattles during excess force
constexpr double kQuiet_s = 0.15;  // shortest interval between two plays of one sound: a flickering cue must not hum
const QString kRattle = QStringLiteral("soft rattle");

double wave(double hertz, double t) { return std::sin(2 * std::numbers::pi * hertz * t); }

// adds amplitude * f(t) from `at_s` on, with a fade at both ends
template <class F>
void add(Pcm& pcm, double at_s, double length_s, double amplitude, F f) {
  const auto first = static_cast<size_t>(at_s * kSoundRate_Hz),
             n = static_cast<size_t>(length_s * kSoundRate_Hz);
  if (pcm.size() < first + n) pcm.resize(first + n, 0.F);
  for (size_t i = 0; i < n; ++i) {
    const double t = static_cast<double>(i) / kSoundRate_Hz;
    const double edge = std::clamp(std::min(t, length_s - t) / kEdge_s, 0.0, 1.0);
    pcm[first + i] += static_cast<float>(amplitude * edge * f(t));
  }
}

void knocks(Pcm& pcm, double hertz, int n) {
  for (int k = 0; k < n; ++k) {
    add(pcm, k * kGap_s, kKnock_s, 0.6, [&](double t) {
      return std::exp(-t / 0.02) * (wave(hertz, t) + 0.3 * wave(2.7 * hertz, t) * std::exp(-t / 0.006));
    });
  }
}

// pseudo-random noise, the same sequence for every sound
double noise(uint32_t& state) {
  state = state * 1664525U + 1013904223U;
  return static_cast<double>(state) / 2147483648.0 - 1.0;
}

}  // namespace

QStringList tone_names() {
  return {QStringLiteral("low, one knock"),
          QStringLiteral("low, two knocks"),
          QStringLiteral("high, one knock"),
          QStringLiteral("high, two knocks"),
          kRattle,
          QStringLiteral("chime"),
          QStringLiteral("falling"),
          QStringLiteral("thud"),
          QStringLiteral("tear"),
          QStringLiteral("click")};
}

Pcm tone(const QString& name) {
  Pcm pcm;
  uint32_t seed = 1;
  switch (tone_names().indexOf(name)) {
    case 0:
    case 1:
      knocks(pcm, kLow_Hz, name.endsWith(QLatin1Char('s')) ? 2 : 1);
      break;
    case 2:
    case 3:
      knocks(pcm, kHigh_Hz, name.endsWith(QLatin1Char('s')) ? 2 : 1);
      break;
    case 4:
      for (int k = 0; k < 4; ++k)
        add(pcm, 0.04 * k, 0.02, 0.25,
            [&](double t) { return std::exp(-t / 0.006) * (wave(1900, t) + wave(2310, t)); });
      break;
    case 5:
      add(pcm, 0, 0.45, 0.3, [](double t) { return std::exp(-t / 0.12) * wave(880, t); });
      add(pcm, 0.09, 0.4, 0.3, [](double t) { return std::exp(-t / 0.12) * wave(1320, t); });
      break;
    case 6:  // one octave down
      add(pcm, 0, 0.25, 0.35, [](double t) { return wave(700 - 0.5 * 1400 * t, t) * std::exp(-t / 0.2); });
      break;
    case 7:
      add(pcm, 0, 0.14, 0.8, [](double t) { return std::exp(-t / 0.04) * wave(110, t); });
      break;
    case 8:
      add(pcm, 0, 0.18, 0.35, [&](double t) { return std::exp(-t / 0.07) * noise(seed); });
      break;
    case 9:
      add(pcm, 0, 0.06, 0.5, [](double t) { return std::exp(-t / 0.004) * wave(1500, t); });
      break;
    default:
      break;
  }
  for (float& v : pcm) v = std::clamp(v, -1.F, 1.F);
  return pcm;
}

void CueSounds::reset() {
  before_.clear();
  played_s_.clear();
}

QStringList CueSounds::hear(const QStringList& meanings, double time_s, const CueTheme& theme) {
  QStringList sounds;
  for (const QString& meaning : meanings) {
    const QString sound = theme.style(meaning).sound;
    if (sound.isEmpty() || sounds.contains(sound)) continue;
    const bool lasting = sound == kRattle;
    if (before_.contains(meaning) && !lasting) continue;
    const auto last = played_s_.constFind(sound);
    const double pause = lasting ? kAgain_s : kQuiet_s;
    if (last != played_s_.constEnd() && time_s >= *last && time_s - *last < pause) continue;
    played_s_[sound] = time_s;
    sounds += sound;
  }
  before_ = meanings;
  return sounds;
}

}  // namespace swage::console
