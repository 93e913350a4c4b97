// SPDX-License-Identifier: LGPL-3.0-or-later
//
// How the pictures of two eyes share one screen.
#pragma once

#include <QImage>
#include <QRectF>
#include <QString>
#include <array>

#include "console/view3d/eye.hpp"

namespace swage::console {

enum class StereoLayout { kSideBySide, kOverUnder, kAnaglyph, kOneEye };

struct StereoLook {
  StereoRig rig;
  StereoLayout layout = StereoLayout::kSideBySide;
  /// Each picture has the whole screen's shape, pressed into its half: what 3D televisions expect.
  bool squeezed = false;
};

/// Names for settings and the command line: side, over, anaglyph, one. An unknown one is side by side.
QString layout_name(StereoLayout layout);
StereoLayout layout_of(const QString& name);
inline constexpr std::array kStereoLayouts = {StereoLayout::kSideBySide, StereoLayout::kOverUnder,
                                              StereoLayout::kAnaglyph, StereoLayout::kOneEye};

/// Where the left and the right eye's picture lie on a screen. Both on the whole of it for an anaglyph; of one eye the
/// second is empty.
std::array<QRectF, 2> places(StereoLayout layout, const QSizeF& screen);

/// Red of the left picture, green and blue of the right one; of equal size, opaque.
QImage red_cyan(const QImage& left, const QImage& right);

}  // namespace swage::console
