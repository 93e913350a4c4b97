// SPDX-License-Identifier: Apache-2.0
//
// Every lesson of the series in pictures for one eye and for two, two seconds into the expert's attempt.
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
constexpr int kSteps = 2000;        // 2 s: most instruments have reached their needle
constexpr int kSearch_px = 80;      // range of the tried shifts, in both directions
constexpr double kDepth = 0.04, kSame = 0.02;  // shares of the middle: smallest difference between two eyes, largest for one eye
constexpr float kNearer_mm = 200;   // convergence: the scene, framed at 250 mm, lies behind the screen
constexpr float kFurther_mm = 320;  // and before it

std::vector<std::string> series() {
  std::vector<std::string> out;
  for (const auto& file : fs::directory_iterator(SWAGE_SOURCE_DIR "/lessons/series"))
    if (file.path().extension() == ".json") out.push_back(file.path().string());
  std::sort(out.begin(), out.end());
  return out;
}

/// Two pictures, overlaid at the shift where their middles are most alike.
struct Match {
  int shift = 0;        // px, of the second picture to the right
  double differs = 0;   // share of the middle that differs at this shift
};

Match match(const QImage& from, const QImage& to) {
  constexpr int kOtherwise = 12;  // of 255
  const int w = from.width(), h = from.height();
  std::vector<int> a, b;
  for (const auto& [image, grey] : {std::pair{&from, &a}, {&to, &b}})
    for (int y = 0; y < h; ++y)
      for (int x = 0; x < w; ++x) grey->push_back(qGray(image->pixel(x, y)));
  Match best;
  long least = -1;
  for (int s = -kSearch_px; s <= kSearch_px; ++s) {
    long sum = 0, other = 0;
    for (int y = h / 4; y < 3 * h / 4; ++y)
      for (int x = w / 4; x < 3 * w / 4; ++x) {
        const int d = std::abs(a[static_cast<size_t>(y * w + x)] - b[static_cast<size_t>(y * w + x + s)]);
        sum += d, other += d > kOtherwise;
      }
    if (least >= 0 && sum >= least) continue;
    least = sum;
    best = {s, static_cast<double>(other) / (0.25 * w * h)};
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
  /// Shift of an eye's picture to the right when its convergence goes from near to far, px.
  double moves(std::size_t eye) {
    double x[2];
    for (const bool far : {false, true}) {
      console::StereoRig rig;
      rig.convergence_mm = far ? kFurther_mm : kNearer_mm;
      x[far] = static_cast<double>(console::two_eyes(view.camera(), rig, console::shape_of(kView_px))[eye].project(view.camera().focus(), kView_px).x());
    }
    return x[1] - x[0];
  }
  console::SceneView view;
};

// A stereo pair is correct if each eye sees the scene; if each picture shifts as a whole with the convergence, in the direction of its eye
// (off-axis frusta, eye.hpp); if things at other depths differ at any shift; and if swapping the eyes swaps
// the pictures.
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
  const StereoLayout eyes[] = {StereoLayout::kLeftEye, StereoLayout::kRightEye};
  QImage near[2];
  for (const std::size_t i : {0U, 1U}) {
    near[i] = seen(eyes[i], kNearer_mm);
    const QImage far = seen(eyes[i], kFurther_mm);
    EXPECT_GT(filled(near[i]), enough);
    EXPECT_GT(filled(far), enough);
    const Match moved = match(near[i], far);
    ASSERT_GT(std::abs(moves(i)), 10);
    EXPECT_NEAR(moved.shift, moves(i), 1) << "eye " << i;
    EXPECT_LT(moved.differs, kSame) << "eye " << i;
  }
  EXPECT_LT(moves(0) * moves(1), 0);
  const Match depth = match(near[0], near[1]);
  std::printf("eyes move by %.1f and %.1f px; %.1f %% of the middle differ by depth\n", moves(0), moves(1), 100 * depth.differs);
  EXPECT_GT(depth.differs, kDepth);
  for (const std::size_t i : {0U, 1U}) {
    const Match exchanged = match(near[1 - i], seen(eyes[i], kNearer_mm, true));
    EXPECT_EQ(exchanged.shift, 0);
    EXPECT_LT(exchanged.differs, kSame);
  }
}

INSTANTIATE_TEST_SUITE_P(Lessons, Series, testing::ValuesIn(series()),
                         [](const auto& lesson) { return fs::path(lesson.param).stem().string(); });

}  // namespace
}  // namespace swage::test
