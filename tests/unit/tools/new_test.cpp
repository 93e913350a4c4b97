// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <fstream>

#include "host/nearest.hpp"
#include "program.hpp"
#include "tools/sentences.hpp"

namespace swage::tools::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;
using New = Program;

std::string slurp(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST_F(New, EveryKindLosesItsTokens) {
  for (const std::string kind : {"object", "flexible", "coupling", "device", "hardware", "lesson"}) {
    const fs::path folder = path(kind);
    const Said said = swage({"new", kind, "org.example.fine_clip", "--dir", folder.string()});
    ASSERT_EQ(said.code, 0) << said.err;
    EXPECT_THAT(said.out, HasSubstr("Next: read " + (folder / "README.md").string()));
    const size_t guide = said.out.find("Guide: ");
    ASSERT_NE(guide, std::string::npos) << said.out;
    EXPECT_TRUE(fs::is_regular_file(said.out.substr(guide + 7, said.out.find('\n', guide) - guide - 7))) << said.out;
    EXPECT_THAT(slurp(folder / "fine_clip.hpp") + slurp(folder / "fine_clip.cpp"),
                HasSubstr("org.example.fine_clip"));
    EXPECT_THAT(slurp(folder / "fine_clip.hpp") + slurp(folder / "fine_clip.cpp"), HasSubstr("FineClip"));
    EXPECT_THAT(slurp(folder / "fine_clip.hpp"), HasSubstr("auto name = \"Fine clip\";"));
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      EXPECT_THAT(entry.path().filename().string(), Not(HasSubstr("@")));
      if (!entry.is_regular_file()) continue;
      for (const char* token : {"@ID@", "@NAME@", "@TITLE@", "@FILE@"})
        EXPECT_THAT(slurp(entry.path()), Not(HasSubstr(token))) << entry.path();
    }
  }
}

TEST_F(New, TheClassMayHaveAnotherName) {
  ASSERT_EQ(swage({"new", "object", "org.example.clip", "--dir", path("c"), "--name", "Aneurysm"}).code, 0);
  EXPECT_THAT(slurp(path("c/clip.hpp")), HasSubstr("class Aneurysm "));
}

TEST_F(New, SaysWhatIsWrong) {
  const auto expect = [&](const std::vector<std::string>& arguments, const std::string& sentence) {
    const Said said = swage(arguments);
    EXPECT_EQ(said.code, 2);
    EXPECT_THAT(said.err, HasSubstr(sentence));
  };
  expect({"new", "objekt", "org.example.clip"},
         say::kNoTemplate("objekt", "object, flexible, coupling, device, hardware, lesson", host::did_you_mean("objekt", {"object"})));
  for (const char* id :
       {"clip", "org.Example.clip", "org..clip", "org.example.", "org.example.9clip", "org.ex-ample.clip"})
    expect({"new", "object", id}, say::kNoId(id));
  expect({"new", "object", "swage.object.clip"}, say::kOwnDomain("clip"));
  expect({"new", "object", "org.example.clip", "--name", "my clip"}, say::kNoClass("my clip"));
  write("there", "something");
  expect({"new", "object", "org.example.clip", "--dir", path("there")}, say::kNotEmpty(path("there")));
  expect({"new", "object", "org.example.clip", "--dir", "/proc/clip"}, say::kNoPlace.words(1));
}

}  // namespace
}  // namespace swage::tools::test
