// SPDX-License-Identifier: Apache-2.0
//
// Whether a lesson of several tools can be led by one mouse.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "run_lesson.hpp"

namespace swage::stage {

/// Loads the lesson with a mouse as its only hand and runs a second of it. Reports failures to GoogleTest. [main]
inline void expect_one_mouse_leads(const std::string& lesson) {
  LessonRun mouse(lesson, "mouse");
  EXPECT_EQ(mouse.problems(), "");
  ASSERT_TRUE(mouse.ready());
  mouse.run(1);
  EXPECT_EQ(mouse.outcome(), "running");
  EXPECT_EQ(mouse.engine().quarantined(), 0u);
}

}  // namespace swage::stage
