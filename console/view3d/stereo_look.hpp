// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Layouts by which the pictures of two eyes share one screen.
#pragma once

#include <QImage>
#include <QRectF>
#include <QString>
#include <array>

#include "console/view3d/eye.hpp"
#include "console/view3d/microscope.hpp"
#include "console/view3d/true_size.hpp"

namespace swage::console {

enum class StereoLayout {
  kSideBySide,
  kOverUnder,
  kLines,          // alternate lines of the screen: left, right; passive glasses
  kChecker,        // alternate pixels in a checkerboard: DLP
  kAnaglyph,       // red of the left, green and blue of the right
  kAnaglyphGrey,   // as kAnaglyph, of grey pictures: no retinal rivalry by colour, but cues lose theirs
  kAnaglyphLeast,  // least squares for the filters of the glasses (Dubois 2001): least ghosting
  kShutter,        // alternating, for shutter glasses: a quad-buffered driver shows them (quad_window.hpp)
  kOneEye,         // one eye in the middle
  kLeftEye,
  kRightEye
};
/// Reflection of each picture in its own place, for a mirror over the hand.
enum class Mirror { kNone, kLeftRight, kUpDown };

struct StereoLook {
  StereoRig rig;
  StereoLayout layout = StereoLayout::kSideBySide;
  /// Each picture has the whole screen's shape and is scaled to half its width: for 3D televisions.
  bool squeezed = false;
  Mirror mirror = Mirror::kNone;
  Microscope microscope;
  TrueSize true_size;  // while it is on, eyes and window are the station's and not the microscope's
};

/// Names for settings and the command line: side, over, lines, checker, anaglyph, grey, least, shutter, one, left, right. An unknown one is
/// side by side.
QString layout_name(StereoLayout layout);
StereoLayout layout_of(const QString& name);
inline constexpr std::array kStereoLayouts = {
    StereoLayout::kSideBySide,   StereoLayout::kOverUnder,     StereoLayout::kLines,  StereoLayout::kChecker,  StereoLayout::kAnaglyph,
    StereoLayout::kAnaglyphGrey, StereoLayout::kAnaglyphLeast, StereoLayout::kShutter, StereoLayout::kOneEye, StereoLayout::kLeftEye, StereoLayout::kRightEye};
/// True when both eyes' pictures cover the whole screen.
bool overlaid(StereoLayout layout);
/// True for a single picture, of one eye or of both.
bool flat(StereoLayout layout);

/// Names for settings: "", left_right, up_down.
QString mirror_name(Mirror mirror);
Mirror mirror_of(const QString& name);

/// Rectangles of the left and the right eye's picture on a screen. Both are the whole screen where they are overlaid; with one eye the
/// other is empty.
std::array<QRectF, 2> places(StereoLayout layout, const QSizeF& screen);

/// The two pictures combined, of equal size, opaque; the left alone for kShutter. `origin`: their first pixel's place on the screen, whose
/// lines and pixels are counted for interleaving.
QImage overlay_eyes(StereoLayout layout, const QImage& left, const QImage& right, const QPoint& origin = {});

}  // namespace swage::console
