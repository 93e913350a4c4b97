// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Where the picture is taken from, as a person moves it; what is seen from there is in eye.hpp. World frame, +Z up; lengths in mm.
#pragma once

#include <QQuaternion>
#include <QVector3D>

namespace swage::console {

enum class CameraPreset { kOrbit, kSide, kTop, kNear };

/// Turns about a focus. What the person asks for is the goal; the picture glides there.
class OrbitCamera {
 public:
  /// A sphere (mm) that should fill the picture; also the home of the presets.
  void frame(const QVector3D& centre, float radius);
  void look(CameraPreset preset);
  /// From this side, seen on a compass: -90 is from the front.
  void look_from(float yaw_deg);
  void turn(float yaw_deg, float pitch_deg);
  void pan(float dx, float dy);  // fractions of the picture's height
  void zoom(float notches);      // + nearer
  /// Keeps a point (mm) near the middle: the goal moves along when it strays further than half way to the edge. Not after
  /// a pan, until the next preset: then the person wants to look elsewhere.
  void follow(const QVector3D& point);
  /// The same, and `other` (mm: the tips) stays in a picture of this shape (width over height): the goal goes between both, and backs
  /// away in steps where they are too far apart for it.
  void follow_both(const QVector3D& point, const QVector3D& other, float shape);

  /// Looks at a point (mm) and stays there, until the next preset.
  void stay_at(const QVector3D& point);

  /// Looks from this side, this steeply and at the middle of what is framed, until release(): nobody turns, pans or zooms it.
  void hold(float yaw_deg, float pitch_deg);
  void release();
  bool held() const { return held_; }

  /// The same view so that the half of this height fills the half of the picture.
  OrbitCamera showing(float height_mm) const;

  /// The same view so much nearer to the person, mm: what lay so far before the focus is in it.
  OrbitCamera nearer(float mm) const;

  /// Moves towards the goal; returns whether the picture changed.
  bool advance(double dt_s);
  void jump();  // no gliding

  QVector3D eye() const;
  QVector3D up() const;
  QVector3D focus() const { return now_.focus; }
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
  float backed_ = 1;  // by which the goal's distance is multiplied now, so that two things are in the picture
  bool follows_ = true;
  bool held_ = false;
  float held_yaw_ = 0, held_pitch_ = 0;  // deg
};

}  // namespace swage::console
