// SPDX-License-Identifier: Apache-2.0
//
// The form of a derived lesson: its changes are the values set in the file, and only lessons that can be built are written.
#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "assembly/lesson_text.hpp"
#include "console/models/variant.hpp"
#include "console/pages/parts_panel.hpp"
#include "console/pages/variant_dialog.hpp"
#include "console/widgets/live_form.hpp"

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

host::Param param(const char* id, const char* label, double default_m) {
  host::Param p = length("", id, label, 0).param;
  p.dimension = 1;
  p.default_number[0] = default_m;
  p.default_text = std::to_string(default_m);
  return p;
}

host::PluginInfo plugin(int32_t kind, const char* id, host::ParamTable params = {}) {
  host::PluginInfo out;
  out.kind = kind, out.id = id, out.name = id, out.version = "1.0.0";
  out.params = std::move(params);
  return out;
}

host::Catalogue catalogue() {
  host::Catalogue out;
  out.add(plugin(SWAGE_KIND_OBJECT, "x.needle", {param("size", "Size", 5e-3), param("wire", "Wire", 1e-4)}));
  out.add(plugin(SWAGE_KIND_OBJECT, "x.tissue", {param("thickness", "Thickness", 3e-3)}));
  out.add(plugin(SWAGE_KIND_COUPLING, "x.pierce"));
  out.add(plugin(SWAGE_KIND_DEVICE, "x.mouse"));
  out.add(plugin(SWAGE_KIND_LESSON, "x.lesson"));
  return out;
}

TEST(OwnLessons, TellWhatIsBasedOnThem) {
  QTemporaryDir dir;
  const QString own = dir.filePath("own");
  const Saved first = save_variant({"/a/base.json", "First", "", "", {}}, own);
  const Saved second = save_variant({first.path, "Second", "", "", {}}, own);
  EXPECT_EQ(based_on_it(first.path, own), QStringList{"Second"});
  EXPECT_TRUE(based_on_it(second.path, own).isEmpty());
}

class VariantDialogs : public ::testing::Test {
 protected:
  VariantDialogs() {
    base.path = dir.filePath("base.json");
    base.title = "Base";
    base.goal = "To learn.";
    QFile file(base.path);
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(R"({ "format": "swage-lesson/1", "id": "base", "title": "Base", "lesson": { "plugin": "x.lesson" },
      "objects": [ { "name": "needle", "plugin": "x.needle" }, { "name": "tissue", "plugin": "x.tissue" } ],
      "couplings": [ { "plugin": "x.pierce", "between": ["needle", "tissue"] } ] })");
    file.close();
    open();
  }
  void open() {
    dialog.reset();
    dialog = std::make_unique<VariantDialog>(base, services(), dir.filePath("own"), nullptr);
    dialog->show();
  }
  VariantDialog::Services services() {
    const auto build = [this](const QString& path, base::Problems& problems) -> std::unique_ptr<snapshot::SceneCard> {
      ++built;
      assembly::LessonText whole;
      if (assembly::read_lesson_text(path.toStdString(), {}, whole, problems)) checked = whole.json;
      if (problem.isEmpty()) return std::make_unique<snapshot::SceneCard>();
      problems.push_back({base::Severity::kError, at.toStdString(), problem.toStdString()});
      return nullptr;
    };
    return {build, catalogue(), dir.filePath("drafts")};
  }
  QStringList drafts() const { return QDir(dir.filePath("drafts")).entryList(QDir::Files); }
  QStringList parts() {
    QStringList names;
    for (const LessonPart& part : dialog->draft().parts()) names += part.name;
    return names;
  }
  void undo() { child<QAction>("variant_undo")->trigger(); }
  void redo() { child<QAction>("variant_redo")->trigger(); }
  template <class W>
  W* child(const char* name) {
    return dialog->findChild<W*>(QString::fromLatin1(name));
  }
  void set(const char* editor, double shown) { child<QDoubleSpinBox>(editor)->setValue(shown); }
  /// Presses Esc, and this button of the question that comes.
  void leave(const QString& answer) {
    QTimer::singleShot(0, dialog.get(), [this, answer] {
      const auto* box = child<QMessageBox>("leave_unsaved");
      ASSERT_NE(box, nullptr) << "nothing is asked";
      for (QAbstractButton* b : box->buttons())
        if (b->text() == answer) return b->click();
      FAIL() << answer.toStdString();
    });
    QTest::keyClick(dialog.get(), Qt::Key_Escape);
  }
  void save() { QTest::mouseClick(child<QPushButton>("variant_save"), Qt::LeftButton); }

  QTemporaryDir dir;
  LessonEntry base;
  QString problem, at = QStringLiteral("x.json:1");
  nlohmann::ordered_json checked;  // the lesson that was built last
  int built = 0;
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
  EXPECT_EQ(checked["objects"][1]["params"]["thickness"], "1.5 mm");
  assembly::LessonText whole;
  base::Problems problems;
  ASSERT_TRUE(assembly::read_lesson_text(dialog->saved().toStdString(), {}, whole, problems));
  const auto lesson = nlohmann::json::parse(whole.text);
  EXPECT_EQ(lesson["id"], "own.thin_wall");
  EXPECT_EQ(lesson["goal"], "To learn.");
  EXPECT_EQ(lesson["objects"][1]["params"]["thickness"], "1.5 mm");
  EXPECT_FALSE(lesson["objects"][0].contains("params"));
}

TEST_F(VariantDialogs, SayFromWhereTheTraineeLooksFirst) {
  child<QLineEdit>("variant_title")->setText("From above");
  auto* look = child<QComboBox>("variant_look");
  EXPECT_EQ(look->currentText(), "Unchanged");
  look->setCurrentIndex(look->findData("top"));
  EXPECT_TRUE(child<QPushButton>("variant_save")->isEnabled());
  undo();
  EXPECT_EQ(look->currentText(), "Unchanged");
  redo();
  EXPECT_EQ(look->currentText(), "Top");
  save();
  EXPECT_EQ(checked["view"], "top");
  const LessonEntry own = read_lesson(dialog->saved());
  EXPECT_EQ(view_in(own.path), "top");
  VariantDialog edits(own, services(), {}, nullptr);
  auto* kept = edits.findChild<QComboBox*>("variant_look");
  EXPECT_EQ(kept->currentText(), "Top");
  kept->setCurrentIndex(0);
  QTest::mouseClick(edits.findChild<QPushButton*>("variant_save"), Qt::LeftButton);
  EXPECT_EQ(view_in(own.path), "") << "as its base says";
}

TEST_F(VariantDialogs, StartWithWhatAnAttemptWasAdjustedTo) {
  dialog->preset({{"tissue", "thickness", {2e-3}}, {"nobody", "size", {1}}});
  EXPECT_EQ(child<QDoubleSpinBox>("live_tissue_thickness_0")->value(), 2);
  EXPECT_EQ(child<QLabel>("variant_problem")->text(), "One value is changed. Those of the last attempt are kept.");
  save();
  EXPECT_EQ(checked["objects"][1]["params"]["thickness"], "2 mm");
}

TEST_F(VariantDialogs, SayWhenNothingIsCalledSo) {
  child<QLineEdit>("variant_find")->setText("tiss");
  EXPECT_FALSE(child<QLabel>("variant_none")->isVisible());
  child<QLineEdit>("variant_find")->setText("xyz");
  EXPECT_TRUE(child<QLabel>("variant_none")->isVisible());
  EXPECT_TRUE(child<QLabel>("variant_none")->text().contains("xyz"));
}

TEST_F(VariantDialogs, EditALessonOfOnesOwn) {
  child<QLineEdit>("variant_title")->setText("Own");
  set("live_needle_size_0", 4);
  save();
  const LessonEntry own = read_lesson(dialog->saved());
  VariantDialog edits(own, services(), {}, nullptr);
  edits.show();
  auto* save_button = edits.findChild<QPushButton*>("variant_save");
  EXPECT_FALSE(save_button->isEnabled()) << "nothing is changed yet";
  edits.findChild<QLineEdit*>("variant_title")->setText("Renamed");
  ASSERT_TRUE(save_button->isEnabled()) << "words alone can be changed";
  QTest::mouseClick(save_button, Qt::LeftButton);
  EXPECT_EQ(edits.saved(), own.path);
  EXPECT_EQ(read_lesson(own.path).title, "Renamed");
  EXPECT_EQ(read_lesson(own.path).id, own.id);
}

TEST_F(VariantDialogs, WriteNothingThatCannotBePractised) {
  problem = "The jaws do not meet.";
  set("live_needle_wire_0", 0.2);
  save();
  EXPECT_TRUE(dialog->isVisible());
  EXPECT_EQ(child<QLabel>("variant_problem")->text(), "▲ " + problem);
  EXPECT_FALSE(QFile::exists(dir.filePath("own")));
}

// "#/set/tissue.thickness" is where a lesson that changes another is wrong
TEST_F(VariantDialogs, SayWhichValueIsWrong) {
  problem = "the first number must be below the second";
  at = "#/set/tissue.thickness";
  set("live_tissue_thickness_0", 1.5);
  save();
  const QString name = child<QDoubleSpinBox>("live_tissue_thickness_0")->accessibleName();
  ASSERT_FALSE(name.isEmpty());
  EXPECT_EQ(child<QLabel>("variant_problem")->text(), "▲ " + name + ": " + problem);
}

// U15
TEST_F(VariantDialogs, WriteNothingWhenTheyAreLeft) {
  child<QLineEdit>("variant_title")->setText("Thin wall");
  set("live_tissue_thickness_0", 1.5);
  leave("Go on editing");
  EXPECT_TRUE(dialog->isVisible());
  EXPECT_NEAR(child<QDoubleSpinBox>("live_tissue_thickness_0")->value(), 1.5, 1e-9);
  leave("Leave");
  EXPECT_EQ(dialog->result(), QDialog::Rejected);
  EXPECT_FALSE(dialog->isVisible());
  EXPECT_FALSE(QFile::exists(dir.filePath("own")));
  EXPECT_EQ(drafts(), QStringList()) << "the draft goes, too";
}

TEST_F(VariantDialogs, EveryEditIsUndoneAndDoneAgain) {
  child<QLineEdit>("variant_title")->setText("Thin");
  child<QLineEdit>("variant_title")->setText("Thin wall");
  set("live_tissue_thickness_0", 1.5);
  dialog->draft().remove_part("tissue");
  EXPECT_EQ(parts(), QStringList{"needle"}) << "what bound it went with it";
  EXPECT_EQ(child<QDoubleSpinBox>("live_tissue_thickness_0"), nullptr);
  undo();
  EXPECT_EQ(parts(), (QStringList{"needle", "tissue", "pierce"}));
  ASSERT_NE(child<QDoubleSpinBox>("live_tissue_thickness_0"), nullptr);
  EXPECT_EQ(child<QDoubleSpinBox>("live_tissue_thickness_0")->value(), 1.5) << "its values come back with it";
  undo();
  EXPECT_EQ(child<QDoubleSpinBox>("live_tissue_thickness_0")->value(), 3);
  EXPECT_TRUE(child<QLineEdit>("variant_title")->text() == "Thin wall");
  undo();
  EXPECT_EQ(child<QLineEdit>("variant_title")->text(), "Base, adapted") << "typing one field is one edit";
  EXPECT_FALSE(child<QPushButton>("variant_save")->isEnabled());
  for (int i = 0; i < 3; ++i) redo();
  EXPECT_EQ(parts(), QStringList{"needle"});
  save();
  assembly::LessonText whole;
  base::Problems problems;
  ASSERT_TRUE(assembly::read_lesson_text(dialog->saved().toStdString(), {}, whole, problems));
  EXPECT_EQ(whole.json["objects"].size(), 1u);
  EXPECT_TRUE(whole.json["couplings"].empty());
}

TEST_F(VariantDialogs, KeysOfUndoAreTheLessonsInEveryField) {
  set("live_tissue_thickness_0", 1.5);
  auto* title = child<QLineEdit>("variant_title");
  dialog->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(dialog.get()));
  title->setFocus();
  title->selectAll();
  QTest::keyClicks(title, "x");
  QTest::keySequence(title, QKeySequence::Undo);
  QTest::keySequence(title, QKeySequence::Undo);
  EXPECT_EQ(title->text(), "Base, adapted");
  auto* thickness = child<QDoubleSpinBox>("live_tissue_thickness_0");
  EXPECT_EQ(thickness->value(), 3);
  thickness->setFocus();
  thickness->selectAll();
  QTest::keyClicks(thickness, "2");
  QTest::keyClick(thickness, Qt::Key_Tab);
  thickness->setFocus();
  EXPECT_EQ(thickness->value(), 2);
  QTest::keySequence(thickness, QKeySequence::Undo);
  EXPECT_EQ(thickness->value(), 3) << "in the field of a number, too";
}

TEST_F(VariantDialogs, APartIsAddedWithItsValues) {
  dialog->draft().add_part(LessonPart::Kind::kObject, {{"name", "needle_2"}, {"plugin", "x.needle"}});
  ASSERT_NE(child<QDoubleSpinBox>("live_needle_2_size_0"), nullptr);
  EXPECT_EQ(child<QDoubleSpinBox>("live_needle_2_size_0")->value(), 5);
  set("live_needle_2_size_0", 4);
  EXPECT_EQ(child<QListWidget>("parts")->count(), 4);
  save();
  EXPECT_EQ(checked["objects"][2]["name"], "needle_2");
  EXPECT_EQ(checked["objects"][2]["params"]["size"], "4 mm");
}

TEST_F(VariantDialogs, APartThatBreaksTheLessonIsSaidAndNotWritten) {
  problem = "The lesson has no needle.";
  dialog->draft().remove_part("needle");
  QTRY_COMPARE(child<QLabel>("variant_problem")->text(), "▲ " + problem);
  save();
  EXPECT_FALSE(QFile::exists(dir.filePath("own")));
}

TEST_F(VariantDialogs, TheSceneIsBuiltAgainALittleAfterTheLastEdit) {
  QTRY_COMPARE(built, 1);
  for (const double mm : {1.5, 1.6, 1.7}) set("live_tissue_thickness_0", mm);
  EXPECT_EQ(built, 1) << "not per edit";
  QTRY_COMPARE(built, 2);
  EXPECT_EQ(checked["objects"][1]["params"]["thickness"], "1.7 mm");
}

// U5
TEST_F(VariantDialogs, WhatWasNotEndedIsTakenUpAgain) {
  set("live_tissue_thickness_0", 1.5);
  dialog->draft().remove_part("needle");
  dialog.reset();  // as when the program is killed: neither saved nor cancelled
  ASSERT_EQ(drafts().size(), 1);
  open();
  EXPECT_EQ(parts(), QStringList{"tissue"});
  EXPECT_EQ(child<QDoubleSpinBox>("live_tissue_thickness_0")->value(), 1.5);
  EXPECT_TRUE(child<QLabel>("variant_problem")->text().contains("unfinished"));
  undo();
  EXPECT_EQ(parts().size(), 3);
  EXPECT_EQ(child<QDoubleSpinBox>("live_tissue_thickness_0")->value(), 3);
}

TEST_F(VariantDialogs, AFormAsksWhatAPartIs) {
  const host::Catalogue known = catalogue();
  PartDialog coupling(LessonPart::Kind::kCoupling, dialog->draft(), known, nullptr);
  EXPECT_EQ(coupling.part(), nlohmann::ordered_json::parse(R"({"name":"pierce_2","plugin":"x.pierce","between":["needle","tissue"]})"));
  coupling.findChild<QComboBox*>("part_b")->setCurrentIndex(0);
  EXPECT_FALSE(coupling.findChild<QPushButton*>("part_add")->isEnabled()) << "nothing is bound to itself";
  PartDialog object(LessonPart::Kind::kObject, dialog->draft(), known, nullptr);
  EXPECT_EQ(object.findChild<QLineEdit*>("part_name")->text(), "needle_2");
  object.findChild<QLineEdit*>("part_name")->setText("tissue");
  EXPECT_FALSE(object.findChild<QPushButton*>("part_add")->isEnabled()) << "the name is taken";
  object.findChild<QLineEdit*>("part_name")->setText("other");
  object.findChild<QDoubleSpinBox*>("part_at_2")->setValue(2.5);
  EXPECT_EQ(object.part()["pose"]["p"][2], "2.5 mm");
  PartDialog device(LessonPart::Kind::kDevice, dialog->draft(), known, nullptr);
  EXPECT_EQ(device.part(), nlohmann::ordered_json::parse(R"({"name":"mouse","plugin":"x.mouse"})"));
  for (const PartDialog* form : {&coupling, &object, &device})
    for (const QLabel* label : form->findChildren<QLabel*>())
      EXPECT_TRUE(label->buddy() != nullptr || !label->text().contains('&')) << label->text().toStdString() << ": its key is written out";
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

TEST(LiveForms, AWordFindsValuesOfThatNameBeforePartsThatContainIt) {
  LiveForm form(nullptr, LiveForm::Of::kVariant);
  form.set_params({length("lesson", "way", "Hold within", 1e-3), length("holder", "length", "Jaw length", 6e-3)});
  const auto shown = [&](const char* name) { return !form.findChild<QWidget*>(QString::fromLatin1(name))->isHidden(); };
  EXPECT_TRUE(form.find("hold"));
  EXPECT_TRUE(shown("live_lesson_way_0"));
  EXPECT_FALSE(shown("live_holder_length_0")) << "holder is another word";
  EXPECT_TRUE(form.find("holder"));
  EXPECT_TRUE(shown("live_holder_length_0"));
  EXPECT_TRUE(form.find("JAW"));
  EXPECT_FALSE(shown("live_lesson_way_0"));
}

}  // namespace
}  // namespace swage::console
