// SPDX-License-Identifier: Apache-2.0
//
// The tree keeps its layers; and a tree that breaks every rule once is caught each time, for the right reason.
#include "layering.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "../../temp_folder.hpp"
#include "test_places.hpp"

namespace swage::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::filesystem::path kRoot = SWAGE_SOURCE_DIR;
const std::filesystem::path kBroken = kRoot / "tests/sdk/layering/broken_tree";

Layers layers() { return Layers::read(kRoot / "tests/sdk/layers.txt"); }

/// One line each, so that a failure can be read.
std::string lines(const std::vector<std::string>& all) {
  std::string text;
  for (const std::string& line : all) text += line + "\n";
  return text;
}

TEST(Layering, includes_follow_the_table) {
  const std::vector<std::string> found = include_violations(kRoot, layers());
  EXPECT_TRUE(found.empty()) << lines(found);
}

TEST(Layering, sources_carry_their_licence) {
  const std::vector<std::string> found = spdx_violations(kRoot);
  EXPECT_TRUE(found.empty()) << lines(found);
}

TEST(Layering, every_room_is_told_in_under_thirty_lines) {
  const std::vector<std::string> found = readme_violations(kRoot);
  EXPECT_TRUE(found.empty()) << lines(found);
}

TEST(Layering, files_are_short) {
  const std::vector<std::string> found = length_violations(kRoot);
  EXPECT_TRUE(found.empty()) << lines(found);
}

TEST(Words, that_gave_way_to_the_fields_do_not_come_back) {
  const std::vector<std::string> found = word_violations(kRoot, kRoot / "tests/sdk/former_words.txt");
  EXPECT_TRUE(found.empty()) << lines(found);
}

TEST(Words, that_come_back_are_found) {
  const TempFolder root;
  const std::filesystem::path top = root.path(), words = top / "words.txt";
  std::filesystem::create_directories(top / "console");
  std::ofstream(words) << "# why\ncode take_stand luggage\nscreen Way of the tips\n";
  std::ofstream(top / "console/page.cpp") << "int take_stand();\nint take_stands, mistake_stand;\n";
  std::ofstream(top / "console/words.json") << "{\n \"motion.path\": \"Way of the tips\", \"luggage\": 1 }\n";
  EXPECT_THAT(word_violations(top, words), ElementsAre("console/page.cpp:1: take_stand", "console/words.json:2: Way of the tips"));
  std::ofstream(words) << "take_stand\n";
  EXPECT_THROW(word_violations(top, words), std::runtime_error);
}

TEST(BrokenTree, long_files_are_found) {
  const TempFolder root;
  const std::filesystem::path scene = std::filesystem::path(root.path()) / "framework/scene";
  std::filesystem::create_directories(scene);
  const auto write = [&](const std::string& name, int n) {
    std::ofstream file(scene / name);
    for (int i = 0; i < n; ++i) file << "// " << i << "\n";
  };
  write("right.cpp", 400);
  write("long.hpp", 401);
  write("long.json", 1000);
  EXPECT_THAT(length_violations(root.path()),
              ElementsAre("framework/scene/long.hpp: 401 lines; a file has at most 400"));
}

TEST(BrokenTree, wrong_includes_are_found) {
  Layers table = layers();
  table.may["devices/pen"] = {"HD"};
  EXPECT_THAT(
      include_violations(kBroken, table),
      ElementsAre(
          "console/back_door.cpp:7: console may not include host (host/rig.hpp)",
          "console/back_door.cpp:8: console may not include step (step/step.hpp)",
          "framework/attic/unknown_room.cpp: layers.txt has no room \"attic\"",
          "framework/host/qt_below_console.cpp:2: host may not include Qt (QString)",
          "framework/host/qt_below_console.cpp:3: host may not include QtCore (QtCore/QObject)",
          "framework/judge/wrapper_in_a_room.cpp:2: judge may not include sdk (swage/object.hpp)",
          "framework/scene/looks_up.hpp:4: scene may not include host (host/rig.hpp)",
          "framework/scene/looks_up.hpp:5: scene does without <thread>",
          "framework/sdk/include/swage/abi/eigen_in_abi.h:3: sdk/abi may not include Eigen (Eigen/Core)",
          "plugins/needle/knows_too_much.cpp:4: plugins/needle may not include another folder by .. "
          "(../jaws/jaw.hpp)",
          "plugins/needle/knows_too_much.cpp:5: plugins/needle may not include plugins/jaws "
          "(plugins/jaws/jaw.hpp)",
          "plugins/needle/knows_too_much.cpp:6: plugins/needle may not include scene (scene/world.hpp)",
          "plugins/needle/knows_too_much.cpp:8: plugins/needle may not include plugins/jaws (jaws/jaw.hpp)"));
}

TEST(BrokenTree, a_library_is_for_those_who_were_given_it) {
  const std::vector<std::string> found = include_violations(kBroken, layers());
  EXPECT_THAT(found,
              testing::Contains("devices/pen/own_library.cpp:3: devices/pen may not include HD (HD/hd.h)"));
}

TEST(BrokenTree, missing_licences_are_found) {
  EXPECT_THAT(spdx_violations(kBroken),
              ElementsAre("plugins/jaws/no_spdx.hpp: no SPDX line", "scripts/no_spdx.sh: no SPDX line"));
}

TEST(BrokenTree, missing_and_long_readmes_are_found) {
  EXPECT_THAT(readme_violations(kBroken),
              ElementsAre("console: no README.md", "devices: no README.md", "framework/attic: no README.md",
                          "framework/sdk: no README.md", "plugins: no README.md", "scripts: no README.md",
                          "framework/judge/README.md: 30 lines; a room is told in under 30"));
}

TEST(Layers, an_unreadable_line_is_told) {
  const TempFolder folder;
  const std::filesystem::path file = folder / "layers.txt";
  std::ofstream(file) << "base:\nscene base\n";
  EXPECT_THROW(Layers::read(file), std::runtime_error);
  std::ofstream(file) << "scene always: base\n";
  EXPECT_THROW(Layers::read(file), std::runtime_error);
  EXPECT_THROW(Layers::read(file / "absent"), std::runtime_error);
}

}  // namespace
}  // namespace swage::test
