// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <thread>

#include "console/cues/speaker.hpp"
#include "console/cues/tones.hpp"

namespace swage::console {
namespace {

// amplitude of one frequency in a sound: a single term of its Fourier series
double amplitude(const Pcm& pcm, double hertz) {
  double c = 0, s = 0;
  for (size_t i = 0; i < pcm.size(); ++i) {
    const double a = 2 * std::numbers::pi * hertz * static_cast<double>(i) / kSoundRate_Hz;
    c += static_cast<double>(pcm[i]) * std::cos(a);
    s += static_cast<double>(pcm[i]) * std::sin(a);
  }
  return std::hypot(c, s) / static_cast<double>(pcm.size());
}

double energy(const Pcm& pcm, double from_s, double to_s) {
  double sum = 0;
  const size_t end = std::min(pcm.size(), static_cast<size_t>(to_s * kSoundRate_Hz));
  for (auto i = static_cast<size_t>(from_s * kSoundRate_Hz); i < end; ++i)
    sum += static_cast<double>(pcm[i]) * static_cast<double>(pcm[i]);
  return sum;
}

TEST(Tones, AllAreShortBeginAndEndInSilenceAndNeverClip) {
  for (const QString& name : tone_names()) {
    const Pcm pcm = tone(name);
    const double seconds = static_cast<double>(pcm.size()) / kSoundRate_Hz;
    EXPECT_GE(seconds, 0.04) << name.toStdString();
    EXPECT_LE(seconds, 0.5) << name.toStdString();
    EXPECT_NEAR(pcm.front(), 0, 0.01) << name.toStdString();
    EXPECT_NEAR(pcm.back(), 0, 0.02) << name.toStdString();
    EXPECT_GT(energy(pcm, 0, 1), 1) << name.toStdString();
    for (const float v : pcm) ASSERT_LE(std::abs(v), 1.F) << name.toStdString();
  }
  EXPECT_TRUE(tone("").empty());
  EXPECT_TRUE(tone("trumpet").empty());
}

TEST(Tones, PitchTellsTheSpotAndKnocksTellTheTips) {
  EXPECT_GT(amplitude(tone("low, one knock"), 260), 3 * amplitude(tone("low, one knock"), 780));
  EXPECT_GT(amplitude(tone("high, one knock"), 780), 3 * amplitude(tone("high, one knock"), 260));
  for (const char* pitch : {"low", "high"}) {
    const Pcm one = tone(QString("%1, one knock").arg(pitch)),
              two = tone(QString("%1, two knocks").arg(pitch));
    EXPECT_LE(static_cast<double>(two.size()) / kSoundRate_Hz, 0.121);
    EXPECT_NEAR(energy(two, 0.07, 0.12), energy(two, 0, 0.05), 0.02 * energy(two, 0, 0.05));
    EXPECT_NEAR(energy(two, 0.051, 0.069), 0, 1e-9);
    EXPECT_EQ(energy(one, 0.051, 1), 0);
  }
}

TEST(CueSounds, OnceWhenItAppearsAndAgainWhileThereIsTooMuchForce) {
  const CueTheme theme = CueTheme::stock("thesis");
  CueSounds sounds;
  EXPECT_EQ(sounds.hear({}, 0, theme), QStringList());
  EXPECT_EQ(sounds.hear({"grasp.wrong"}, 0.1, theme), QStringList{"low, one knock"});
  EXPECT_EQ(sounds.hear({"grasp.wrong"}, 0.5, theme), QStringList());
  EXPECT_EQ(sounds.hear({"grasp.good"}, 1.0, theme), QStringList{"high, two knocks"});
  // a flickering cue does not hum
  EXPECT_EQ(sounds.hear({}, 1.05, theme), QStringList());
  EXPECT_EQ(sounds.hear({"grasp.good"}, 1.1, theme), QStringList());
  int rattles = 0;
  for (int i = 0; i < 100; ++i)
    rattles += static_cast<int>(sounds.hear({"grasp.good", "grip.too_hard"}, 2 + 0.01 * i, theme).size());
  EXPECT_EQ(rattles, 3);
  // a new attempt begins at 0 again
  sounds.reset();
  EXPECT_EQ(sounds.hear({"grasp.wrong"}, 0, theme), QStringList{"low, one knock"});
}

template <class Condition>
bool eventually(Condition condition) {
  for (int i = 0; i < 60000 && !condition(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return condition();
}

TEST(Speaker, WithoutADeviceItSaysSoAndNobodyWaits) {
  Speaker speaker("swage_no_such_device");
  speaker.play(tone("chime"));
  EXPECT_TRUE(eventually([&] { return !speaker.why_silent().isEmpty(); }));
  speaker.play(tone("chime"));
  EXPECT_EQ(speaker.written(), 0U);
}

TEST(Speaker, WritesEverySampleToADevice) {
  Speaker speaker("null");
  const Pcm pcm = tone("high, two knocks");
  speaker.play(pcm);
  EXPECT_TRUE(eventually([&] { return speaker.written() >= pcm.size() || !speaker.why_silent().isEmpty(); }));
  EXPECT_EQ(speaker.why_silent(), QString());
  // a muted speaker writes no samples
  const uint64_t before = speaker.written();
  speaker.set_volume(0);
  speaker.play(pcm);
  EXPECT_EQ(speaker.written(), before);
}

}  // namespace
}  // namespace swage::console
