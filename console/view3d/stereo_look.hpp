// SPDX-License-Identifier: LGPL-3.0-or-later
//
// How the pictures of two eyes share one screen.
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
  kLines,          // of the screen in turn: left, right; passive glasses
  kChecker,        // its pixels like a chess board: DLP
  kAnaglyph,       // red of the left, green and blue of the right
  kAnaglyphGrey,   // the same of grey pictures: no colour fights with itself, cues lose theirs
  kAnaglyphLeast,  // least squares in what the glasses let through (Dubois 2001): least ghosts
  kShutter,        // one after the other, for glasses that shut in turn: a driver with two buffers shows them (quad_window.hpp)
  kOneEye,         // in the middle
  kLeftEye,
  kRightEye
};
/// As a mirror over the hand wants it: every picture reflected in its own place.
enum class Mirror { kNone, kLeftRight, kUpDown };

struct StereoLook {
  StereoRig rig;
  StereoLayout layout = StereoLayout::kSideBySide;
  /// Each picture has the whole screen's shape, pressed into its half: what 3D televisions expect.
  bool squeezed = false;
  Mirror mirror = Mirror::kNone;
  Microscope microscope;
  TrueSize true_size;  // while it is on, eyes and window are those of the station and not the microscope's
};

/// Names for settings and the command line: side, over, lines, checker, anaglyph, grey, least, shutter, one, left, right. An unknown one is
/// side by side.
QString layout_name(StereoLayout layout);
StereoLayout layout_of(const QString& name);
inline constexpr std::array kStereoLayouts = {
    StereoLayout::kSideBySide,   StereoLayout::kOverUnder,     StereoLayout::kLines,  StereoLayout::kChecker,  StereoLayout::kAnaglyph,
    StereoLayout::kAnaglyphGrey, StereoLayout::kAnaglyphLeast, StereoLayout::kShutter, StereoLayout::kOneEye, StereoLayout::kLeftEye, StereoLayout::kRightEye};
/// Both eyes' pictures lie on each other, on the whole screen.
bool overlaid(StereoLayout layout);
/// One picture, for one eye or for both.
bool flat(StereoLayout layout);

/// Names for settings: "", left_right, up_down.
QString mirror_name(Mirror mirror);
Mirror mirror_of(const QString& name);

/// Where the left and the right eye's picture lie on a screen. Both on the whole of it where they are overlaid; of one eye the
/// other is empty.
std::array<QRectF, 2> places(StereoLayout layout, const QSizeF& screen);

/// The two on each other as the layout says, the left alone for kShutter; of equal size, opaque. `origin`: place of their first pixel on the screen, whose lines and
/// pixels a display with lines or a chess board counts.
QImage overlay_eyes(StereoLayout layout, const QImage& left, const QImage& right, const QPoint& origin = {});

}  // namespace swage::console
