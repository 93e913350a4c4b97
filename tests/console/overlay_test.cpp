// SPDX-License-Identifier: Apache-2.0
//
// Texts over the picture: their places and lines; how a medium looks; lines of the plots beside it.
#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>

#include <swage/abi/environment.h>

#include <cmath>
#include <memory>

#include "console/view3d/medium_look.hpp"
#include "console/view3d/overlay.hpp"
#include "console/view3d/scene_marks.hpp"
#include "console/widgets/trace_plot.hpp"

namespace swage::console {
namespace {

/// Height of what is drawn for a clock in a picture of this width, px; nothing is drawn beside the picture.
int clock_height(int width_px, const QString& text) {
  QImage picture(width_px, 240, QImage::Format_RGB32);
  picture.fill(Qt::black);
  QPainter painter(&picture);
  const UiTheme ui = UiTheme::stock(QStringLiteral("light"));
  Overlay(painter, picture.rect(), ui).clock(text);
  painter.end();
  int rows = 0;
  for (int y = 0; y < picture.height(); ++y) {
    bool drawn = false;
    for (int x = 0; x < width_px; ++x) drawn |= qGray(picture.pixel(x, y)) > 40;
    rows += drawn;
  }
  return rows;
}

TEST(Clock, TakesAsManyLinesAsTheStepInFrontOfItNeeds) {
  const QString text = QStringLiteral("Bring its point to the mark, perpendicular to the tissue.  00:08");
  const int one = clock_height(1200, text), several = clock_height(300, text);
  EXPECT_GT(one, 10);
  EXPECT_GT(several, one + 4) << "two lines of smaller letters";
  EXPECT_LT(several, 120) << "the picture is still seen";
  EXPECT_EQ(clock_height(300, QStringLiteral("00:08")), clock_height(1200, QStringLiteral("00:08")));
}

/// Where the label of a cue is drawn: the box of what is not black, without the dot at its grasp and the line to it.
QRect label_of_cue(const QRectF& kept_clear, bool two_eyes = false) {
  QImage picture(800, 600, QImage::Format_RGB32);
  picture.fill(Qt::black);
  QPainter painter(&picture);
  const UiTheme ui = UiTheme::stock(QStringLiteral("light"));
  Overlay overlay(painter, picture.rect(), ui);
  overlay.keep_clear(kept_clear);
  overlay.set_two_eyes(two_eyes);
  CueStyle style;
  style.text = QStringLiteral("Position right, with tips");
  overlay.cue({400, 300}, style, 0);
  painter.end();
  QRect box;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x + 12 < picture.width(); ++x) {
      bool wide = true;  // a label is white over more than the width of a line
      for (int k = 0; k < 12; ++k) wide &= qGray(picture.pixel(x + k, y)) > 200;
      if (wide) box |= QRect(x, y, 12, 1);
    }
  return box;
}

TEST(CueLabel, StandsInAnotherCornerWhereItsOwnIsKeptClear) {
  const QRect usual = label_of_cue({});
  ASSERT_FALSE(usual.isEmpty());
  EXPECT_GT(usual.left(), 400);
  EXPECT_LT(usual.bottom(), 300);
  const QRect needle(430, 190, 120, 50);  // part of the usual place
  ASSERT_TRUE(usual.intersects(needle));
  const QRect moved = label_of_cue(needle);
  ASSERT_FALSE(moved.isEmpty());
  EXPECT_FALSE(moved.intersects(needle)) << moved.left() << ' ' << moved.top();
  // the right half: it goes to the left
  const QRect left = label_of_cue(QRectF(395, 0, 405, 600));
  ASSERT_FALSE(left.isEmpty());
  EXPECT_LT(left.right(), 395);
  EXPECT_NEAR(label_of_cue(needle, true).left(), usual.left(), 2) << "the other eye may see another thing there";
}

TEST(TargetWord, LeavesTheClockClear) {
  const auto drawn = [](bool clear) {
    QImage picture(500, 300, QImage::Format_RGB32);
    picture.fill(Qt::black);
    QPainter painter(&picture);
    const UiTheme ui = UiTheme::stock(QStringLiteral("light"));
    Overlay overlay(painter, picture.rect(), ui);
    if (clear) overlay.keep_clock_clear(QStringLiteral("00:39"));
    CueStyle style;
    style.text = QStringLiteral("Leave this length of thread");
    overlay.target_word({250, 20}, 9, style);  // its first place, right of the circle, reaches below the clock
    painter.end();
    int white = 0;  // where the clock is to be
    for (int y = 4; y < 30; ++y)
      for (int x = 430; x < 490; ++x) white += qGray(picture.pixel(x, y)) > 200;
    return white;
  };
  EXPECT_GT(drawn(false), 100);
  EXPECT_EQ(drawn(true), 0);
}

TEST(TracePlotLines, GoOnOverLatePicturesAndEndWhereTheSignalHasNoValue) {
  using Sample = TracePlot::Sample;
  const double none = std::nan("");
  // ten columns of 1 s; a picture is missing between 1 and 4 s, the signal between 5 and 7 s
  const std::deque<Sample> samples = {{0.5, 1}, {1.5, 1}, {4.5, 2}, {5.5, none}, {6.5, none}, {7.5, 3}, {8.5, 3}};
  const auto columns = TracePlot::columns(samples, 0, 10, 10);
  using Lines = std::vector<std::pair<size_t, size_t>>;
  EXPECT_EQ(TracePlot::lines(columns, 3), (Lines{{0, 4}, {7, 8}}));
  EXPECT_EQ(TracePlot::lines(columns, 2), (Lines{{0, 1}, {4, 4}, {7, 8}})) << "a longer gap than is allowed";
}

TEST(MarksAtOnePlace, AreOneCircleWithoutAWordUntilTheyPart) {
  judge::Script script;
  script.marks.resize(4);
  for (auto& mark : script.marks) mark.mark.kind = SWAGE_MARK_POINT;
  script.marks[3].mark.kind = SWAGE_MARK_ARC_RANGE;
  const auto moment = std::make_unique<snapshot::Snapshot>();
  snapshot::Snapshot& now = *moment;
  now.n_mark = 4;
  now.mark_p_W[0] = {1e-3, 0, 0};
  for (int m : {1, 2, 3}) now.mark_p_W[m] = {};
  EXPECT_EQ(at_one_place(script, now, 0), Together::kAlone);
  EXPECT_EQ(at_one_place(script, now, 1), Together::kFirst);
  EXPECT_EQ(at_one_place(script, now, 2), Together::kLater);
  now.mark_p_W[2].x = 2.4e-3;
  EXPECT_EQ(at_one_place(script, now, 1), Together::kAlone);
  EXPECT_EQ(at_one_place(script, now, 2), Together::kAlone);
}

TEST(MediumLooks, WaterIsTintedAndADryFieldDoesNotGlisten) {
  const MediumLook air = medium_look(SWAGE_MEDIUM_UNSET, 3), dry = medium_look(SWAGE_MEDIUM_DRY, 3), moist = medium_look(SWAGE_MEDIUM_MOIST, 3),
                   water = medium_look(SWAGE_MEDIUM_WATER, 3);
  EXPECT_EQ(air, MediumLook()) << "pictures of lessons without a medium stay as they are";
  EXPECT_EQ(veiled(QColor(10, 200, 90), air), QColor(10, 200, 90));
  EXPECT_LT(dry.tissue_film, air.tissue_film);
  EXPECT_GT(moist.tissue_film, air.tissue_film);
  EXPECT_GT(moist.stage_film, 0);
  EXPECT_GT(water.veil_per_mm, 0);
  EXPECT_NE(veiled(Qt::white, water), QColor(Qt::white));
  EXPECT_LT(veiled(QColor(20, 22, 24), water).lightness(), 90) << "a dark theme stays dark";
  EXPECT_FLOAT_EQ(medium_look(SWAGE_MEDIUM_WATER, 30).veil_per_mm, 0.1F * water.veil_per_mm) << "a scene ten times as large looks alike";
  EXPECT_EQ(medium_words(SWAGE_MEDIUM_UNSET, 0), "");
  EXPECT_EQ(medium_words(SWAGE_MEDIUM_WATER, 1e-3), "Under water");
  EXPECT_EQ(medium_words(SWAGE_MEDIUM_WATER, 1), "In a viscous fluid") << "a pull test lies in what is as thick as glycerine";
}

}  // namespace
}  // namespace swage::console
