// SPDX-License-Identifier: Apache-2.0
//
// Tests that need pixels: under Xvfb with software OpenGL.
#include <QLineF>
#include <QProcess>
#include <QStandardPaths>
#include <QWheelEvent>
#include <algorithm>
#include <functional>

#include "gl_fixture.hpp"

namespace swage::test {
namespace {

using console::RunControl;

TEST_F(Gl, NeedleIsLitAndItsRegionRed) {
  launch.theme = "dark";
  open_ready();
  if (IsSkipped()) return;
  const QImage image = view()->image();
  ASSERT_FALSE(image.isNull());
  // the needle: 6 mm of 0.1 mm wire at about 77 px/mm; a highlight runs along it, and a quarter of it is the region
  EXPECT_GT(count(image, bright), 100);
  EXPECT_GT(count(picture(), red), 300);
  // antialiased: the edge has colours between the region's and the floor's
  const int edge = count(
      picture(), [](const QColor& c) { return c.red() > 70 && c.red() < 120 && c.red() > 1.4 * c.green(); });
  EXPECT_GT(edge, 40);
  // the picture has more than one colour: floor, grid, jaws, shadow
  EXPECT_GT(count(picture(), [](const QColor& c) { return c.lightness() < 60; }), 5000);
}

TEST_F(Gl, GoodGraspColoursTheNeedle) {
  script.rate = 10;
  script.end_s = 0;
  open_ready();
  if (IsSkipped()) return;
  const auto green = [](const QColor& c) {
    return c.green() > 90 && c.green() > 1.8 * c.red() && c.green() > 1.8 * c.blue();
  };
  EXPECT_EQ(count(view()->image(), green), 0);
  click("start");
  ASSERT_TRUE(wait_for_time(9));
  QTest::keyClick(window.get(), Qt::Key_F6);
  settle();
  EXPECT_GT(count(view()->image(), green), 500);
  // without cues the needle has the colour of steel
  click("cues");
  settle();
  EXPECT_EQ(count(view()->image(), green), 0);
}

TEST_F(Gl, DragTurnsWheelZoomsAndPresetsFrame) {
  open_ready();
  if (IsSkipped()) return;
  const QImage before = picture();
  const QPoint middle = view()->rect().center();
  QTest::mousePress(view(), Qt::LeftButton, {}, middle);
  for (int i = 1; i <= 10; ++i) QTest::mouseMove(view(), middle + QPoint(12 * i, 0));
  QTest::mouseRelease(view(), Qt::LeftButton, {}, middle + QPoint(120, 0));
  settle();
  const QImage turned = picture();
  EXPECT_GT(changed(before, turned), 0.02);
  const float distance = view()->camera().distance();
  QWheelEvent wheel(middle, view()->mapToGlobal(middle), {}, {0, 360}, Qt::NoButton, Qt::NoModifier,
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(view(), &wheel);
  settle();
  EXPECT_LT(view()->camera().distance(), 0.8F * distance);
  click("view_top");
  settle();
  EXPECT_NEAR(view()->camera().up().z(), 0, 0.01);
  EXPECT_GT(count(picture(), red), 200);
}

TEST_F(Gl, MouseAndKeysDriveTheInstrumentWhileItRuns) {
  script.end_s = 0;
  script.rate = 0;  // only the camera moves
  open_ready();
  if (IsSkipped()) return;
  click("start");
  ASSERT_TRUE(view()->instrument());
  settle();
  const QPoint middle = view()->rect().center();
  const float yaw = view()->camera().eye().x();
  log->pointer.clear();
  QTest::mousePress(view(), Qt::LeftButton, {}, middle);
  QTest::mouseMove(view(), middle + QPoint(view()->height() / 4, 0));
  QTest::mouseRelease(view(), Qt::LeftButton, {}, middle + QPoint(view()->height() / 4, 0));
  ASSERT_EQ(log->pointer.size(), 3U);
  EXPECT_EQ(log->pointer[1].buttons, 1U);
  // expected motion of the tips, which follow the pointer slightly behind or before the focus
  const double quarter = 0.25 * static_cast<double>(console::middle_eye(view()->camera(), 1).span) / 10;
  EXPECT_NEAR(log->pointer[1].dx, quarter, 0.15 * quarter);
  EXPECT_EQ(log->pointer[2].buttons, 0U);
  EXPECT_NEAR(std::hypot(log->pointer[1].camera.w, log->pointer[1].camera.x,
                         std::hypot(log->pointer[1].camera.y, log->pointer[1].camera.z)),
              1, 1e-5);
  EXPECT_EQ(view()->camera().eye().x(), yaw);
  // the last motion before a release is not lost on a busy machine
  log->pointer.clear();
  QTest::mousePress(view(), Qt::LeftButton, {}, middle);
  QTest::mouseRelease(view(), Qt::LeftButton, {}, middle + QPoint(0, -view()->height() / 4));
  ASSERT_EQ(log->pointer.size(), 3U);
  EXPECT_EQ(log->pointer[1].buttons, 1U);
  EXPECT_NEAR(log->pointer[1].dy, quarter, 0.15 * quarter);
  // keys: press, release, and release of all when the view loses the focus
  log->pointer.clear();
  QTest::keyPress(view(), Qt::Key_Space);
  ASSERT_EQ(log->pointer.size(), 1U);
  EXPECT_EQ(log->pointer[0].keys, uint64_t{1} << 40);
  QTest::keyRelease(view(), Qt::Key_Space);
  EXPECT_EQ(log->pointer[1].keys, 0U);
  QTest::keyPress(view(), Qt::Key_W);
  QFocusEvent out(QEvent::FocusOut);
  QApplication::sendEvent(view(), &out);
  EXPECT_EQ(log->pointer.back().keys, 0U);
  // Ctrl+drag still turns the camera
  log->pointer.clear();
  QTest::mousePress(view(), Qt::LeftButton, Qt::ControlModifier, middle);
  QMouseEvent move(QEvent::MouseMove, middle + QPoint(80, 0), view()->mapToGlobal(middle + QPoint(80, 0)),
                   Qt::NoButton, Qt::LeftButton, Qt::ControlModifier);
  QApplication::sendEvent(view(), &move);
  const size_t to_instrument = log->pointer.size();
  QTest::keyClick(window.get(), Qt::Key_F6);
  settle();
  EXPECT_EQ(to_instrument, 0U);
  EXPECT_NE(view()->camera().eye().x(), yaw);
}

TEST_F(Gl, TheSecondViewTurnsADragIntoDepth) {
  script.end_s = 0;
  script.rate = 0;
  open_ready();
  if (IsSkipped()) return;
  click("view_side");
  click("start");
  settle();
  const QImage with = picture();
  const auto drag = [&](const QPoint& from) {
    log->pointer.clear();
    QTest::mousePress(view(), Qt::LeftButton, {}, from);
    QTest::mouseMove(view(), from + QPoint(0, -40));
    QTest::mouseRelease(view(), Qt::LeftButton, {}, from + QPoint(0, -40));
    const swage_pointer& p = log->pointer.at(1);
    const QQuaternion q(static_cast<float>(p.camera.w), static_cast<float>(p.camera.x),
                        static_cast<float>(p.camera.y), static_cast<float>(p.camera.z));
    return q.rotatedVector({static_cast<float>(p.dx), static_cast<float>(p.dy), 0});
  };
  const QVector3D up = drag(view()->rect().center());
  EXPECT_GT(up.z(), 0.9F * up.length()) << "in the picture from the side up is up";
  // the second view is in the corner where it covers least
  const QRect all = view()->rect();
  const QPoint corners[] = {all.bottomLeft() + QPoint(60, -60), all.bottomRight() + QPoint(-60, -60), all.topLeft() + QPoint(60, 100),
                            all.topRight() + QPoint(-60, 100)};
  const auto turned = std::find_if(std::begin(corners), std::end(corners), [&](const QPoint& corner) {
    const QVector3D away = drag(corner);
    return away.y() > 0.9F * away.length();
  });
  ASSERT_NE(turned, std::end(corners)) << "in the second view, from above, up is away";
  // without the second view that corner is an ordinary part of the picture
  click("second");
  settle();
  const QVector3D again = drag(*turned);
  EXPECT_GT(again.z(), 0.9F * again.length());
  EXPECT_GT(changed(with, picture()), 0.01);
}

TEST_F(Gl, TheTraineeSeesWithTwoEyes) {
  script.end_s = 0;
  script.rate = 0;
  open_ready();
  if (IsSkipped()) return;
  QTest::keyClick(window.get(), Qt::Key_F9);
  ASSERT_NE(window->trainee(), nullptr);
  SceneView* trainee = window->trainee()->view();
  ASSERT_TRUE(eventually([&] { return trainee->ready() && trainee->resting(); }));
  const QImage two = trainee->grab().toImage();
  const QImage left = two.copy(0, 0, two.width() / 2, two.height()),
               right = two.copy(two.width() / 2, 0, two.width() / 2, two.height());
  EXPECT_GT(count(left, red), 30);
  EXPECT_GT(count(right, red), 30);
  const double apart = changed(left, right);
  EXPECT_GT(apart, 0.001) << "each eye has a picture of its own";
  EXPECT_LT(apart, 0.5);
  // in a test the trainee gets no help either
  child<QAbstractButton>("test")->click();
  EXPECT_FALSE(trainee->cues_shown());
  QTest::keyClick(window->trainee(), Qt::Key_Escape);
  EXPECT_EQ(window->trainee(), nullptr);
  EXPECT_TRUE(window->isVisible());
}

TEST_F(Gl, OpensAndClosesTenTimesAlsoDuringARun) {
  script.end_s = 0;
  for (int i = 0; i < 10; ++i) {
    open();
    if (!page()->view()->gl().ok) GTEST_SKIP() << "no OpenGL";
    if (i % 2 == 0) click("start");
    // closed before, while and after its first pictures come
    if (i % 3 == 1) QCoreApplication::processEvents();
    if (i % 3 == 2) {
      ASSERT_TRUE(eventually([&] { return page()->view()->ready(); }));
    }
    if (i % 3 == 0) window->resize(1200 + 20 * i, 800);
    window->close();
    window.reset();
  }
  EXPECT_EQ(log->started, 5);
  EXPECT_EQ(log->stopped, 5);
}

TEST_F(Gl, ResizingKeepsThePictureSharp) {
  open_ready();
  if (IsSkipped()) return;
  for (int i = 0; i < 12; ++i) {
    window->resize(1180 + 30 * i, 760 + 10 * i);
    QCoreApplication::processEvents();
  }
  settle();
  EXPECT_TRUE(eventually([&] { return view()->image().size() == view()->size(); }));
  settle();
  EXPECT_GT(count(picture(), red), 200);
}

// The line of F12: picture rate, number of pictures, and latency from a movement to its picture.
TEST_F(Gl, TheStripTellsPicturesAndTheLatencyOfTheHand) {
  script.end_s = 0;
  script.rate = 10;
  open_ready();
  if (IsSkipped()) return;
  auto* line = child<QLabel>("frames");
  EXPECT_FALSE(line->isVisible());
  QTest::keyClick(window.get(), Qt::Key_F12);
  click("start");
  ASSERT_TRUE(eventually([&] { return view()->frames().count() > 3; }));
  EXPECT_EQ(view()->latency().count(), 0U) << "nobody has moved anything";
  const QPoint middle = view()->rect().center();
  QTest::mousePress(view(), Qt::LeftButton, {}, middle);
  for (int i = 1; i < 200 && view()->latency().count() == 0; ++i) {
    QTest::mouseMove(view(), middle + QPoint(i % 40, 0));
    QTest::qWait(20);
  }
  QTest::mouseRelease(view(), Qt::LeftButton, {}, middle);
  ASSERT_GT(view()->latency().count(), 0U);
  EXPECT_GT(view()->latency().share(0.5), 0);
  EXPECT_TRUE(eventually([&] { return line->text().contains(QStringLiteral("hand to picture p50")); })) << line->text().toStdString();
  EXPECT_TRUE(line->text().contains(QStringLiteral(" fps"))) << line->text().toStdString();
  EXPECT_TRUE(line->text().contains(QStringLiteral("picture "))) << line->text().toStdString();
}

TEST_F(Gl, RealKeysFromTheDesktopArrive) {
  const QString xdotool = QStandardPaths::findExecutable("xdotool");
  if (xdotool.isEmpty() || QGuiApplication::platformName() != "xcb") GTEST_SKIP() << "needs X11 and xdotool";
  script.end_s = 0;
  open_ready();
  if (IsSkipped()) return;
  const auto tool = [&](const QStringList& arguments) {
    QProcess process;
    process.start(xdotool, arguments);
    ASSERT_TRUE(process.waitForFinished(kPatience_ms));
    EXPECT_EQ(process.exitCode(), 0) << process.readAllStandardError().toStdString();
  };
  tool({"windowfocus", "--sync", QString::number(window->winId())});
  tool({"key", "F5"});
  EXPECT_TRUE(eventually([&] { return log->started == 1; }));
  // a drag over the picture moves the instrument
  const auto moved = [&] {
    double dx = 0, dy = 0;
    for (const swage_pointer& p : log->pointer) dx += p.dx, dy += p.dy;
    return QPointF(dx, dy) * 10 * view()->height() /
           static_cast<double>(console::middle_eye(view()->camera(), 1).span);
  };
  const auto buttons = [&] { return log->pointer.empty() ? 0 : log->pointer.back().buttons; };
  const auto keys = [&] { return log->pointer.empty() ? 0 : log->pointer.back().keys; };
  const QPoint middle = view()->mapToGlobal(view()->rect().center());
  tool({"mousemove", QString::number(middle.x()), QString::number(middle.y()), "mousedown", "1"});
  EXPECT_TRUE(eventually([&] { return buttons() == 1; }));
  tool({"mousemove", QString::number(middle.x() + 60), QString::number(middle.y() - 30)});
  EXPECT_TRUE(eventually([&] {
    return QLineF(moved(), {60, 30}).length() < 12;
  })) << moved().x()
      << " " << moved().y();
  tool({"mouseup", "1"});
  EXPECT_TRUE(eventually([&] { return buttons() == 0; }));
  tool({"keydown", "space"});
  EXPECT_TRUE(eventually([&] { return keys() == uint64_t{1} << 40; }));
  tool({"keyup", "space"});
  EXPECT_TRUE(eventually([&] { return keys() == 0; }));
  tool({"key", "F6"});
  EXPECT_TRUE(eventually([&] { return log->paused == 1; }));
  tool({"key", "shift+F5"});
  EXPECT_TRUE(eventually([&] { return log->stopped == 1; }));
}

}  // namespace
}  // namespace swage::test
