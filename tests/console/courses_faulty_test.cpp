// SPDX-License-Identifier: Apache-2.0
//
// A lesson with a fault on the Courses page.
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QListWidget>

#include "window_fixture.hpp"

namespace swage::test {
namespace {

class FaultyLesson : public WindowTest {
 protected:
  void SetUp() override { with_school = true; }
  std::vector<record::Course> courses() {
    std::string error;
    return record::School::open(school_file(), error)->courses();
  }
};

TEST_F(FaultyLesson, IsListedAsFaultyAndIsNotAdded) {
  QFile file(dir.filePath("broken.json"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(R"({"format": "swage-lesson/1", "id": "test.broken"})");  // lacks the mandatory title
  file.close();
  launch.options.lesson_path = file.fileName().toStdString();
  open();
  click("page_courses");
  click("first_course");
  auto* choice = child<QComboBox>("add_lesson_choice");
  const int faulty = choice->findText(QStringLiteral("▲ faulty: broken"));
  ASSERT_GE(faulty, 0);
  EXPECT_FALSE(choice->model()->flags(choice->model()->index(faulty, 0)).testFlag(Qt::ItemIsEnabled));
  EXPECT_TRUE(choice->itemData(faulty, Qt::ToolTipRole).toString().contains("title"));
  EXPECT_NE(choice->currentIndex(), faulty) << "a lesson that can be added is offered first";
  choice->setCurrentIndex(faulty);
  click("add_lesson");
  EXPECT_TRUE(courses()[0].steps.empty());
  EXPECT_TRUE(child<QLabel>("course_problem")->text().contains("broken.json"));
  choice->setCurrentIndex(choice->findData(QStringLiteral("test.grasp")));
  click("add_lesson");
  ASSERT_EQ(courses()[0].steps.size(), 1u);
  EXPECT_EQ(courses()[0].steps[0].lesson_id, "test.grasp");
  EXPECT_NE(choice->currentIndex(), faulty);
}

// Why a lesson of a course cannot be done stands under its name.
TEST_F(FaultyLesson, SaysInTheCourseWhatIsWrongWithIt) {
  QFile file(dir.filePath("broken.json"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(R"({"format": "swage-lesson/1", "id": "test.broken"})");
  file.close();
  launch.options.lesson_path = file.fileName().toStdString();
  std::string error;
  record::Course course;
  course.title = "Spring";
  for (const char* lesson : {"test.grasp", "test.broken", "test.gone"}) course.steps.emplace_back().lesson_id = lesson;
  ASSERT_TRUE(record::School::open(school_file(), error)->save_course(course)) << error;
  open();
  click("page_courses");
  auto* steps = child<QListWidget>("steps");
  const auto* fault = child<QLabel>("step_fault");
  ASSERT_EQ(steps->count(), 3);
  EXPECT_FALSE(fault->isVisible());
  steps->setCurrentRow(1);
  EXPECT_TRUE(fault->isVisible());
  EXPECT_TRUE(fault->text().contains("title")) << fault->text().toStdString();
  steps->setCurrentRow(2);
  EXPECT_TRUE(fault->text().contains("not installed")) << fault->text().toStdString();
}

}  // namespace
}  // namespace swage::test
