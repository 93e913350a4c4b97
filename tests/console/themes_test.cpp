// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <QFile>
#include <QImage>
#include <QPainter>
#include <QSet>
#include <QTemporaryDir>

#include "colour_vision.hpp"
#include "console/cues/cue_theme.hpp"
#include "console/cues/tones.hpp"
#include "console/cues/ui_theme.hpp"

namespace swage::console {
namespace {

using test::Vision;
constexpr Vision kVisions[] = {Vision::kUsual, Vision::kRedBlind, Vision::kGreenBlind, Vision::kBlueBlind};
const QStringList kGrasps = {"grasp.wrong", "grasp.tips_only", "grasp.point_only", "grasp.good"};

double worst_pair(const CueTheme& theme) {
  double worst = 1e9;
  for (const Vision v : kVisions) {
    for (int i = 0; i < kGrasps.size(); ++i) {
      for (int k = 0; k < i; ++k) {
        worst = std::min(worst,
                         test::difference(theme.style(kGrasps[i]).colour, theme.style(kGrasps[k]).colour, v));
      }
    }
  }
  return worst;
}

// pairs 1, 4, 7, 9, 13, 16, 17, 21, 25, 31, 34 of the supplementary data of Sharma, Wu, Dalal 2005
TEST(ColourDifference, AgreesWithPublishedPairs) {
  const struct {
    test::Lab p, q;
    double expected;
  } pairs[] = {{{50, 2.6772, -79.7751}, {50, 0, -82.7485}, 2.0425},
               {{50, -1.3802, -84.2814}, {50, 0, -82.7485}, 1.0000},
               {{50, 0, 0}, {50, -1, 2}, 2.3669},
               {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0009}, 7.1792},
               {{50, -0.0010, 2.4900}, {50, 0.0009, -2.4900}, 4.8045},
               {{50, 2.5, 0}, {50, 0, -2.5}, 4.3065},
               {{50, 2.5, 0}, {73, 25, -18}, 27.1492},
               {{50, 2.5, 0}, {50, 3.1736, 0.5854}, 1.0000},
               {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
               {{90.8027, -2.0831, 1.4410}, {91.1528, -1.6435, 0.0447}, 1.4441},
               {{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082}};
  for (const auto& pair : pairs) {
    EXPECT_NEAR(test::delta_e2000(pair.p, pair.q), pair.expected, 1e-4);
    EXPECT_NEAR(test::delta_e2000(pair.q, pair.p), pair.expected, 1e-4);
  }
}

// thesis 6.2.4: the point turns green while the needle is there and blue again after the hold; the tick marks it without colour
TEST(CueThemes, ATargetIsOfItsFirstColourAgainWhenItIsDone) {
  for (const QString& name : CueTheme::stock()) {
    for (const CueTheme& theme : {CueTheme::stock(name), CueTheme::stock(name).on_dark()}) {
      const CueStyle first = theme.style("target.point"), near = theme.style("target.near"), done = theme.style("target.done");
      EXPECT_EQ(done.colour, first.colour) << name.toStdString();
      EXPECT_NE(near.colour, first.colour) << name.toStdString();
      EXPECT_NE(done.shape, first.shape) << name.toStdString();
    }
  }
}

TEST(CueThemes, SafeOneIsSafeInEveryVision) { EXPECT_GE(worst_pair(CueTheme::stock("safe")), 20); }

// WCAG 2.1: relative luminance, and contrast between text and background
double luminance(const QColor& c) {
  return 0.2126 * test::to_linear(c.redF()) + 0.7152 * test::to_linear(c.greenF()) +
         0.0722 * test::to_linear(c.blueF());
}
double contrast(const QColor& p, const QColor& q) {
  const double a = luminance(p), b = luminance(q);
  return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

// WCAG 2.1 requires 3:1 for graphical objects (1.4.11)
TEST(CueThemes, SafeOneIsSeenInDarkWindowsAndSafeThereToo) {
  const CueTheme theme = CueTheme::stock("safe").on_dark();
  EXPECT_GE(worst_pair(theme), 20);
  for (const QString& name : UiTheme::names()) {
    const UiTheme ui = UiTheme::stock(name);
    if (!ui.dark()) continue;
    for (const QString& meaning : theme.meanings())
      for (const char* ground : {"window", "card", "floor", "view_bottom"})
        EXPECT_GE(contrast(theme.style(meaning).colour, ui[ground]), 3)
            << name.toStdString() << " " << ground << " " << meaning.toStdString();
  }
}

void expect_all_apart(const CueTheme& theme) {
  const QStringList all = theme.meanings();
  ASSERT_GT(all.size(), 8);
  for (int i = 0; i < all.size(); ++i) {
    for (int k = 0; k < i; ++k) {
      const CueStyle a = theme.style(all[i]), b = theme.style(all[k]);
      if (a.colour == b.colour) {
        EXPECT_NE(a.shape + a.text, b.shape + b.text) << all[i].toStdString() << " " << all[k].toStdString();
        continue;
      }
      for (const Vision v : kVisions) {
        EXPECT_GE(test::difference(a.colour, b.colour, v), 20)
            << all[i].toStdString() << " " << all[k].toStdString() << " vision " << static_cast<int>(v);
      }
    }
  }
}

TEST(CueThemes, SafeOneTellsEveryPairOfCuesApart) {
  expect_all_apart(CueTheme::stock("safe"));
  expect_all_apart(CueTheme::stock("safe").on_dark());
}

TEST(CueThemes, ThesisOneHasTheThesisColours) {
  const CueTheme theme = CueTheme::stock("thesis");
  const auto hue = [&](const char* meaning) { return theme.style(meaning).colour.hue(); };
  EXPECT_TRUE(hue("grasp.wrong") < 15 || hue("grasp.wrong") > 345);
  EXPECT_TRUE(hue("grasp.tips_only") > 300 && hue("grasp.tips_only") < 350);
  EXPECT_NEAR(hue("grasp.point_only"), 52, 10);
  EXPECT_NEAR(hue("grasp.good"), 130, 20);
  EXPECT_EQ(CueTheme::stock().first(), "thesis");
}

TEST(CueThemes, EveryCueThatIsNotAPlaceIsHeardAndFelt) {
  for (const QString& id : CueTheme::stock()) {
    const CueTheme theme = CueTheme::stock(id);
    QSet<QString> sounds;
    for (const QString& meaning : kGrasps) sounds += theme.style(meaning).sound;
    EXPECT_EQ(sounds.size(), 4) << "each of the four grasps sounds different";
    for (const char* meaning : {"grasp.wrong", "grasp.good", "grip.too_hard", "insert.angle_off"}) {
      EXPECT_FALSE(tone(theme.style(meaning).sound).empty()) << meaning;
      EXPECT_GT(theme.style(meaning).force.pulses, 0) << meaning;
    }
  }
}

TEST(CueThemes, AForceThatNoDeviceMayPlayIsRefused) {
  QTemporaryDir dir;
  QFile file(dir.filePath("strong.json"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(
      R"({"format": "swage-cue-theme/1", "cues": [{"meaning": "a.b", "colour": "#123456", "shape": "O", "text": "t",
                 "force": {"pulses": 1, "frequency_hz": 100, "peak_n": 5, "length_s": 0.05}}]})");
  file.close();
  QString error;
  EXPECT_TRUE(CueTheme::load(file.fileName(), &error).meanings().isEmpty());
  EXPECT_TRUE(error.contains("peak_n")) << error.toStdString();
}

TEST(CueThemes, ASoundThatDoesNotExistIsRefusedWithTheList) {
  QTemporaryDir dir;
  QFile file(dir.filePath("loud.json"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(R"({"format": "swage-cue-theme/1", "cues": [
    {"meaning": "a.b", "colour": "#123456", "shape": "O", "text": "t", "sound": "trumpet"}]})");
  file.close();
  QString error;
  EXPECT_TRUE(CueTheme::load(file.fileName(), &error).meanings().isEmpty());
  EXPECT_TRUE(error.contains("trumpet") && error.contains("chime")) << error.toStdString();
}

TEST(CueThemes, ThesisColoursAreNotWhichIsWhyThereIsASafeOne) {
  EXPECT_LT(worst_pair(CueTheme::stock("thesis")), 20);
}

// where to grasp and where not may have one colour, red: their signs are no part of each other
TEST(CueThemes, WhereToGraspAndAWrongPlaceDifferByTheirFirstSign) {
  for (const QString& id : CueTheme::stock()) {
    const CueTheme theme = CueTheme::stock(id);
    const auto picture = [&](const char* meaning) {
      QImage out(24, 24, QImage::Format_Grayscale8);
      out.fill(Qt::white);
      QPainter painter(&out);
      CueStyle style = theme.style(QString::fromLatin1(meaning));
      style.shape = style.shape.left(1);
      style.colour = Qt::black;
      paint_cue_shape(painter, {0, 0}, 24, style);
      painter.end();
      return out;
    };
    for (const char* wrong : {"grasp.wrong", "grasp.tips_only"})
      for (const char* here : {"region.target", "target.point", "grasp.good"}) EXPECT_NE(picture(wrong), picture(here)) << wrong << " " << here;
    EXPECT_NE(picture("region.target"), picture("target.point"));
  }
}

TEST(CueThemes, EveryStateDiffersWithoutColourToo) {
  for (const QString& id : CueTheme::stock()) {
    const CueTheme theme = CueTheme::stock(id);
    QSet<QString> shapes, texts;
    for (const QString& meaning : kGrasps) {
      ASSERT_TRUE(theme.knows(meaning)) << id.toStdString();
      shapes += theme.style(meaning).shape;
      texts += theme.style(meaning).text;
    }
    EXPECT_EQ(shapes.size(), 4);
    EXPECT_EQ(texts.size(), 4);
    EXPECT_TRUE(theme.knows("grip.too_hard") && theme.knows("region.target"));
  }
}

TEST(CueThemes, UnknownMeaningsAreShownByName) {
  const CueStyle style = CueTheme::stock("safe").style("clip.half_open");
  EXPECT_EQ(style.text, "clip half open");
  EXPECT_FALSE(style.shape.isEmpty());
}

TEST(CueThemes, AFaultyFileSaysWhichCue) {
  QTemporaryDir dir;
  const QString path = dir.filePath("bad.json");
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(
      R"({"format": "swage-cue-theme/1", "id": "x", "cues": [{"meaning": "a.b", "colour": "#12", "shape": "O", "text": "t"}]})");
  file.close();
  QString error;
  EXPECT_TRUE(CueTheme::load(path, &error).meanings().isEmpty());
  EXPECT_TRUE(error.contains("a.b")) << error.toStdString();
  EXPECT_TRUE(CueTheme::load(dir.filePath("none.json"), &error).meanings().isEmpty());
  EXPECT_TRUE(error.contains("none.json"));
}

TEST(UiThemes, TextIsReadable) {
  for (const QString& name : UiTheme::names()) {
    const UiTheme t = UiTheme::stock(name);
    ASSERT_EQ(t.id(), name);
    for (const char* role : {"text", "muted", "good", "warn", "bad", "accent"}) {
      EXPECT_GE(contrast(t[role], t["card"]), 4.5) << name.toStdString() << " " << role;
    }
    EXPECT_GE(contrast(t["accent_text"], t["accent"]), 4.5) << name.toStdString();
    EXPECT_GE(contrast(t["muted"], t["window"]), 4.5) << name.toStdString();
    EXPECT_GE(contrast(t["muted"], t["raised"]), 4.5) << name.toStdString() << ": START while an attempt runs";
  }
}

TEST(UiThemes, StyleSheetKnowsEveryColourItNames) {
  for (const QString& name : UiTheme::names()) {
    const QString sheet = UiTheme::stock(name).style_sheet();
    EXPECT_FALSE(sheet.isEmpty());
    EXPECT_FALSE(sheet.mid(sheet.indexOf("*/")).contains('@')) << name.toStdString();
  }
}

}  // namespace
}  // namespace swage::console
