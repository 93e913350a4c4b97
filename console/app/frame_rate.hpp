// SPDX-License-Identifier: LGPL-3.0-or-later
//
// How often and how late the picture in front comes, in the status strip; switched by a key and remembered. [main]
#pragma once

#include <QObject>
#include <QTimer>

#include "console/app/settings.hpp"
#include "console/app/window_pages.hpp"

namespace swage::console {

class FrameRate : public QObject {
  Q_OBJECT
 public:
  /// All outlive it.
  FrameRate(StatusStrip* strip, const WindowPages* pages, Settings& settings);

 public Q_SLOTS:
  void toggle();

 private:
  void show();

  StatusStrip* strip_;
  const WindowPages* pages_;
  Settings& settings_;
  QTimer timer_;
};

}  // namespace swage::console
