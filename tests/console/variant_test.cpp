// SPDX-License-Identifier: Apache-2.0
//
// A lesson of one's own: what is changed in the form is what the file sets, and nothing is written that could not be practised.
#include <gtest/gtest.h>

#include <QDoubleSpinBox>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "assembly/lesson_text.hpp"
#include "console/models/variant.hpp"
#include "console/pages/variant_dialog.hpp"

namespace swage::console {
namespace {

LiveParam length(const char* instance, const char* id, const char* label, double start_m) {
  LiveParam live{instance, {}, {start_m}};
  live.param.type = SWAGE_PARAM_REAL;
  live.param.id = id, live.param.label = label;
  live.param.unit = "m", live.param.display_unit = "mm";
  live.param.min = 0, live.param.max = 0.1;
  return live;
}

QByteArray read(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

const QVector<LiveParam> kParams = {length("needle", "size", "Size", 5e-3),
                                    length("needle", "wire", "Wire", 1e-4),
                                    length("tissue", "thickness", "Thickness", 3e-3)};

TEST(Variants, ATitleMakesAName) {
  EXPECT_EQ(slug("Stiff wall, 2/8"), "stiff_wall_2_8");
  EXPECT_EQ(slug("  Schräge Fläche "), "schrage_flache");
  EXPECT_EQ(slug("..//"), "lesson") << "no way out of the folder";
}

TEST(Variants, NameTheirBaseFromWhereTheyAre) {
  const Variant v{"/a/b/base.json", " Mine ", "", "", {{"needle.size", "\"4 mm\""}}};
  EXPECT_TRUE(variant_text(v, "/a/b").contains("\"based_on\": \"base.json\""));
  EXPECT_TRUE(variant_text(v, "/a").contains("\"based_on\": \"b/base.json\""));
  EXPECT_TRUE(variant_text(v, "/c").contains("\"based_on\": \"/a/b/base.json\""));
  EXPECT_TRUE(variant_text(v, "/c").contains("\"title\": \"Mine\""));
}

TEST(Variants, AreNotWrittenOverOneAnother) {
  QTemporaryDir dir;
  const Saved first = save_variant({"/a/base.json", "Mine", "", "", {}}, dir.filePath("lessons"));
  ASSERT_EQ(first.problem, "");
  const QByteArray text = read(first.path);
  EXPECT_FALSE(text.isEmpty());
  const Saved second = save_variant({"/b/base.json", "Mine", "", "", {}}, dir.filePath("lessons"));
  EXPECT_TRUE(second.path.isEmpty());
  EXPECT_TRUE(second.problem.contains("already"));
  EXPECT_EQ(read(first.path), text);
  EXPECT_FALSE(save_variant({"/a/base.json", "  ", "", "", {}}, dir.path()).problem.isEmpty());
  EXPECT_FALSE(save_variant({"/a/base.json", "Mine", "", "", {}}, "/proc/no/such").problem.isEmpty());
}

class VariantDialogs : public ::testing::Test {
 protected:
  VariantDialogs() {
    base.path = dir.filePath("base.json");
    base.title = "Base";
    base.goal = "To learn.";
    QFile file(base.path);
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(R"({ "format": "swage-lesson/1", "id": "base", "title": "Base", "lesson": { "plugin": "p" },
      "objects": [ { "name": "needle", "plugin": "n" }, { "name": "tissue", "plugin": "t" } ] })");
    file.close();
    dialog = std::make_unique<VariantDialog>(
        base, kParams, [this](const auto& set) { return checked = set, problem; }, dir.filePath("own"),
        nullptr);
    dialog->show();
  }
  template <class W>
  W* child(const char* name) {
    return dialog->findChild<W*>(QString::fromLatin1(name));
  }
  void set(const char* editor, double shown) { child<QDoubleSpinBox>(editor)->setValue(shown); }
  void save() { QTest::mouseClick(child<QPushButton>("variant_save"), Qt::LeftButton); }

  QTemporaryDir dir;
  LessonEntry base;
  QString problem;
  QVector<std::pair<std::string, std::string>> checked;
  std::unique_ptr<VariantDialog> dialog;
};

TEST_F(VariantDialogs, WriteWhatWasChangedAndItReadsBack) {
  child<QLineEdit>("variant_title")->setText("Thin wall");
  set("live_tissue_thickness_0", 1.5);
  set("live_needle_size_0", 4);
  set("live_needle_size_0", 5);  // and back
  EXPECT_EQ(child<QLabel>("variant_problem")->text(), "One value is changed.");
  save();
  EXPECT_EQ(dialog->result(), QDialog::Accepted);
  ASSERT_EQ(dialog->saved(), dir.filePath("own/thin_wall.json"));
  ASSERT_EQ(checked.size(), 1);
  EXPECT_EQ(checked[0].first, "tissue.thickness");
  assembly::LessonText whole;
  base::Problems problems;
  ASSERT_TRUE(assembly::read_lesson_text(dialog->saved().toStdString(), {}, whole, problems));
  const auto lesson = nlohmann::json::parse(whole.text);
  EXPECT_EQ(lesson["id"], "own.thin_wall");
  EXPECT_EQ(lesson["goal"], "To learn.");
  EXPECT_EQ(lesson["objects"][1]["params"]["thickness"], "1.5 mm");
  EXPECT_FALSE(lesson["objects"][0].contains("params"));
}

TEST_F(VariantDialogs, WriteNothingThatCannotBePractised) {
  problem = "The jaws do not meet.";
  set("live_needle_wire_0", 0.2);
  save();
  EXPECT_TRUE(dialog->isVisible());
  EXPECT_EQ(child<QLabel>("variant_problem")->text(), problem);
  EXPECT_FALSE(QFile::exists(dir.filePath("own")));
}

TEST_F(VariantDialogs, WantATitle) {
  child<QLineEdit>("variant_title")->clear();
  EXPECT_FALSE(child<QPushButton>("variant_save")->isEnabled());
}

TEST_F(VariantDialogs, FindAValueByItsNameOrItsPart) {
  const auto shown = [this](const char* name) { return !child<QWidget>(name)->isHidden(); };
  auto* find = child<QLineEdit>("variant_find");
  find->setText("thick");
  EXPECT_TRUE(shown("live_tissue_thickness_0"));
  EXPECT_FALSE(shown("live_needle_size_0"));
  find->setText("NEEDLE");
  EXPECT_FALSE(shown("live_tissue_thickness_0"));
  EXPECT_TRUE(shown("live_needle_size_0") && shown("live_needle_wire_0"));
  find->clear();
  EXPECT_TRUE(shown("live_tissue_thickness_0") && shown("live_needle_size_0"));
}

}  // namespace
}  // namespace swage::console
