// SPDX-License-Identifier: Apache-2.0
//
// A trainee's screen, checked by its pixels: every stereo layout, true size, the microscope view.
#include <cmath>

#include "console/view3d/quad_window.hpp"
#include "gl_fixture.hpp"

namespace swage::test {
namespace {

/// Mean difference of lightness over the pixels for which `counts` is true.
double apart(const QImage& a, const QImage& b, const std::function<bool(int, int)>& counts = [](int, int) { return true; }) {
  double sum = 0;
  int n = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      if (counts(x, y)) sum += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y))), ++n;
  return sum / n;
}

// Each stereo layout, decoded, gives the pictures that each eye has alone.
TEST_F(Gl, EveryDisplayShowsEachEyeItsOwnPicture) {
  open_ready();
  if (IsSkipped()) return;
  using Layout = console::StereoLayout;
  const auto shot = [&](Layout layout, console::Mirror mirror = console::Mirror::kNone, bool swapped = false, bool squeezed = false) {
    console::StereoLook look;
    look.layout = layout;
    look.mirror = mirror;
    look.squeezed = squeezed;
    look.rig.swapped = swapped;
    look.rig.eye_distance_mm = 40;
    view()->set_stereo(look);
    settle();
    return picture();
  };
  const QImage left = shot(Layout::kLeftEye), right = shot(Layout::kRightEye);
  const double both = apart(left, right);  // lightness, 0 to 255
  ASSERT_GT(both, 0.5) << "two eyes see two pictures";
  const double same = 0.1 * both;
  const QPoint origin = view()->mapToGlobal(QPoint());
  const auto even = [&](int, int y) { return (y + origin.y()) % 2 == 0; };
  const auto white = [&](int x, int y) { return (x + y + origin.x() + origin.y()) % 2 == 0; };
  for (const auto& [layout, is_left] : {std::pair<Layout, std::function<bool(int, int)>>{Layout::kLines, even}, {Layout::kChecker, white}}) {
    const QImage image = shot(layout);
    EXPECT_LT(apart(image, left, is_left), same);
    EXPECT_LT(apart(image, right, std::not_fn(is_left)), same);
    EXPECT_GT(apart(image, right, is_left), 0.5 * both) << "and not the other's";
  }
  for (const Layout layout : {Layout::kAnaglyph, Layout::kAnaglyphGrey, Layout::kAnaglyphLeast})
    EXPECT_LT(apart(shot(layout), console::overlay_eyes(layout, left, right)), same);
  EXPECT_LT(apart(shot(Layout::kLeftEye, console::Mirror::kNone, true), right), same);
  EXPECT_LT(apart(shot(Layout::kLeftEye, console::Mirror::kLeftRight), left.mirrored(true, false)), same);
  EXPECT_LT(apart(shot(Layout::kRightEye, console::Mirror::kUpDown), right.mirrored(false, true)), same);
  // side by side: the middle of each eye's picture, or all of it at half the width
  const int w = left.width() / 2, h = left.height();
  const QRect middle(w / 2, 0, w, h);
  // texts at the lower edge and in the corners are placed differently in a narrower picture
  const auto scene = [&](int x, int y) { return y > h / 8 && y < 3 * h / 4 && x > 4 && x < w - 4; };
  const QImage side = shot(Layout::kSideBySide);
  EXPECT_LT(apart(side.copy(0, 0, w, h), left.copy(middle), scene), 0.4 * both);
  EXPECT_LT(apart(side.copy(w, 0, w, h), right.copy(middle), scene), 0.4 * both);
  const QImage mirrored = shot(Layout::kSideBySide, console::Mirror::kLeftRight);
  EXPECT_LT(apart(mirrored.copy(0, 0, w, h), side.copy(0, 0, w, h).mirrored(true, false), scene), same) << "each in its own half";
  const QImage pressed = shot(Layout::kSideBySide, console::Mirror::kNone, false, true);
  const QImage whole = left.scaled(w, h, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  const QImage other = right.scaled(w, h, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  EXPECT_LT(apart(pressed.copy(0, 0, w, h), whole, scene), 0.7 * apart(pressed.copy(0, 0, w, h), other, scene));
  EXPECT_LT(apart(pressed.copy(w, 0, w, h), other, scene), 0.7 * apart(pressed.copy(w, 0, w, h), whole, scene));
}

// Over and under: each eye's picture at half the size in the middle of its half, or all of it at half the height.
TEST_F(Gl, OverAndUnderShowsEachEyeItsOwnPicture) {
  open_ready();
  if (IsSkipped()) return;
  using Layout = console::StereoLayout;
  const auto shot = [&](Layout layout, bool squeezed, bool swapped = false) {
    console::StereoLook look;
    look.layout = layout;
    look.squeezed = squeezed;
    look.rig.swapped = swapped;
    look.rig.eye_distance_mm = 40;
    view()->set_stereo(look);
    settle();
    return picture();
  };
  const QImage left = shot(Layout::kLeftEye, false), right = shot(Layout::kRightEye, false);
  const int w = left.width(), h = left.height() / 2;
  const auto small = [&](const QImage& eye, int width) { return eye.scaled(width, h, Qt::IgnoreAspectRatio, Qt::SmoothTransformation); };
  // texts at the lower edge are placed differently in a lower picture
  const auto scene = [&](int x, int y) { return y > h / 8 && y < 3 * h / 4 && x > 4 && x < w / 2 - 4; };
  const auto is_of = [&](const QImage& half, const QImage& own, const QImage& other) {
    EXPECT_LT(apart(half, own, scene), 0.7 * apart(half, other, scene));
  };
  const QImage whole = shot(Layout::kOverUnder, false);
  is_of(whole.copy(w / 4, 0, w / 2, h), small(left, w / 2), small(right, w / 2));
  is_of(whole.copy(w / 4, h, w / 2, h), small(right, w / 2), small(left, w / 2));
  const QImage swapped = shot(Layout::kOverUnder, false, true);
  is_of(swapped.copy(w / 4, 0, w / 2, h), small(right, w / 2), small(left, w / 2));
  const QImage pressed = shot(Layout::kOverUnder, true);
  is_of(pressed.copy(0, 0, w, h), small(left, w), small(right, w));
  is_of(pressed.copy(0, h, w, h), small(right, w), small(left, w));
}

/// A plate of 10 mm by 10 mm in the middle.
snapshot::SceneCard plate() {
  snapshot::SceneCard card;
  card.length = 1e-3, card.dt = 1e-3;
  card.objects = {{"plate", "test.plate", "1.0.0", {}, 0, 1, 0, 0}};
  card.start = {{{0, 0, 0}, {1, 0, 0, 0}}};
  card.motion = {SWAGE_MOTION_FIXED};
  snapshot::CardShape s;
  s.kind = SWAGE_SHAPE_CONVEX;
  s.flags = SWAGE_SHAPE_USUAL;
  s.X_BS.q = {1, 0, 0, 0};
  for (const double z : {-0.1e-3, 0.1e-3})
    for (const auto& [x, y] : {std::pair{-5e-3, -5e-3}, {5e-3, -5e-3}, {5e-3, 5e-3}, {-5e-3, 5e-3}}) s.vertex.push_back({x, y, z});
  s.face = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  card.shapes = {s};
  return card;
}

/// Number of fully covered pixels of a line: the floor beside the plate is partly transparent.
int covered(const QImage& image, bool across) {
  int n = 0;
  for (int i = 0; i < (across ? image.width() : image.height()); ++i)
    n += qAlpha(across ? image.pixel(i, image.height() / 2 + 3) : image.pixel(image.width() / 2 + 3, i)) > 250;
  return n;
}

// By ruler measurements: 10 mm of the scene are 10 mm on the screen, times the scale.
TEST_F(Gl, TenMillimetresAreTenMillimetresOnTheScreen) {
  open_ready();
  if (IsSkipped()) return;
  console::StereoLook look;
  look.layout = console::StereoLayout::kOneEye;
  look.true_size.on = true;
  const QSize screen = view()->screen()->size();
  look.true_size.screen_mm = {0.25 * screen.width(), 0.27 * screen.height()};  // pixels that are not quite square
  look.true_size.distance_mm = 480;
  view()->set_stereo(look);
  view()->set_card(plate(), console::CameraPreset::kTop);
  for (const float scale : {1.F, 4.F}) {
    look.true_size.scale = scale;
    for (const auto layout : {console::StereoLayout::kOneEye, console::StereoLayout::kLeftEye}) {
      look.layout = layout;
      view()->set_stereo(look);
      settle();
      EXPECT_NEAR(covered(view()->image(), true), 10 * static_cast<double>(scale) / 0.25, 2) << "px";
      EXPECT_NEAR(covered(view()->image(), false), 10 * static_cast<double>(scale) / 0.27, 2);
    }
  }
  EXPECT_EQ(view()->display().scale, 4);
}

TEST_F(Gl, AMicroscopeHasARoundFieldAndMagnifiesAsItsMakerSays) {
  open_ready();
  if (IsSkipped()) return;
  console::StereoLook look;
  look.layout = console::StereoLayout::kOneEye;
  look.microscope.on = true;
  look.microscope.zoom = 4;
  const QSize screen = view()->screen()->size();
  look.true_size.screen_mm = {0.25 * screen.width(), 0.25 * screen.height()};
  look.true_size.distance_mm = 250;
  view()->set_stereo(look);
  view()->set_card(plate(), console::CameraPreset::kTop);
  settle();
  EXPECT_NEAR(covered(view()->image(), true), 4 * 10 / 0.25, 2) << "four times as large as with the bare eye at 250 mm";
  EXPECT_EQ(view()->display().scale, 4);
  const QImage seen = picture();
  const auto light = [&](double x, double y) { return seen.pixelColor(static_cast<int>(x), static_cast<int>(y)).lightness(); };
  const double w = seen.width(), h = seen.height(), r = 0.49 * std::min(w, h);
  EXPECT_LT(light(3, 3), 12) << "nothing is seen outside of the field";
  EXPECT_LT(light(w / 2, h / 2 - 1.02 * r), 12);
  EXPECT_GT(light(w / 2, h / 2), 60);
  float zoom = 0;
  QObject::connect(view(), &SceneView::microscope_zoomed, view(), [&](float z) { zoom = z; });
  view()->setFocus();
  QTest::keyClick(view(), Qt::Key_PageUp, Qt::ControlModifier);
  settle();
  EXPECT_NEAR(covered(view()->image(), true), static_cast<double>(zoom) * 10 / 0.25, 2);
  EXPECT_NEAR(zoom, 4 * std::pow(25.0 / 4, 0.1), 1e-4);
  for (int i = 0; i < 20; ++i) QTest::keyClick(view(), Qt::Key_PageUp, Qt::ControlModifier);
  EXPECT_FLOAT_EQ(zoom, 25);
  for (int i = 0; i < 20; ++i) QTest::keyClick(view(), Qt::Key_PageDown, Qt::ControlModifier);
  EXPECT_FLOAT_EQ(zoom, 4);
}

/// Lightness between neighbours, summed over the edges of a picture where it differs by more than 30 of 255: those of needle and jaws.
/// The floor's lines are weaker and do not count, as the floor has no depth and is blurred as if it were far away.
double sharpness(const QImage& image) {
  double sum = 0;
  for (int y = image.height() / 4; y < image.height(); ++y)
    for (int x = 0; x + 1 < image.width(); ++x) {
      const int step = std::abs(qGray(image.pixel(x + 1, y)) - qGray(image.pixel(x, y)));
      if (step > 30) sum += step;
    }
  return sum;
}

// The same picture with and without blur: off focus, on either side, the summed edges are less than half of those in focus, and they
// return fully with the focus. In focus, too, only the part of the needle at the focal distance is sharp.
TEST_F(Gl, AMicroscopeIsSharpInItsFocusAndBlursAwayFromIt) {
  open_ready();
  if (IsSkipped()) return;
  console::StereoLook look;
  look.layout = console::StereoLayout::kOneEye;
  look.microscope = {true, 10, false};
  const auto left = [&] {
    double seen[2];
    for (const bool blur : {false, true}) {
      look.microscope.blur = blur;
      view()->set_stereo(look);
      settle();
      seen[blur] = sharpness(view()->image());
    }
    EXPECT_GT(seen[0], 1000) << "there are edges";
    return seen[1] / seen[0];
  };
  const auto turn = [&](Qt::Key key, int steps) {
    for (int i = 0; i < steps; ++i) QTest::keyClick(view(), key, Qt::ControlModifier | Qt::ShiftModifier);
  };
  const double in_focus = left();
  turn(Qt::Key_PageUp, 40);
  const double before = left();
  turn(Qt::Key_PageDown, 80);
  const double behind = left();
  turn(Qt::Key_PageUp, 40);
  EXPECT_LT(before, 0.5 * in_focus);
  EXPECT_LT(behind, 0.5 * in_focus);
  EXPECT_NEAR(left(), in_focus, 0.02) << before << ' ' << behind;
}

// A driver without two buffers shows the left eye, upright and unchanged. The right eye's picture can be tested only with two buffers.
TEST_F(Gl, OneAfterTheOtherCopiesAnEyeToTheScreen) {
  open_ready();
  if (IsSkipped()) return;
  QWidget under;
  console::QuadWindow shutter(&under);
  shutter.resize(64, 48);
  shutter.show();
  ASSERT_TRUE(eventually([&] { return shutter.isExposed(); }));
  QImage left(shutter.size() * shutter.devicePixelRatio(), QImage::Format_RGB32), right = left;
  for (int y = 0; y < left.height(); ++y)
    for (int x = 0; x < left.width(); ++x) left.setPixel(x, y, qRgb(3 * x, 5 * y, 77)), right.setPixel(x, y, qRgb(77, 3 * x, 5 * y));
  EXPECT_EQ(shutter.show_eyes(left, right), console::has_quad_buffers());
  // with double buffering the drawn picture is readable after the second swap
  shutter.show_eyes(left, right);
  EXPECT_EQ(shutter.read_back(), left);
  shutter.resize(80, 40);
  QImage other(shutter.size() * shutter.devicePixelRatio(), QImage::Format_RGB32);
  other.fill(QColor(9, 200, 30));
  ASSERT_TRUE(eventually([&] { return shutter.show_eyes(other, other), shutter.read_back() == other; }));
}

// The two pictures for a quad-buffered driver are those of each eye alone.
TEST_F(Gl, OneAfterTheOtherIsGivenBothEyes) {
  open_ready();
  if (IsSkipped()) return;
  using Layout = console::StereoLayout;
  console::StereoLook look;
  look.rig.eye_distance_mm = 40;
  const auto shot = [&](Layout layout) {
    look.layout = layout;
    view()->set_stereo(look);
    settle();
    return picture();
  };
  const QImage left = shot(Layout::kLeftEye), right = shot(Layout::kRightEye);
  QImage eye[2];
  view()->set_eyes_sink([&](const QImage& l, const QImage& r) { eye[0] = l, eye[1] = r; });
  EXPECT_LT(apart(shot(Layout::kShutter), left), 0.1 * apart(left, right)) << "the view itself shows the left one";
  ASSERT_TRUE(eventually([&] { return !eye[1].isNull(); }));
  EXPECT_LT(apart(eye[0], left), 0.1 * apart(left, right));
  EXPECT_LT(apart(eye[1], right), 0.1 * apart(left, right));
  view()->set_eyes_sink({});
}

}  // namespace
}  // namespace swage::test
