// SPDX-License-Identifier: Apache-2.0
//
// True size and place from ruler measurements, compared with the closed form of the pinhole camera.
#include "console/view3d/true_size.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace swage::console {
namespace {

const QSize kScreen_px(1920, 1080);
const QSizeF kWindow_px(960, 1080);  // one half, side by side

OrbitCamera camera() {
  OrbitCamera c;
  c.frame({3, -2, 5}, 40);
  c.jump();
  return c;
}

TrueSize station(float scale = 1) {
  TrueSize s;
  s.on = true;
  s.screen_mm = {527, 296.4};  // 24 inches
  s.distance_mm = 480;
  s.eye_distance_mm = 62;
  s.scale = scale;
  return s;
}

QSizeF window_mm(const TrueSize& s) {
  const QSizeF mm = mm_per_pixel(s, kScreen_px);
  return {kWindow_px.width() * mm.width(), kWindow_px.height() * mm.height()};
}

/// Screen position of a point given relative to the focus in the camera's axes, mm from the middle of the window.
QPointF on_screen(const Eye& eye, const OrbitCamera& c, const TrueSize& s, const QVector3D& p_C) {
  const QPointF px = eye.project(c.focus() + c.q_WC().rotatedVector(p_C), kWindow_px);
  const QSizeF mm = mm_per_pixel(s, kScreen_px);
  return {(px.x() - 0.5 * kWindow_px.width()) * mm.width(), (0.5 * kWindow_px.height() - px.y()) * mm.height()};
}

TEST(TrueSize, TenMillimetresAreTenMillimetresOnTheScreenForEitherEye) {
  const OrbitCamera c = camera();
  for (const float scale : {1.F, 4.F, 25.F}) {
    const TrueSize s = station(scale);
    for (const Eye& eye : true_eyes(c, s, window_mm(s), false)) {
      const QPointF a = on_screen(eye, c, s, {-5, 0, 0}), b = on_screen(eye, c, s, {5, 0, 0});
      EXPECT_NEAR(b.x() - a.x(), 10.0 * static_cast<double>(scale), 2e-3) << "mm";
      EXPECT_NEAR(a.y(), 0, 1e-3);
      const QPointF low = on_screen(eye, c, s, {0, -5, 0}), high = on_screen(eye, c, s, {0, 5, 0});
      EXPECT_NEAR(high.y() - low.y(), 10.0 * static_cast<double>(scale), 2e-3) << "pixels that are not square too";
      EXPECT_NEAR(eye.mm_per_pixel(kWindow_px.height()) * static_cast<double>(scale), mm_per_pixel(s, kScreen_px).height(), 1e-6);
    }
  }
}

// An eye at (e, 0, d) sees a point at (x, y, z) through the plane z = 0 at e + (x - e) d / (d - z), as it would see the real point.
TEST(TrueSize, EveryPointIsWhereTheEyesWouldSeeTheThingItself) {
  const OrbitCamera c = camera();
  const TrueSize s = station();
  const auto eyes = true_eyes(c, s, window_mm(s), false);
  for (int i = 0; i < 2; ++i) {
    const double e = (i == 0 ? -0.5 : 0.5) * static_cast<double>(s.eye_distance_mm), d = static_cast<double>(s.distance_mm);
    for (const QVector3D p : {QVector3D(30, 20, 0), QVector3D(-40, 10, 60), QVector3D(15, -50, -80), QVector3D(0, 0, 100)}) {
      const QPointF seen = on_screen(eyes[static_cast<size_t>(i)], c, s, p);
      const double share = d / (d - static_cast<double>(p.z()));
      EXPECT_NEAR(seen.x(), e + (static_cast<double>(p.x()) - e) * share, 5e-3) << "mm";
      EXPECT_NEAR(seen.y(), static_cast<double>(p.y()) * share, 5e-3);
    }
  }
  const auto swapped = true_eyes(c, s, window_mm(s), true);
  EXPECT_EQ(swapped[0].position, eyes[1].position);
  EXPECT_NEAR((eyes[0].position - eyes[1].position).length(), s.eye_distance_mm, 1e-3F);
  EXPECT_NEAR((true_eye(c, s, window_mm(s)).position - c.focus()).length(), s.distance_mm, 1e-3F);
}

TEST(TrueSize, APersonLooksSquareOntoTheScreenOrItsMirrorImage) {
  TrueSize s = station();
  const auto looks = [&](float screen, float mirror, bool by_mirror) {
    s.screen_tilt_deg = screen, s.mirror_tilt_deg = mirror;
    return look_down_deg(s, by_mirror);
  };
  EXPECT_FLOAT_EQ(looks(90, 0, false), 0) << "an upright screen";
  EXPECT_FLOAT_EQ(looks(0, 0, false), 90) << "one that lies on the table";
  EXPECT_FLOAT_EQ(looks(60, 0, false), 30);
  EXPECT_FLOAT_EQ(looks(-45, 0, true), 45) << "as in the thesis: face down at 45 degrees over a level mirror";
  EXPECT_FLOAT_EQ(looks(90, 45, true), 90) << "an upright screen behind a mirror at 45 degrees lies flat";
  EXPECT_FLOAT_EQ(looks(-30, 10, true), 40) << "the image is at 20 + 30 = 50 degrees";
}

TEST(TrueSize, AHeldViewIsTurnedByNobody) {
  OrbitCamera c = camera();
  c.hold(-90, 45);
  c.jump();
  const QVector3D eye = c.eye();
  c.turn(20, 5);
  c.zoom(3);
  c.pan(0.1F, 0.1F);
  c.follow({50, 50, 50});
  c.look(CameraPreset::kTop);
  c.stay_at({9, 9, 9});
  c.look_from(10);
  c.jump();
  EXPECT_LT((c.eye() - eye).length(), 1e-4F);
  EXPECT_NEAR(c.up().z(), std::cos(45 * 0.017453292F), 1e-4F);
  c.frame({1, 1, 1}, 20);
  c.jump();
  EXPECT_EQ(c.focus(), QVector3D(1, 1, 1)) << "another lesson has another middle";
  EXPECT_NEAR(c.up().z(), std::cos(45 * 0.017453292F), 1e-4F);
  c.release();
  c.look(CameraPreset::kTop);
  c.jump();
  EXPECT_NEAR(c.up().z(), 0, 0.01F);
  TrueSize none;
  EXPECT_FALSE(none.known()) << "nobody has measured this screen";
  EXPECT_TRUE(station().known());
}

}  // namespace
}  // namespace swage::console
