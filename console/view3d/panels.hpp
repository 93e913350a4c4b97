// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The panels of a view: one, with or without insets in its corners, or the two eyes of the trainee's window. [main]
#pragma once

#include <QRectF>
#include <QSizeF>
#include <optional>
#include <vector>

#include "console/view3d/corner.hpp"
#include "console/view3d/renderer.hpp"
#include "console/view3d/view_point.hpp"
#include "console/view3d/wound_surface.hpp"

namespace swage::console {

/// A small view in a corner: perpendicular, near the jaws, which shows the depth to a person with a mouse only; or a wound, magnified.
enum class Inset { kNone, kDepth, kWound };

/// A part of the widget that shows the scene for one eye.
struct Panel {
  QRectF at;    // on the widget
  QSizeF size;  // size at which it is painted, before it is scaled to `at`
  View view;    // eye, and rectangle in the renderer's picture
  Inset inset = Inset::kNone;
};

class PanelLayout {
 public:
  PanelLayout(const SceneState& scene, const ViewPoint& point) : scene_(scene), point_(point) {}
  /// Size of the widget in its pixels, and device pixels per pixel.
  void set_area(const QSize& size, double ratio) { size_ = size, ratio_ = ratio; }
  /// Removes the insets of the last scene.
  void clear();

  /// What has to be redrawn: nothing, the same panels, or panels in other places.
  enum class Change { kNone, kMoved, kLaidOut };
  Change show_second(bool shown);
  Change show_loupe(bool shown);
  Change set_wound(const WoundPlace& wound);
  /// Makes the second view follow the tips, and both insets avoid the object.
  Change advance(double dt_s);
  /// During a drag that began in this panel no inset moves, and the whole drag is the panel's.
  void hold(std::optional<Inset> dragged_in) { dragged_in_ = dragged_in; }
  bool held() const { return dragged_in_.has_value(); }
  /// While a key moves the instrument the second view stays as it is, as long as the tips are in it: directions are learned from a picture
  /// that stands still.
  void set_keys_down(bool down) { keys_down_ = down; }

  std::vector<Panel> panels() const;
  Panel at(const QPointF& position) const;
  /// The panel in whose plane a drag or the wheel at this place moves the tips: the panel there, or the first one where a close-up does not
  /// show the tips, which it would move by nearly nothing, and unseen.
  Panel moved_in(const QPointF& position) const;
  /// Size of the renderer's picture, px: all panels side by side.
  QSize canvas() const;
  /// Of the first panel, in the focal plane.
  double mm_per_pixel() const;

 private:
  /// `share`: of the full size of an inset.
  QRectF corner_at(int corner, double shape, double share = 1) const;
  Panel loupe() const;
  bool shows_tips(const Panel& panel) const;
  Change fit_loupe();
  Change choose_corner(const QVector3D& tips, const QVector3D& aim);
  Change choose_loupe_corner();
  Change follow_tips(double dt_s);
  QRectF second_at() const;
  bool second_there() const { return second_shown_ && !second_.empty(); }

  const SceneState& scene_;
  const ViewPoint& point_;
  QSize size_{1, 1};
  double ratio_ = 1;
  WoundPlace wound_;
  std::optional<Inset> dragged_in_;
  bool keys_down_ = false;
  bool second_shown_ = false, loupe_shown_ = true;
  Bounds second_;         // sphere that the second view shows now
  CornerPlace corner_;    // of the second view
  int loupe_corner_ = 1;  // corner of the loupe
  float loupe_mm_ = 0;    // radius of what the loupe shows, 0 for no loupe
};

}  // namespace swage::console
