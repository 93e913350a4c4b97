// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QWidget>

#include "console/view3d/frame_times.hpp"
#include "snapshot/scene_card.hpp"
#include "snapshot/snapshot.hpp"

namespace swage::console {

/// The strip at the bottom of the window: the health of session, devices and record.
class StatusStrip : public QWidget {
  Q_OBJECT
 public:
  explicit StatusStrip(QWidget* parent = nullptr);
  void set_idle(const QString& text);
  void show_health(const snapshot::Snapshot& snapshot, const snapshot::SceneCard& card, double steps_per_s,
                   bool recording);
  void set_graphics(const QString& text);
  /// Frame rate, and the latency from a movement to the frame that shows it; only while frames_shown(). A picture that comes so late that a
  /// hand cannot be led by it is told always, while a lesson runs.
  void show_frames(const FrameTimes& frames, const FrameTimes& latency);
  void set_frames_shown(bool shown) { frames_->setVisible(shown); }
  bool frames_shown() const { return !frames_->isHidden(); }
  QString text() const;

 private:
  void show_graphics();

  QString picture_;    // what draws the picture
  double behind_s_ = 0;  // how late it comes; 0: in time
  bool idle_ = true;
  QLabel *loop_, *device_, *recording_, *frames_, *graphics_;
};

}  // namespace swage::console
