// SPDX-License-Identifier: Apache-2.0
//
// Frusta and disparities compared with closed forms of the pinhole camera.
#include "console/view3d/eye.hpp"

#include <gtest/gtest.h>

#include <QColor>
#include <array>
#include <cmath>
#include <numbers>

#include "console/view3d/stereo_look.hpp"

namespace swage::console {
namespace {

const QSizeF kSize(1000, 800);
constexpr float kAspect = 1.25F;

OrbitCamera camera() {
  OrbitCamera c;
  c.frame({1, 2, 3}, 5);
  c.jump();
  return c;
}

/// A point at a depth from the middle eye, beside its axis.
QVector3D at(const OrbitCamera& c, float depth, float x, float y) {
  return c.eye() + c.q_WC().rotatedVector({x, y, -depth});
}

// f in pixels, of a picture 800 high that shows 28 degrees
double focal_px() { return 0.5 * 800 / std::tan(0.5 * 28 * std::numbers::pi / 180); }

double disparity_px(const OrbitCamera& c, const StereoRig& rig, const QVector3D& p) {
  const auto eyes = two_eyes(c, rig, kAspect);
  return eyes[0].project(p, kSize).x() - eyes[1].project(p, kSize).x();
}

TEST(TwoEyes, WhatLiesAtTheConvergenceHasNoDisparity) {
  const OrbitCamera c = camera();
  const float z0 = c.distance();  // 250 mm of a microscope, at its scale
  for (const float x : {-3.F, 0.F, 4.F}) {
    for (const float y : {-2.F, 3.F}) EXPECT_NEAR(disparity_px(c, {}, at(c, z0, x, y)), 0, 1e-2);
  }
  StereoRig nearer;
  nearer.convergence_mm = 200;
  EXPECT_NEAR(disparity_px(c, nearer, at(c, 0.8F * z0, 1, -1)), 0, 1e-2);
  EXPECT_GT(std::abs(disparity_px(c, nearer, at(c, z0, 1, -1))), 5);
}

// pinholes at the distance b with windows that coincide at z0: x_left - x_right = b f (1/z - 1/z0)
TEST(TwoEyes, DisparityFollowsTheClosedForm) {
  const OrbitCamera c = camera();
  for (const float base : {6.F, 24.F, 65.F}) {
    for (const float convergence : {200.F, 250.F, 320.F}) {
      const StereoRig rig{base, convergence, false};
      const double scale = static_cast<double>(c.distance()) / 250, b = scale * static_cast<double>(base),
                   z0 = scale * static_cast<double>(convergence);
      for (const float share : {0.7F, 0.95F, 1.F, 1.3F}) {
        const double z = static_cast<double>(share * c.distance());
        const double expected = b * focal_px() * (1 / z - 1 / z0);
        EXPECT_NEAR(disparity_px(c, rig, at(c, share * c.distance(), 1.5F, -1)), expected, 2e-2)
            << base << " mm, " << convergence << " mm, " << share;
      }
    }
  }
}

TEST(TwoEyes, NothingIsToedIn) {
  const OrbitCamera c = camera();
  const auto eyes = two_eyes(c, {}, kAspect);
  EXPECT_LT((eyes[0].q_WC().rotatedVector({0, 0, 1}) - eyes[1].q_WC().rotatedVector({0, 0, 1})).length(),
            1e-6F);
  // no vertical disparity in any corner
  for (const float x : {-4.F, 4.F}) {
    for (const float y : {-4.F, 4.F}) {
      const QVector3D p = at(c, 0.8F * c.distance(), x, y);
      EXPECT_NEAR(eyes[0].project(p, kSize).y(), eyes[1].project(p, kSize).y(), 1e-2);
    }
  }
  // the left eye is at the left, unless swapped
  EXPECT_LT(QVector3D::dotProduct(eyes[0].position - c.eye(), c.q_WC().rotatedVector({1, 0, 0})), 0);
  EXPECT_EQ(two_eyes(c, {24, 250, true}, kAspect)[0].position, eyes[1].position);
  // eyes at the distance 0 have no disparity
  EXPECT_NEAR(disparity_px(c, {0, 250, false}, at(c, 0.5F * c.distance(), 1, 1)), 0, 1e-3);
}

TEST(TwoEyes, TheAngleOfSightIsTheMicroscopesAtEveryMagnification) {
  OrbitCamera c = camera();
  const auto angle = [&] {
    const auto eyes = two_eyes(c, {}, kAspect);
    return (eyes[0].position - eyes[1].position).length() / c.distance();
  };
  EXPECT_NEAR(angle(), 24.F / 250, 1e-5F);
  c.zoom(8);
  c.jump();
  EXPECT_NEAR(angle(), 24.F / 250, 1e-5F);
}

TEST(CrossEye, LooksAtRightAnglesAndKeepsRightAtTheRight) {
  OrbitCamera c = camera();
  for (const CameraPreset preset : {CameraPreset::kSide, CameraPreset::kTop, CameraPreset::kOrbit}) {
    c.look(preset);
    c.jump();
    const Eye cross = cross_eye(c, {1, 2, 3}, 2, 1);
    const QVector3D right = c.q_WC().rotatedVector({1, 0, 0});
    EXPECT_LT((cross.q_WC().rotatedVector({1, 0, 0}) - right).length(), 1e-3F);
    const bool from_above = preset != CameraPreset::kTop;
    EXPECT_NEAR(cross.q_WC().rotatedVector({0, 0, 1}).z(), from_above ? 1 : 0, 1e-4F);
    // depth for the first eye is height for the second: further away is higher, or lower where the camera looks down
    const QVector3D away = (c.focus() - c.eye()).normalized();
    const double up = 50 - cross.project(QVector3D(1, 2, 3) + away, {100, 100}).y();
    EXPECT_GT(from_above ? up : -up, 15);
    // the sphere fills it
    EXPECT_NEAR(cross.project(QVector3D(1, 2, 3), {100, 100}).x(), 50, 1e-2);
    EXPECT_GT(cross.project(QVector3D(1, 2, 3) + 2 * right, {100, 100}).x(), 95);
  }
}

TEST(MiddleEye, ScaleHoldsAtTheDepthOfThePoint) {
  const OrbitCamera c = camera();
  const Eye eye = middle_eye(c, kAspect);
  for (const float share : {0.7F, 1.F, 1.4F}) {
    const QVector3D a = at(c, share * c.distance(), 1, 1), b = at(c, share * c.distance(), 2, 1);
    const double px = eye.project(b, kSize).x() - eye.project(a, kSize).x();
    EXPECT_NEAR(px * eye.mm_per_pixel(800, a), 1, 2e-3) << share;
  }
}

TEST(StereoLook, PicturesFillTheScreenWithoutOverlap) {
  const QSizeF screen(1920, 1080);
  const auto side = places(StereoLayout::kSideBySide, screen),
             over = places(StereoLayout::kOverUnder, screen);
  EXPECT_EQ(side[0], QRectF(0, 0, 960, 1080));
  EXPECT_EQ(side[1], QRectF(960, 0, 960, 1080));
  EXPECT_EQ(over[1], QRectF(0, 540, 1920, 540));
  EXPECT_EQ(places(StereoLayout::kAnaglyph, screen)[1], QRectF(QPointF(), screen));
  EXPECT_TRUE(places(StereoLayout::kOneEye, screen)[1].isEmpty());
  EXPECT_TRUE(places(StereoLayout::kRightEye, screen)[0].isEmpty());
  for (const StereoLayout l : kStereoLayouts) EXPECT_EQ(layout_of(layout_name(l)), l);
  for (const Mirror m : {Mirror::kNone, Mirror::kLeftRight, Mirror::kUpDown}) EXPECT_EQ(mirror_of(mirror_name(m)), m);
  EXPECT_EQ(layout_of(QStringLiteral("hologram")), StereoLayout::kSideBySide);
}

/// The picture of each eye on its display: the eye's own pixels where the layout has any, else transparent.
std::array<QImage, 2> decoded(StereoLayout layout, const QImage& screen, const QPoint& origin) {
  std::array<QImage, 2> out;
  for (int e = 0; e < 2; ++e) {
    out[static_cast<size_t>(e)] = QImage(screen.size(), QImage::Format_ARGB32);
    for (int y = 0; y < screen.height(); ++y)
      for (int x = 0; x < screen.width(); ++x) {
        const QRgb p = screen.pixel(x, y);
        const int line = y + origin.y(), place = line + x + origin.x();
        QRgb seen = 0;
        if (layout == StereoLayout::kLines && line % 2 == e) seen = p;
        if (layout == StereoLayout::kChecker && place % 2 == e) seen = p;
        if (layout == StereoLayout::kAnaglyph) seen = e == 0 ? qRgb(qRed(p), 0, 0) : qRgb(0, qGreen(p), qBlue(p));
        if (layout == StereoLayout::kAnaglyphGrey) seen = e == 0 ? qRgb(qRed(p), qRed(p), qRed(p)) : qRgb(qBlue(p), qBlue(p), qBlue(p));
        out[static_cast<size_t>(e)].setPixel(x, y, seen);
      }
  }
  return out;
}

QImage noise(unsigned seed) {
  QImage image(31, 17, QImage::Format_RGB32);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      seed = seed * 1664525U + 1013904223U;
      image.setPixel(x, y, 0xff000000U | seed >> 8);
    }
  return image;
}

TEST(StereoLook, EveryOverlaidPictureComesApartIntoItsTwoEyes) {
  const QImage eyes[2] = {noise(1), noise(2)};
  for (const QPoint origin : {QPoint(0, 0), QPoint(3, 0), QPoint(100, 41)}) {
    for (const StereoLayout l : {StereoLayout::kLines, StereoLayout::kChecker, StereoLayout::kAnaglyph, StereoLayout::kAnaglyphGrey}) {
      const auto seen = decoded(l, overlay_eyes(l, eyes[0], eyes[1], origin), origin);
      int pixels[2] = {0, 0};
      for (int e = 0; e < 2; ++e)
        for (int y = 0; y < 17; ++y)
          for (int x = 0; x < 31; ++x) {
            const QRgb s = seen[static_cast<size_t>(e)].pixel(x, y), own = eyes[e].pixel(x, y);
            if (qAlpha(s) == 0) continue;
            ++pixels[e];
            const int grey = qGray(own);
            const QRgb expected = l == StereoLayout::kAnaglyph       ? e == 0 ? qRgb(qRed(own), 0, 0) : qRgb(0, qGreen(own), qBlue(own))
                                  : l == StereoLayout::kAnaglyphGrey ? qRgb(grey, grey, grey)
                                                                     : own;
            ASSERT_EQ(s, expected) << layout_name(l).toStdString() << " eye " << e << " at " << x << ", " << y;
          }
      const int all = 31 * 17;
      EXPECT_NEAR(pixels[0] + pixels[1], l == StereoLayout::kLines || l == StereoLayout::kChecker ? all : 2 * all, 0);
      EXPECT_GT(pixels[1], all / 3);
    }
  }
}

// grey in both pictures stays grey, and each eye's brightness goes to its own colours
TEST(StereoLook, LeastGhostsKeepGreyAndSideOfTheEyes) {
  QImage grey(1, 1, QImage::Format_RGB32), black(1, 1, QImage::Format_RGB32);
  grey.fill(QColor(120, 120, 120));
  black.fill(Qt::black);
  const QColor both = overlay_eyes(StereoLayout::kAnaglyphLeast, grey, grey).pixelColor(0, 0);
  EXPECT_NEAR(both.red(), 120, 3);
  EXPECT_NEAR(both.green(), 120, 3);
  EXPECT_NEAR(both.blue(), 120, 3);
  const QColor left = overlay_eyes(StereoLayout::kAnaglyphLeast, grey, black).pixelColor(0, 0);
  const QColor right = overlay_eyes(StereoLayout::kAnaglyphLeast, black, grey).pixelColor(0, 0);
  EXPECT_NEAR(left.red(), 126, 2);
  EXPECT_EQ(left.green() + left.blue(), 0);
  EXPECT_EQ(right.red(), 0);
  EXPECT_NEAR(right.green(), 138, 2);
}

}  // namespace
}  // namespace swage::console
