// SPDX-License-Identifier: Apache-2.0
#include "tools/print.hpp"

#include <gtest/gtest.h>

namespace swage::tools {
namespace {

TEST(Print, ANameIsSaidOnce) {
  testing::internal::CaptureStderr();
  tell(base::Severity::kError, "clip", "clip (org.example.clip 1.0.0) slept.");
  tell(base::Severity::kError, "clip", "clips nothing.");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "error: clip (org.example.clip 1.0.0) slept.\nerror: clip: clips nothing.\n");
}

TEST(Print, AQuantityIsToldInTheUnitOfItsScale) {
  EXPECT_EQ(quantity_text(0.0012, "m"), "1.2 mm");
  EXPECT_EQ(quantity_text(2e-6, "m"), "2 um");
  EXPECT_EQ(quantity_text(5.135e-12, "m"), "0 mm") << "two points that coincide";
  EXPECT_EQ(quantity_text(-1e-15, "rad"), "0 deg");
  EXPECT_EQ(quantity_text(0.5, "N"), "0.5 N");
  EXPECT_EQ(quantity_text(0.0042, "N"), "4.2 mN");
  EXPECT_EQ(quantity_text(3, "1"), "3");
  EXPECT_EQ(quantity_text(2.5e-7, "m2"), "0.25 mm2");
  EXPECT_EQ(quantity_text(2.5e-9, "m2"), "2500 um2");
  EXPECT_EQ(quantity_text(7.087e-22, "m2"), "0 mm2");
  EXPECT_EQ(quantity_text(0.02, "m/s"), "20 mm/s");
}

}  // namespace
}  // namespace swage::tools
