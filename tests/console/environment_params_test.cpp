// SPDX-License-Identifier: Apache-2.0
//
// The environment of a lesson in the instructor's form: a row for each key, numbers that depend on the medium, and text that the lesson
// reader accepts.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QTest>
#include <cmath>
#include <nlohmann/json.hpp>

#include "assembly/lesson_file.hpp"
#include "assembly/settings.hpp"
#include "console/models/environment_params.hpp"
#include "console/models/said.hpp"
#include "console/widgets/live_form.hpp"
#include "host/environment.hpp"

namespace swage::console {
namespace {

class EnvironmentRows : public ::testing::Test {
 protected:
  void show(const std::string& section) {
    section_ = section;
    form.set_params(environment_params(section));
    form.set_running(true);
  }
  QDoubleSpinBox* number(const char* key) {
    return form.findChild<QDoubleSpinBox*>(QStringLiteral("live_environment_%1_0").arg(QLatin1String(key)));
  }
  void choose(const char* medium) {
    auto* box = form.findChild<QComboBox*>("live_environment_medium_0");
    const int at = box->findText(QString::fromLatin1(medium));
    ASSERT_GE(at, 0) << medium;
    box->setCurrentIndex(at);
  }
  /// The section as written to the file, with the changes.
  nlohmann::ordered_json written() {
    nlohmann::ordered_json lesson = {{"environment", nlohmann::ordered_json::parse(section_.empty() ? "{}" : section_)}};
    for (const auto& [what, value] : form.changes()) {
      base::Problems problems;
      std::vector<std::string> pointers;
      EXPECT_TRUE(assembly::set_in(lesson, {what, value}, "", problems, pointers)) << what;
    }
    return lesson["environment"];
  }
  LiveForm form{nullptr, LiveForm::Of::kVariant};
  std::string section_;
};

TEST_F(EnvironmentRows, HaveEveryKeyWithWordsUnitAndLimits) {
  const QVector<LiveParam> rows = environment_params("");
  ASSERT_EQ(rows.size(), 1 + static_cast<qsizetype>(std::size(host::kEnvironmentKeys)));
  for (const LiveParam& row : rows) {
    EXPECT_FALSE(row.param.label.empty() || row.param.doc.empty()) << row.param.id;
    EXPECT_EQ(row.instance, "environment");
    if (row.param.type == SWAGE_PARAM_CHOICE) continue;
    EXPECT_LT(row.param.min, row.param.max) << row.param.id;
    EXPECT_FALSE(row.unit().isEmpty()) << row.param.id;
    EXPECT_GT(row.factor(), 0) << row.param.id;
  }
}

TEST_F(EnvironmentRows, AreAllSaidInGerman) {
  set_words_language(QStringLiteral("de"));
  std::vector<std::string> all = {"not set", "dry", "moist", "water", "none"};
  for (const LiveParam& row : environment_params("")) {
    all.push_back(row.param.doc);
    if (row.param.label != "Medium") all.push_back(row.param.label);  // the same in German
  }
  for (const std::string& words : all) EXPECT_NE(said(words), QString::fromStdString(words)) << words;
  EXPECT_EQ(said_id("environment"), QStringLiteral("Umgebung"));
  set_words_language(QStringLiteral("en"));
}

TEST_F(EnvironmentRows, NumbersFollowTheMediumUntilTheyAreChanged) {
  show("");
  EXPECT_FALSE(number("density")->isEnabled()) << "there is no medium yet";
  choose("water");
  EXPECT_TRUE(number("density")->isEnabled());
  EXPECT_DOUBLE_EQ(number("density")->value(), 998);
  EXPECT_DOUBLE_EQ(number("viscosity")->value(), 1) << "mPa s";
  EXPECT_FALSE(number("film")->isEnabled()) << "there is no film under water";
  EXPECT_EQ(written().dump(), R"({"medium":"water"})");
  choose("moist");
  EXPECT_DOUBLE_EQ(number("film")->value(), 100) << "um";
  EXPECT_DOUBLE_EQ(number("density")->value(), 1.2);
  number("film")->setValue(50);
  number("density")->setValue(1.1);
  EXPECT_EQ(written().dump(), R"({"medium":"moist","density":"1.1 kg/m3","film":"50 um"})");
  choose("water");
  EXPECT_EQ(written().dump(), R"({"medium":"water","density":"1.1 kg/m3"})") << "what means nothing there is not written";
  choose("not set");
  EXPECT_EQ(written().dump(), "{}");
}

TEST_F(EnvironmentRows, KeepWhatTheLessonSays) {
  show(R"({"medium": "dry", "charge": "0.5 nC/m", "earthed_plane": "2 mm", "viscosity": 2e-5})");
  EXPECT_DOUBLE_EQ(number("charge")->value(), 0.5);
  EXPECT_DOUBLE_EQ(number("earthed_plane")->value(), 2);
  EXPECT_TRUE(form.changes().isEmpty());
  choose("moist");
  EXPECT_DOUBLE_EQ(number("viscosity")->value(), 0.02) << "mPa s, as the lesson says it";
  EXPECT_EQ(form.findChild<QComboBox*>("live_environment_medium_0")->findText("not set"), -1) << "it cannot be taken back";
}

TEST_F(EnvironmentRows, SayNoneForAPlaneThatIsNotThere) {
  show(R"({"medium": "dry"})");
  EXPECT_EQ(number("earthed_plane")->text(), "none");
  number("earthed_plane")->setValue(0);
  EXPECT_EQ(written().dump(), R"({"medium":"dry","earthed_plane":"0 mm"})");
  number("earthed_plane")->setValue(number("earthed_plane")->minimum());
  EXPECT_TRUE(form.changes().isEmpty());
}

}  // namespace
}  // namespace swage::console
