// SPDX-License-Identifier: Apache-2.0
//
// The lesson that is chosen: from where it is looked at first, its key "view" or the view that was asked for, and its row in the list.
#include <QListView>
#include <algorithm>

#include "window_fixture.hpp"

namespace swage::test {
namespace {

class ViewAtTheStart : public WindowTest {
 protected:
  bool is_from_above() {
    page()->view()->camera().jump();
    return page()->view()->camera().up().z() < 0.5F;
  }
};

TEST_F(ViewAtTheStart, ALessonSaysFromWhereItIsLookedAtFirst) {
  script.view = "top";
  open();
  ASSERT_TRUE(wait_for_preview());
  EXPECT_TRUE(is_from_above());
  page()->look(console::CameraPreset::kSide);
  EXPECT_FALSE(is_from_above()) << "any other may be chosen";
  auto* lessons = child<QListView>("lessons");
  lessons->setCurrentIndex(lessons->model()->index(1, 0));
  EXPECT_TRUE(eventually([this] { return is_from_above(); }));
}

TEST_F(ViewAtTheStart, AViewThatWasAskedForStaysWithTheFirstLesson) {
  script.view = "top";
  launch.view = "orbit";
  open();
  ASSERT_TRUE(wait_for_preview());
  EXPECT_FALSE(is_from_above());
}

class ChosenLesson : public WindowTest {};

// The row of the chosen lesson was cut off by the lower edge of its list.
TEST_F(ChosenLesson, TheChosenLessonStaysInSightWhereTheListGetsLow) {
  launch.lesson_folders = {QStringLiteral(SWAGE_SOURCE_DIR "/lessons/series")};
  open();
  window->resize(1440, 900);
  auto* list = child<QListView>("lessons");
  ASSERT_GT(list->model()->rowCount(), 20);
  list->setCurrentIndex(list->model()->index(list->model()->rowCount() - 5, 0));
  for (const int height : {900, 700, 600, 800}) {
    window->resize(1024, height);
    ASSERT_TRUE(eventually([&] { return window->height() == std::max(height, window->minimumHeight()); }));
    EXPECT_TRUE(eventually([&] { return list->viewport()->rect().contains(list->visualRect(list->currentIndex())); })) << height;
  }
}

}  // namespace
}  // namespace swage::test
