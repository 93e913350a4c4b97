// SPDX-License-Identifier: Apache-2.0
//
// How the form shows a parameter: words in place of a number that stands for something else, ranges, lists of choices; and the search.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSignalSpy>
#include <QTest>

#include "console/widgets/live_form.hpp"

namespace swage::console {
namespace {

LiveParam row(int32_t type, const char* instance, const char* id, const char* label, const char* doc) {
  LiveParam out{instance, {}, {}};
  out.param.type = type;
  out.param.id = id, out.param.label = label, out.param.doc = doc;
  out.param.unit = "m", out.param.display_unit = "mm";
  out.param.max = 0.1;
  return out;
}

class LiveFormRows : public ::testing::Test {
 protected:
  void show(const QVector<LiveParam>& params) {
    form.set_params(params);
    form.set_running(true);
    form.show();
  }
  template <class W>
  W* editor(const char* name) {
    return form.findChild<W*>(QStringLiteral("live_%1").arg(QLatin1String(name)));
  }
  bool visible(const char* name) { return editor<QWidget>(name)->isVisible(); }
  LiveForm form{nullptr, LiveForm::Of::kVariant};
};

TEST_F(LiveFormRows, SayInWordsWhatANoughtStandsFor) {
  LiveParam poisson = row(SWAGE_PARAM_REAL, "thread", "poisson", "Poisson's ratio", "Stiffness against twisting. Below 0: as the suture says.");
  poisson.param.unit = poisson.param.display_unit = "1";
  poisson.param.min = -1, poisson.param.max = 0.5, poisson.start[0] = -1;
  show({row(SWAGE_PARAM_REAL, "needle", "taper", "Taper", "Length of the point. 0: as the model says."),
        row(SWAGE_PARAM_REAL, "tissue", "gap", "Gap", "Between two edges; 0 for none."),
        row(SWAGE_PARAM_REAL, "thread", "diameter", "Diameter", "10-0: 20 to 29 um"), poisson});
  EXPECT_EQ(editor<QDoubleSpinBox>("needle_taper_0")->text(), "as the model says");
  EXPECT_EQ(editor<QDoubleSpinBox>("tissue_gap_0")->text(), "none");
  EXPECT_EQ(editor<QDoubleSpinBox>("thread_poisson_0")->text(), "as the suture says");
  EXPECT_TRUE(editor<QDoubleSpinBox>("thread_diameter_0")->text().endsWith("mm")) << "the size 10-0 is no nought";
  editor<QDoubleSpinBox>("needle_taper_0")->setValue(2);
  EXPECT_TRUE(editor<QDoubleSpinBox>("needle_taper_0")->text().startsWith("2")) << "any other number is a number";
  QSignalSpy changed(&form, &LiveForm::changed);
  editor<QDoubleSpinBox>("needle_taper_0")->setValue(0);
  ASSERT_EQ(changed.size(), 1);
  EXPECT_EQ(changed[0][2].toString(), "Taper: as the model says");
}

TEST_F(LiveFormRows, OnlyARangeGoesFromOneNumberToAnother) {
  LiveParam region = row(SWAGE_PARAM_VECTOR, "lesson", "region", "Region", "Where to hold it."), size = region;
  region.param.dimension = 2, region.param.default_number = {0.01, 0.02}, region.start = {0.01, 0.02};
  size.param = region.param, size.start = region.start;
  size.param.id = "size";  // its numbers ascend, too: the table says which of both it is
  region.param.flags = SWAGE_PARAM_INTERVAL;
  show({region, size});
  EXPECT_EQ(editor<QDoubleSpinBox>("lesson_region_0")->prefix(), "from ");
  EXPECT_EQ(editor<QDoubleSpinBox>("lesson_region_1")->prefix(), "to ");
  EXPECT_EQ(editor<QDoubleSpinBox>("lesson_size_0")->prefix(), "") << "10 mm over x and 20 mm over y";
  EXPECT_EQ(editor<QDoubleSpinBox>("lesson_size_1")->prefix(), "by ");
}

TEST_F(LiveFormRows, AFractionThatHasTwoNamesIsOneEntry) {
  LiveParam arc = row(SWAGE_PARAM_CHOICE, "needle", "arc", "Arc", "Share of a circle.");
  arc.param.choices = {"model", "1/4", "3/8", "1/2", "2/8", "4/8", "straight"};
  arc.start[0] = 4;
  show({arc});
  auto* box = editor<QComboBox>("needle_arc_0");
  QStringList words;
  for (int i = 0; i < box->count(); ++i) words += box->itemText(i);
  EXPECT_EQ(words, (QStringList{"model", "1/4 = 2/8", "3/8", "1/2 = 4/8", "straight"}));
  EXPECT_EQ(box->currentText(), "1/4 = 2/8") << "the lesson says 2/8";
  EXPECT_TRUE(form.changes().isEmpty());
  box->setCurrentIndex(4);
  ASSERT_EQ(form.changes().size(), 1);
  EXPECT_EQ(form.changes()[0].second, "\"straight\"");
  form.preset({{"needle", "arc", {5}}});
  EXPECT_EQ(box->currentText(), "1/2 = 4/8");
  EXPECT_EQ(form.changes()[0].second, "\"4/8\"") << "as it was written";
}

/// What the field shows after a person has typed this into it, and has left it.
QString typed(QDoubleSpinBox* box, const QString& text) {
  box->setFocus();
  box->selectAll();
  QTest::keyClicks(box, text);
  QTest::keyClick(box, Qt::Key_Return);
  QTest::qWait(1);  // what is refused is told after the change
  return box->text();
}

TEST_F(LiveFormRows, ANumberMayBeTypedWithItsUnit) {
  show({row(SWAGE_PARAM_REAL, "lesson", "lift", "Lift", "How far.")});
  auto* lift = editor<QDoubleSpinBox>("lesson_lift_0");
  QSignalSpy refused(&form, &LiveForm::refused);
  for (const char* text : {"2500 um", "2500 µm", "2.5", "2,5", "2.5mm", "0.0025 m"}) {
    lift->setValue(1);
    typed(lift, QString::fromUtf8(text));
    EXPECT_NEAR(lift->value(), 2.5, 1e-9) << text;
  }
  EXPECT_EQ(refused.size(), 0);
}

// A number beyond the limits, or a force in a field of lengths, is not silently made into another one.
TEST_F(LiveFormRows, WhatANumberCannotBeIsTold) {
  show({row(SWAGE_PARAM_REAL, "lesson", "lift", "Lift", "How far.")});
  auto* lift = editor<QDoubleSpinBox>("lesson_lift_0");
  QSignalSpy refused(&form, &LiveForm::refused);
  lift->setValue(1);
  typed(lift, "9999");
  EXPECT_NEAR(lift->value(), 100, 1e-9) << "the limit, not the digits that had room";
  ASSERT_EQ(refused.size(), 1);
  EXPECT_TRUE(refused[0][0].toString().startsWith("Lift: At most 100")) << refused[0][0].toString().toStdString();
  for (const char* text : {"3 N", "abc"}) {
    typed(lift, QLatin1String(text));
    EXPECT_NEAR(lift->value(), 100, 1e-9) << text;
  }
  ASSERT_EQ(refused.size(), 3);
  EXPECT_TRUE(refused[2][0].toString().startsWith("Lift: “abc” is no value")) << refused[2][0].toString().toStdString();
}

TEST_F(LiveFormRows, FindASectionAndAWordOfAnExplanation) {
  LiveParam time = row(SWAGE_PARAM_REAL, "lesson", "par_time", "Par time", "Up to here no points are lost.");
  time.param.group = "Limits";
  show({time, row(SWAGE_PARAM_REAL, "lesson", "force", "Force", "Of careful hands."), row(SWAGE_PARAM_REAL, "tissue", "thick", "Thickness", "At rest.")});
  EXPECT_TRUE(form.find("limit"));
  EXPECT_TRUE(visible("lesson_par_time_0"));
  EXPECT_FALSE(visible("lesson_force_0"));
  EXPECT_TRUE(form.find("careful"));
  EXPECT_TRUE(visible("lesson_force_0"));
  EXPECT_FALSE(visible("lesson_par_time_0"));
  EXPECT_TRUE(form.find("tiss"));
  EXPECT_FALSE(visible("lesson_force_0"));
  EXPECT_FALSE(form.find("xyz"));
}

TEST_F(LiveFormRows, WhatIsRarelyChangedIsFoundByItsName) {
  LiveParam rare = row(SWAGE_PARAM_REAL, "lesson", "drop_distance", "Drop distance", "When it fell.");
  rare.param.flags = SWAGE_PARAM_HIDDEN;
  show({row(SWAGE_PARAM_REAL, "lesson", "lift", "Lift", "How far."), rare});
  EXPECT_FALSE(visible("lesson_drop_distance_0"));
  EXPECT_TRUE(visible("lesson_lift_0"));
  EXPECT_TRUE(form.find("drop"));
  EXPECT_TRUE(visible("lesson_drop_distance_0"));
  editor<QDoubleSpinBox>("lesson_drop_distance_0")->setValue(3);
  form.find({});
  EXPECT_TRUE(visible("lesson_drop_distance_0")) << "it is another than the lesson's";
}

// What the window tells a device itself, such as the circle of a held needle, is no line of the form during an attempt.
TEST(LiveParams, ShowNoHiddenOnesDuringAnAttempt) {
  host::Catalogue::Options nothing;
  nothing.use_environment = false;
  host::Catalogue catalogue(nothing);
  host::PluginInfo mouse;
  mouse.kind = SWAGE_KIND_DEVICE, mouse.id = "x.mouse";
  for (const char* id : {"drag", "circle"}) {
    host::Param param;
    param.type = SWAGE_PARAM_REAL, param.id = id, param.unit = "m", param.max = 1;
    param.flags = SWAGE_PARAM_LIVE | (std::string(id) == "circle" ? SWAGE_PARAM_HIDDEN : 0);
    mouse.params.push_back(param);
  }
  catalogue.add(mouse);
  snapshot::SceneCard card;
  card.devices.push_back({"hand", "x.mouse", "1"});
  const QVector<LiveParam> shown = live_params("", card, catalogue);
  ASSERT_EQ(shown.size(), 1);
  EXPECT_EQ(shown[0].param.id, "drag");
}

}  // namespace
}  // namespace swage::console
