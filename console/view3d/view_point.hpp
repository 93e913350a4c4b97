// SPDX-License-Identifier: LGPL-3.0-or-later
//
// From where the scene is looked at: at marks, square onto a needle's plane, with the eyes of a person or of a microscope. [main]
#pragma once

#include <QSize>
#include <array>
#include <optional>

#include "console/view3d/camera.hpp"
#include "console/view3d/clear_sight.hpp"
#include "console/view3d/eye.hpp"
#include "console/view3d/renderer.hpp"
#include "console/view3d/scene_state.hpp"
#include "console/view3d/stereo_look.hpp"
#include "record/display.hpp"

namespace swage::console {

/// Width over height.
inline float shape_of(const QSizeF& size) { return static_cast<float>(size.width() / std::max(size.height(), 1.0)); }

class ViewPoint {
 public:
  explicit ViewPoint(const SceneState& scene) : scene_(scene) {}
  OrbitCamera camera;

  /// Frames the card that the scene has now, without gliding.
  void frame(CameraPreset preset);
  void look(CameraPreset preset);
  /// Goes to the mark in the world that the preset looks at; whether it does.
  bool look_near();

  void set_stereo(const StereoLook& look);
  /// Nothing: one eye, the instructor's.
  const std::optional<StereoLook>& stereo() const { return stereo_; }
  /// Whether a microscope is looked through.
  bool microscope() const { return stereo_ && stereo_->microscope.on; }
  /// A step of its zoom; whether that changed it.
  bool zoom_microscope(int notches);
  /// Steps of its focus, towards the person or away; whether that moved it. The next scene begins in focus.
  bool focus_microscope(int steps);
  /// How a panel blurs.
  Lens lens(const QSize& panel_px, const Eye& eye) const;
  /// Pixels of the screen that the view is on.
  void set_screen(const QSize& pixels) { screen_px_ = pixels; }
  QSizeF screen_mm_per_pixel() const;
  /// The eyes of a panel of this size in pixels: left and right, or the middle one twice. Only for stereo().
  std::array<Eye, 2> eyes(const QSizeF& panel) const;
  /// What instruments must not hide: from the side the needle that they drive. A trainee's view shows all of them, as a microscope does.
  ClearSight clear_sight() const;
  /// How the scene is seen here, for the record of an attempt.
  record::Display display() const;

 private:
  void look_aside();
  float screen_scale() const;

  const SceneState& scene_;
  CameraPreset preset_ = CameraPreset::kOrbit;
  std::optional<QVector3D> near_;  // the mark looked at
  std::optional<StereoLook> stereo_;
  float focus_mm_ = 0;  // of the microscope, before the middle of what is framed
  QSize screen_px_;
};

}  // namespace swage::console
