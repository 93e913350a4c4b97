// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QWidget>

#include "snapshot/scene_card.hpp"
#include "snapshot/snapshot.hpp"

namespace swage::console {

/// The strip at the bottom of the window: is everything well?
class StatusStrip : public QWidget {
  Q_OBJECT
 public:
  explicit StatusStrip(QWidget* parent = nullptr);
  void set_idle(const QString& text);
  void show_health(const snapshot::Snapshot& snapshot, const snapshot::SceneCard& card, double steps_per_s,
                   bool recording);
  void set_graphics(const QString& text) { graphics_->setText(text); }
  QString text() const;

 private:
  QLabel *loop_, *device_, *recording_, *graphics_;
};

}  // namespace swage::console
