// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The cursor of a recorded attempt: it is set, played at a speed, and played in a loop; scenes follow it by a few steps a picture. Times in s.
// GUI thread.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>
#include <optional>

namespace swage::console {

class Playback : public QObject {
  Q_OBJECT
 public:
  struct Scenes {
    /// Plays the scenes towards a time, by at most `most` steps each; true when they have reached it.
    std::function<bool(double time_s, uint64_t most)> toward;
    /// Time of the first scene; no value without one.
    std::function<std::optional<double>()> at_s;
  };
  explicit Playback(Scenes scenes, QObject* parent = nullptr);

  /// Begins with another attempt, at rest.
  void set_length(double length_s, double dt_s);
  void stop();
  void go(double time_s);
  void toggle();
  void set_speed(double speed) { speed_ = speed; }
  /// Switches the loop over a second before and after the cursor.
  void set_loop(bool on);
  bool playing() const { return playing_; }
  /// The scenes are on their way to the cursor, or play.
  bool moving() const { return timer_.isActive(); }
  double wanted_s() const { return wanted_s_; }

 Q_SIGNALS:
  /// The cursor moved.
  void moved(double time_s);
  void playing_changed(bool playing);
  /// The scenes have reached a cursor at rest.
  void rested();
  /// An empty span: no loop.
  void looped(double from_s, double to_s);

 private:
  void tick();
  void advance();

  Scenes scenes_;
  QTimer timer_;
  QElapsedTimer clock_;
  double length_s_ = 0, dt_s_ = 1e-3, speed_ = 1;
  double wanted_s_ = 0, loop_from_s_ = 0, loop_to_s_ = 0;
  bool playing_ = false;
};

}  // namespace swage::console
