// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The camera as a person moves it; the eyes' views from there are in eye.hpp. World frame, +Z up; lengths in mm.
#pragma once

#include <QQuaternion>
#include <QVector3D>
#include <array>
#include <iterator>
#include <optional>
#include <string_view>

#include "snapshot/scene_card.hpp"

namespace swage::console {

enum class CameraPreset { kOrbit, kSide, kTop, kNear };
/// The views in the order in which F11 goes through them; after the last the first.
inline constexpr std::array kViewOrder = {CameraPreset::kOrbit, CameraPreset::kSide, CameraPreset::kTop, CameraPreset::kNear};
static_assert(std::size(snapshot::kViews) == kViewOrder.size(), "their names, in the same order");
/// The view of a name, as lesson files and the command line have it; no value for other words.
std::optional<CameraPreset> view_named(std::string_view name);
/// The view `steps` of F11 after this one.
CameraPreset view_after(CameraPreset now, int steps = 1);
/// How many steps of F11 lead from one view to another; 0 for the same one.
int steps_between(CameraPreset from, CameraPreset to);

/// Orbits a focus. Commands change the goal; the picture glides to it.
class OrbitCamera {
 public:
  /// A sphere (mm) that should fill the picture; also the home of the presets.
  void frame(const QVector3D& centre, float radius);
  void look(CameraPreset preset);
  /// Distance over that at which the framed sphere fills the picture's height: above 1 for a picture that is narrower than its content.
  void set_room(float factor);
  /// Compass direction from which the scene is seen: -90 is from the front.
  void look_from(float yaw_deg);
  void turn(float yaw_deg, float pitch_deg);
  void pan(float dx, float dy);  // fractions of the picture's height
  void zoom(float notches);      // zooms; positive notches go nearer
  /// Keeps a point (mm) near the middle: the goal follows a point further than half way to the edge. Off after
  /// a pan until the next preset: the person has chosen another place.
  void follow(const QVector3D& point);
  /// As follow(), and keeps `other` (mm: the tips) in a picture of this shape (width over height): the goal is shifted, and backs
  /// away in steps where the two points are too far apart for the picture.
  void follow_both(const QVector3D& point, const QVector3D& other, float shape);

  /// Looks at a point (mm) until the next preset.
  void stay_at(const QVector3D& point);

  /// Fixes direction, pitch and focus (the middle of the framed sphere) until release(): turn, pan and zoom have no effect.
  void hold(float yaw_deg, float pitch_deg);
  void release();
  bool held() const { return held_; }

  /// The same view, scaled so that half of this height fills half of the picture.
  OrbitCamera showing(float height_mm) const;

  /// The same view moved towards the viewer by so many mm: a plane so far before the focus becomes the focal plane.
  OrbitCamera nearer(float mm) const;

  /// Moves towards the goal; returns whether the picture changed.
  bool advance(double dt_s);
  void jump();  // sets the camera to its goal at once

  QVector3D eye() const;
  QVector3D up() const;
  QVector3D focus() const { return now_.focus; }
  /// Whether it looks towards the viewer of the front: what is right there is left here.
  bool from_behind() const;
  float distance() const { return now_.distance; }
  QQuaternion q_WC() const;  // C: +x right, +y up, +z towards the viewer

  static constexpr float kFovDeg = 28;  // as a long lens: little distortion, as under a microscope

 private:
  struct Pose {
    QVector3D focus{0, 0, 0};
    float yaw = -60, pitch = 28, distance = 40;  // deg, deg, mm
  };
  Pose now_, goal_;
  QVector3D home_centre_{0, 0, 0};
  float home_radius_ = 5;
  float room_ = 1;
  float backed_ = 1;  // factor on the goal's distance that keeps two points in the picture
  bool follows_ = true;
  bool held_ = false;
  float held_yaw_ = 0, held_pitch_ = 0;  // deg
};

}  // namespace swage::console
