// SPDX-License-Identifier: Apache-2.0
#include "console/view3d/camera.hpp"

#include <gtest/gtest.h>

#include "console/view3d/eye.hpp"

namespace swage::console {
namespace {

QPointF project(const OrbitCamera& camera, const QVector3D& p, const QSizeF& size) {
  return middle_eye(camera, static_cast<float>(size.width() / size.height())).project(p, size);
}

TEST(Camera, FramedSphereFillsThePictureAndNoMore) {
  OrbitCamera camera;
  camera.frame({1, 2, 3}, 4);
  camera.jump();
  const QSizeF size(800, 600);
  const QPointF middle = project(camera, {1, 2, 3}, size);
  EXPECT_NEAR(middle.x(), 400, 0.01);
  EXPECT_NEAR(middle.y(), 300, 0.01);
  // a point of the sphere on the outline, straight above in the picture
  const QPointF top = project(camera, QVector3D(1, 2, 3) + 4 * camera.up(), size);
  EXPECT_GT(top.y(), 0);
  EXPECT_LT(top.y(), 30);
}

TEST(Camera, AxesAreRightHandedAndFaceTheViewer) {
  OrbitCamera camera;
  for (const CameraPreset preset : {CameraPreset::kOrbit, CameraPreset::kSide, CameraPreset::kTop}) {
    camera.look(preset);
    camera.jump();
    const QQuaternion q = camera.q_WC();
    const QVector3D to_viewer = (camera.eye() - camera.focus()).normalized();
    EXPECT_LT((q.rotatedVector({0, 0, 1}) - to_viewer).length(), 1e-4F);
    EXPECT_LT((q.rotatedVector({0, 1, 0}) - camera.up()).length(), 1e-4F);
    // what is to the right of the focus appears to the right
    const QSizeF size(100, 100);
    const QPointF right = project(camera, camera.focus() + q.rotatedVector({1, 0, 0}), size);
    EXPECT_GT(right.x(), 50);
    EXPECT_NEAR(right.y(), 50, 0.01);
  }
}

TEST(Camera, GlidesToItsGoalAndRests) {
  OrbitCamera camera;
  camera.jump();
  EXPECT_FALSE(camera.advance(0.016));
  camera.look(CameraPreset::kTop);
  int pictures = 0;
  while (camera.advance(0.016)) ASSERT_LT(++pictures, 200);
  EXPECT_GT(pictures, 10);
  EXPECT_NEAR(camera.up().z(), 0, 0.01);
}

TEST(Camera, FollowsWhatStraysUntilAPersonPans) {
  OrbitCamera camera;
  camera.frame({0, 0, 0}, 5);
  camera.jump();
  camera.follow({0, 0, 1});
  EXPECT_FALSE(camera.advance(1)) << "near the middle nothing moves";
  camera.follow({0, 0, 12});
  camera.jump();
  const QPointF at = project(camera, {0, 0, 12}, {600, 600});
  EXPECT_GT(at.y(), 60);  // a quarter from the top, less the part nearer to the camera
  EXPECT_LT(at.y(), 300);
  camera.pan(0.3F, 0);
  const QVector3D focus = camera.focus();
  camera.follow({0, 0, 40});
  camera.jump();
  EXPECT_EQ(camera.focus(), focus);
}

// A dropped needle and the tips that released it both stay in the picture, and the camera steps nearer as they approach each other.
TEST(Camera, KeepsTheTipsInThePictureBesideWhatItFollows) {
  const QSizeF size(670, 485);
  const auto shape = static_cast<float>(size.width() / size.height());
  const QRectF picture(QPointF(), size);
  OrbitCamera camera;
  camera.frame({0, 0, 0}, 2.5F);
  camera.look(CameraPreset::kOrbit);
  camera.jump();
  const float near = camera.distance();
  const auto follow = [&](const QVector3D& needle, const QVector3D& tips) {
    for (int i = 0; i < 20; ++i) camera.follow_both(needle, tips, shape), camera.jump();
  };
  follow({0, 0, 0}, {1, 0, 1});
  EXPECT_EQ(camera.focus(), QVector3D(0, 0, 0)) << "both near the middle: nothing moves";
  const QVector3D needle(-3, -2, -1), tips(3, 0, 2);
  follow(needle, tips);
  EXPECT_TRUE(picture.contains(project(camera, needle, size)));
  EXPECT_TRUE(picture.contains(project(camera, tips, size)));
  EXPECT_GT(camera.distance(), near);
  const QVector3D focus = camera.focus();
  follow(needle, tips);
  EXPECT_LT((camera.focus() - focus).length(), 1e-3F) << "and rests";
  follow(needle, {40, 0, 0});
  EXPECT_TRUE(picture.contains(project(camera, needle, size))) << "the needle comes first";
  EXPECT_LE(camera.distance(), 2.5F * near);
  follow({0, 0, 0}, {0, 0, 1});
  EXPECT_NEAR(camera.distance(), near, 1e-3);
}

TEST(Camera, NearStaysWhereItIsPut) {
  OrbitCamera camera;
  camera.frame({0, 0, 0}, 5);
  camera.look(CameraPreset::kOrbit);
  camera.jump();
  const float far = camera.distance();
  camera.look(CameraPreset::kNear);
  camera.stay_at({1, 2, 3});
  camera.follow({0, 0, 40});
  camera.jump();
  EXPECT_LT(camera.distance(), 0.8F * far);
  EXPECT_EQ(camera.focus(), QVector3D(1, 2, 3));
  // a preset frames the whole scene again
  camera.look(CameraPreset::kOrbit);
  camera.jump();
  EXPECT_FLOAT_EQ(camera.distance(), far);
  EXPECT_EQ(camera.focus(), QVector3D(0, 0, 0));
}

TEST(Camera, ScaleIsTrueAtTheFocus) {
  OrbitCamera camera;
  camera.frame({0, 0, 0}, 5);
  camera.look(CameraPreset::kTop);
  camera.jump();
  const QPointF a = project(camera, {0, 0, 0}, {800, 600}), b = project(camera, {1, 0, 0}, {800, 600});
  EXPECT_NEAR((b.x() - a.x()) * middle_eye(camera, 4.F / 3).mm_per_pixel(600), 1, 1e-3);
}

// a picture of half the width shows as much across from further away, also after the person has zoomed
TEST(Camera, RoomIsKeptOverViewsAndZoom) {
  OrbitCamera camera;
  camera.frame({0, 0, 0}, 5);
  camera.jump();
  const float usual = camera.distance();
  camera.set_room(1.5F);
  camera.jump();
  EXPECT_NEAR(camera.distance(), 1.5F * usual, 1e-3);
  camera.look(CameraPreset::kOrbit);
  camera.jump();
  EXPECT_NEAR(camera.distance(), 1.5F * usual, 1e-3);
  camera.zoom(2);
  camera.jump();
  const float zoomed = camera.distance();
  camera.set_room(1);
  camera.jump();
  EXPECT_NEAR(camera.distance(), zoomed / 1.5F, 1e-3);
}

TEST(Camera, KnowsThatItLooksFromBehind) {
  OrbitCamera camera;
  for (const CameraPreset from : kViewOrder) {
    camera.look(from);
    camera.jump();
    EXPECT_FALSE(camera.from_behind()) << static_cast<int>(from);
  }
  camera.look(CameraPreset::kSide);
  camera.look_from(90);
  camera.jump();
  EXPECT_TRUE(camera.from_behind());
  camera.look_from(-60);
  camera.jump();
  EXPECT_FALSE(camera.from_behind());
}

TEST(Camera, F11GoesThroughTheViewsAndTellsHowFarItIs) {
  EXPECT_EQ(view_after(CameraPreset::kOrbit), CameraPreset::kSide);
  EXPECT_EQ(view_after(CameraPreset::kNear), CameraPreset::kOrbit);
  for (const CameraPreset from : kViewOrder)
    for (const CameraPreset to : kViewOrder) EXPECT_EQ(view_after(from, steps_between(from, to)), to);
  EXPECT_EQ(steps_between(CameraPreset::kTop, CameraPreset::kSide), 3);
}

}  // namespace
}  // namespace swage::console
