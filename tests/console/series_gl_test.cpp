// SPDX-License-Identifier: Apache-2.0
//
// Every lesson of the series as one eye and as two see it, two seconds into the expert's attempt.
#include <QPainter>
#include <cmath>
#include <filesystem>
#include <memory>

#include "gl_fixture.hpp"
#include "session/rehearsal.hpp"

namespace swage::test {
namespace {

namespace fs = std::filesystem;
using console::StereoLayout;

constexpr QSize kView_px(480, 400);
constexpr int kSteps = 2000;        // 2 s: most hands are at their needle
constexpr int kSearch_px = 45;      // shifts that are tried, either way
constexpr float kNearer_mm = 200;   // convergence: the scene, framed at 250 mm, lies behind the screen
constexpr float kFurther_mm = 320;  // and before it

std::vector<std::string> series() {
  std::vector<std::string> out;
  for (const auto& file : fs::directory_iterator(SWAGE_SOURCE_DIR "/lessons/series"))
    if (file.path().extension() == ".json") out.push_back(file.path().string());
  std::sort(out.begin(), out.end());
  return out;
}

/// The shift to the right by which the middle of `to` is most like that of `from`, px.
int shift(const QImage& from, const QImage& to) {
  const int w = from.width(), h = from.height();
  std::vector<int> a, b;
  for (const auto& [image, grey] : {std::pair{&from, &a}, {&to, &b}})
    for (int y = 0; y < h; ++y)
      for (int x = 0; x < w; ++x) grey->push_back(qGray(image->pixel(x, y)));
  int best = 0;
  long least = -1;
  for (int s = -kSearch_px; s <= kSearch_px; ++s) {
    long sum = 0;
    for (int y = h / 4; y < 3 * h / 4; ++y)
      for (int x = w / 4; x < 3 * w / 4; ++x) sum += std::abs(a[static_cast<size_t>(y * w + x)] - b[static_cast<size_t>(y * w + x + s)]);
    if (least >= 0 && sum >= least) continue;
    least = sum;
    best = s;
  }
  return best;
}

class Series : public testing::TestWithParam<std::string> {
 protected:
  /// The scene alone, on black.
  QImage seen(StereoLayout layout, float convergence_mm, bool swapped = false) {
    console::StereoLook look;
    look.layout = layout;
    look.rig.convergence_mm = convergence_mm;
    look.rig.swapped = swapped;
    view.set_stereo(look);
    view.redraw();
    EXPECT_TRUE(QTest::qWaitFor([&] { return view.ready() && view.resting(); }, 60000));
    QImage out(view.image().size(), QImage::Format_RGB32);
    out.fill(Qt::black);
    QPainter(&out).drawImage(0, 0, view.image());
    return out;
  }
  /// By how much a point in the middle lies further right for the right eye than for the left, px.
  double parallax(float convergence_mm) {
    console::StereoRig rig;
    rig.convergence_mm = convergence_mm;
    const auto eye = console::two_eyes(view.camera(), rig, console::shape_of(kView_px));
    const QVector3D middle = view.camera().focus();
    return eye[1].project(middle, kView_px).x() - eye[0].project(middle, kView_px).x();
  }
  console::SceneView view;
};

// A pair of pictures is right where each eye sees the scene, where they differ by as much as the eyes are apart, and to the right side:
// what lies behind the screen is further right for the right eye, what lies before it further left (off-axis frusta, eye.hpp).
TEST_P(Series, IsSeenByOneEyeAndByTwo) {
  if (!view.gl().ok) GTEST_SKIP() << "no OpenGL: " << view.gl().why.toStdString();
  session::Options options;
  options.lesson_path = GetParam();
  options.plugin_dirs = {SWAGE_BINARY_DIR "/plugins"};
  options.store_path = ":none:";
  base::Problems problems;
  const auto expert = session::Rehearsal::open(options, "expert", problems);
  ASSERT_NE(expert, nullptr) << (problems.empty() ? "" : problems.front().message);
  for (int i = 0; i < kSteps && expert->step(); ++i) {
  }
  const auto snapshot = std::make_unique<snapshot::Snapshot>();
  expert->fill(*snapshot);
  view.set_themes(console::UiTheme::stock(QStringLiteral("light")), console::CueTheme::stock(QStringLiteral("thesis")));
  view.resize(kView_px);
  view.show();
  view.set_card(expert->card());
  view.show_snapshot(*snapshot);
  const auto filled = [](const QImage& image) { return count(image, [](const QColor& c) { return c.lightness() > 20; }); };
  const int enough = kView_px.width() * kView_px.height() / 20;
  EXPECT_GT(filled(seen(StereoLayout::kOneEye, 250)), enough);
  for (const float convergence : {kNearer_mm, kFurther_mm}) {
    const QImage left = seen(StereoLayout::kLeftEye, convergence), right = seen(StereoLayout::kRightEye, convergence);
    EXPECT_GT(filled(left), enough);
    EXPECT_GT(filled(right), enough);
    const double wanted = parallax(convergence);
    ASSERT_GT(std::abs(wanted), 10) << "px: more than what is nearer or further can undo";
    ASSERT_EQ(wanted > 0, convergence < 250);
    EXPECT_NEAR(shift(left, right) / wanted, 1, 0.5) << shift(left, right) << " px of " << wanted;
  }
  // eyes that are exchanged are found out
  const QImage left = seen(StereoLayout::kLeftEye, kNearer_mm, true), right = seen(StereoLayout::kRightEye, kNearer_mm, true);
  EXPECT_LT(shift(left, right), -5);
}

INSTANTIATE_TEST_SUITE_P(Lessons, Series, testing::ValuesIn(series()),
                         [](const auto& lesson) { return fs::path(lesson.param).stem().string(); });

}  // namespace
}  // namespace swage::test
