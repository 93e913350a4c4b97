// SPDX-License-Identifier: Apache-2.0
//
// A stack of pages has the height of the page that is shown.
#include <gtest/gtest.h>

#include <QStackedWidget>
#include <QVBoxLayout>
#include <utility>

#include "console/widgets/parts.hpp"
#include "window_fixture.hpp"

namespace swage::console {
namespace {

using StackOfPages = swage::test::WindowTest;

// The readings of the next attempt have the height of the window again, and no scroll bar.
TEST_F(StackOfPages, ALongResultLeavesTheNextReadingsTheirHeight) {
  QStackedWidget stack;
  auto* readings = new QWidget(&stack);
  auto* result = new QWidget(&stack);
  readings->setLayout(new QVBoxLayout);
  result->setLayout(new QVBoxLayout);
  for (const auto& [page, height] : {std::pair{readings, 300}, std::pair{result, 900}}) {
    auto* content = new QWidget(page);
    content->setMinimumHeight(height);
    page->layout()->addWidget(content);
    stack.addWidget(page);
  }
  size_as_shown(&stack);
  EXPECT_LT(stack.minimumSizeHint().height(), 400);
  stack.setCurrentWidget(result);
  EXPECT_GE(stack.minimumSizeHint().height(), 900);
  stack.setCurrentWidget(readings);
  EXPECT_LT(stack.minimumSizeHint().height(), 400);
}

}  // namespace
}  // namespace swage::console
