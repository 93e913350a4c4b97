// SPDX-License-Identifier: Apache-2.0
//
// The layout as a C++ compiler sees it, and that no struct has been forgotten.
#include <gtest/gtest.h>
#include <swage/abi/band.h>
#include <swage/abi/calibration.h>
#include <swage/abi/coupling.h>
#include <swage/abi/cut.h>
#include <swage/abi/device.h>
#include <swage/abi/device_signals.h>
#include <swage/abi/display.h>
#include <swage/abi/environment.h>
#include <swage/abi/lesson.h>
#include <swage/abi/lesson_card.h>
#include <swage/abi/object.h>
#include <swage/abi/sight.h>
#include <swage/abi/strand.h>
#include <swage/abi/visual.h>
#include <swage/abi/wire.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

extern "C" int swage_layout_holds_in_c(void);

namespace {

/// "typedef struct swage_pose {" and "struct swage_host {" -> the name; "" for any other line.
std::string defined_struct(const std::string& line) {
  const size_t at = line.find("struct swage_");
  const size_t brace = line.find(" {");
  const bool starts = at == 0 || (at == 8 && line.starts_with("typedef "));
  return starts && brace != std::string::npos ? line.substr(at + 7, brace - at - 7) : "";
}

TEST(Layout, sizes_and_offsets_are_as_released) {
  EXPECT_EQ(swage_layout_holds_in_c(), 1);
#define SWAGE_SIZE(type, bytes) EXPECT_EQ(sizeof(type), size_t{bytes}) << #type;
#define SWAGE_OFFSET(type, member, bytes) \
  EXPECT_EQ(offsetof(type, member), size_t{bytes}) << #type "." #member;
#include "layout.inc"
#include "test_places.hpp"
#undef SWAGE_SIZE
#undef SWAGE_OFFSET
}

TEST(Layout, every_struct_of_the_boundary_is_frozen) {
  std::set<std::string> frozen;
#define SWAGE_SIZE(type, bytes) frozen.insert(#type);
#define SWAGE_OFFSET(type, member, bytes)
#include "layout.inc"
  size_t found = 0;
  for (const auto& file :
       std::filesystem::directory_iterator(SWAGE_SOURCE_DIR "/framework/sdk/include/swage/abi")) {
    std::ifstream in(file.path());
    for (std::string line; std::getline(in, line);) {
      const std::string name = defined_struct(line);
      if (name.empty()) continue;
      ++found;
      EXPECT_TRUE(frozen.contains(name)) << name << " has no lines in layout.inc";
    }
  }
  EXPECT_EQ(found, frozen.size()) << "layout.inc and the headers name different structs";
}

}  // namespace
