// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The trainee's place beside the main window: the scene in a window of its own, its layout, and the station's measurements, by which hand
// and tool coincide. The layout is kept in the settings. While the Review page is in front and no attempt runs, the window shows the
// attempt that is reviewed. [main]
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <string>

#include "console/app/settings.hpp"
#include "console/app/station.hpp"
#include "console/app/trainee_window.hpp"
#include "console/app/window_pages.hpp"

namespace swage::console {

class StationDialog;

class TraineePlace : public QObject {
  Q_OBJECT
 public:
  /// `pages`: whose attempts are shown, and whose Run page has the device that is placed. `window`: parent of the dialogs. All outlive this.
  TraineePlace(const WindowPages* pages, Settings& settings, QWidget* window);
  ~TraineePlace() override;

  /// The trainee's window; nullptr while it is closed.
  TraineeWindow* window() { return window_.get(); }
  void show();
  void show_with(StereoLayout layout);
  void toggle();
  void close();
  void show_settings();
  /// Opens the dialog of true size (by a ruler) and registration (with an arm).
  void show_station();
  /// Writes the layout of the window to the settings; measurements are written at once.
  void remember() { console::remember(look_, settings_); }

 Q_SIGNALS:
  /// The window was opened or its layout changed.
  void shown();

 private:
  void show_mark(const std::optional<QPointF>& at_mm);
  void take_station();
  std::optional<Placement> place_hand(const std::string& device);
  void choose_scene();

  const WindowPages* pages_;
  RunPage* run_;
  Settings& settings_;
  QWidget* parent_;
  Station station_;
  TraineeLook look_;
  std::unique_ptr<TraineeWindow> window_;
  std::optional<bool> replays_;  // whether the window shows the attempt under review; no value for a new window
  TraineeSettings* form_ = nullptr;
  StationDialog* station_dialog_ = nullptr;
};

}  // namespace swage::console
