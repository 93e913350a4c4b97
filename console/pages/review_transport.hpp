// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The row below the Review page's picture: play, speed, loop, time, views.
#pragma once

#include <QBoxLayout>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QWidget>

#include "console/view3d/camera.hpp"

namespace swage::console {

class ReviewTransport : public QWidget {
  Q_OBJECT
 public:
  explicit ReviewTransport(QWidget* parent);
  void set_length(double length_s);
  void set_time(double time_s);
  void set_playing(bool playing);
  QPushButton* loop() { return loop_; }

 Q_SIGNALS:
  void gone_to(double time_s);
  void stepped(double by_s);
  void play_pressed();
  void looped(bool on);
  void speed_chosen(double speed);
  void looked(CameraPreset preset);
  void forces_shown(bool on);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QLayout* make_playback();
  QWidget* make_views();

  QBoxLayout* rows_;
  QPushButton *play_ = nullptr, *loop_ = nullptr;
  QComboBox* speed_ = nullptr;
  QDoubleSpinBox* time_ = nullptr;
};

}  // namespace swage::console
