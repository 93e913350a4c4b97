// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The viewpoint: at marks, perpendicular to a needle's plane, with the eyes of a person or of a microscope. [main]
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

  /// Frames the present card of the scene, without gliding.
  void frame(CameraPreset preset);
  void look(CameraPreset preset);
  /// The view near, and where a knot is tied or lies, the knot with its wound or loop alone: without the hands, which the view near keeps.
  void look_close();
  /// Moves to the place that the preset looks at (SceneState::subject); returns whether there is or was one.
  bool look_near();

  void set_stereo(const StereoLook& look);
  /// No value: one eye, the instructor's view.
  const std::optional<StereoLook>& stereo() const { return stereo_; }
  /// Whether the view is that of a microscope.
  bool microscope() const { return stereo_ && stereo_->microscope.on; }
  /// Steps of its zoom; returns whether it changed.
  bool zoom_microscope(int notches);
  /// Steps of its focus, towards the person or away; returns whether it changed. The next scene begins in focus.
  bool focus_microscope(int steps);
  /// The depth of field of a panel.
  Lens lens(const QSize& panel_px, const Eye& eye) const;
  /// Size in pixels of the screen that shows the view.
  void set_screen(const QSize& pixels) { screen_px_ = pixels; }
  QSizeF screen_mm_per_pixel() const;
  /// The eyes of a panel of this size in pixels: left and right, or the middle one twice. Only with stereo().
  std::array<Eye, 2> eyes(const QSizeF& panel) const;
  /// The view from the side went behind the work, because a shaft hides it from the front: left and right are exchanged.
  bool behind() const { return preset_ == CameraPreset::kSide && camera.from_behind(); }
  /// The disc that instruments must not hide: around the driven needle in the side view. A trainee's view, as a microscope, hides nothing.
  ClearSight clear_sight() const;
  /// The display settings of this view, for the record of an attempt.
  record::Display display() const;

 private:
  void look_aside();
  void look_past_tool();
  QVector3D handle() const;
  bool drives() const;
  bool looks_along_a_shaft(const QVector3D& sight) const;
  QVector3D shaft(uint32_t tool) const;
  float screen_scale() const;

  const SceneState& scene_;
  CameraPreset preset_ = CameraPreset::kOrbit;
  std::optional<QVector3D> near_;  // the mark that the camera looks at
  std::optional<StereoLook> stereo_;
  float focus_mm_ = 0;  // focus offset of the microscope, before the middle of the framed sphere
  QSize screen_px_;
};

}  // namespace swage::console
