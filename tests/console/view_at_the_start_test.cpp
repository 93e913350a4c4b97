// SPDX-License-Identifier: Apache-2.0
//
// From where a lesson is looked at first: its key "view", or the view that was asked for.
#include <QListView>

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

}  // namespace
}  // namespace swage::test
