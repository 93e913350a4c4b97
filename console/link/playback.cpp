// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/link/playback.hpp"

#include <algorithm>

namespace swage::console {
namespace {

constexpr int kTick_ms = 33;  // 30 pictures a second suffice for playback
constexpr uint64_t kMostSteps = 300;  // steps computed between two pictures: the window stays responsive on a slow machine

}  // namespace

Playback::Playback(Scenes scenes, QObject* parent) : QObject(parent), scenes_(std::move(scenes)) {
  timer_.setInterval(kTick_ms);
  connect(&timer_, &QTimer::timeout, this, &Playback::tick);
}

void Playback::set_length(double length_s, double dt_s) {
  length_s_ = length_s;
  dt_s_ = dt_s;
}

void Playback::stop() {
  playing_ = false;
  timer_.stop();
}

void Playback::go(double time_s) {
  wanted_s_ = std::clamp(time_s, 0.0, length_s_);
  Q_EMIT moved(wanted_s_);
  clock_.start();
  if (!timer_.isActive()) timer_.start();
}

void Playback::toggle() {
  if (length_s_ <= 0) return;
  playing_ = !playing_;
  if (playing_ && wanted_s_ >= length_s_ - 1e-9) wanted_s_ = 0;
  Q_EMIT playing_changed(playing_);
  go(wanted_s_);
}

void Playback::set_loop(bool on) {
  constexpr double kAround_s = 1;  // shows the cause of a moment and its consequence
  loop_from_s_ = on ? std::max(0.0, wanted_s_ - kAround_s) : 0;
  loop_to_s_ = on ? std::min(length_s_, wanted_s_ + kAround_s) : 0;
  Q_EMIT looped(loop_from_s_, loop_to_s_);
}

void Playback::advance() {
  // in nanoseconds: whole milliseconds would lose half of one per picture, nearly a second in a minute
  const double on = static_cast<double>(clock_.nsecsElapsed()) * 1e-9 * speed_;
  clock_.start();
  const double before = wanted_s_;
  wanted_s_ = std::min(wanted_s_ + on, length_s_);
  if (loop_to_s_ > loop_from_s_ && (wanted_s_ >= loop_to_s_ || wanted_s_ < loop_from_s_)) wanted_s_ = loop_from_s_;
  // a slow machine plays more slowly but skips nothing; after a jump the cursor waits for the picture
  if (const std::optional<double> at_s = scenes_.at_s()) {
    const double reach = *at_s + static_cast<double>(kMostSteps) * dt_s_;
    if (wanted_s_ > reach) wanted_s_ = std::max(reach, std::min(before, wanted_s_));
  }
  Q_EMIT moved(wanted_s_);
  if (wanted_s_ >= length_s_) toggle();
}

// advances the cursor during playback, and the scenes towards the cursor; stops when they have reached a resting cursor
void Playback::tick() {
  if (playing_) advance();
  const bool there = scenes_.toward(wanted_s_, kMostSteps);
  if (!there || playing_) return;
  timer_.stop();
  Q_EMIT rested();
}

}  // namespace swage::console
