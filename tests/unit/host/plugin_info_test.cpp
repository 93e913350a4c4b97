// SPDX-License-Identifier: Apache-2.0
#include "host/plugin_info.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "../../temp_folder.hpp"
#include "host/sentences.hpp"

using namespace swage::host;
using testing::ElementsAre;
using testing::IsEmpty;

namespace {

PluginInfo clip() {
  PluginInfo plugin;
  plugin.kind = SWAGE_KIND_OBJECT;
  plugin.id = "org.example.clip";
  plugin.version = "1.2.0";
  plugin.name = "Clip";
  plugin.summary = "Rigid clip.";
  plugin.author = "Example";
  plugin.licence = "Apache-2.0";
  plugin.traits = {"swage.trait.solid/1"};
  plugin.abi_major = 1;
  return plugin;
}

}  // namespace

TEST(PluginInfo, FaultsOfADescriptor) {
  EXPECT_THAT(plugin_faults(clip()), IsEmpty());
  PluginInfo bad = clip();
  bad.kind = SWAGE_KIND_DEVICE;
  bad.id = "Clip";
  bad.version = "v1";
  bad.summary = "";
  EXPECT_THAT(plugin_faults(bad),
              ElementsAre(say::kNoId("Clip"),
                          say::kNoVersion("v1"),
                          say::kTraitsOfObjects(), say::kHasNoText("summary")));
}

TEST(PluginInfo, IdsAreReverseDomains) {
  for (const char* id :
       {"clip", "org..clip", "org.clip.", ".org.clip", "org.Clip", "org.1clip", "org.my-clip", ""}) {
    PluginInfo bad = clip();
    bad.id = id;
    EXPECT_EQ(plugin_faults(bad).size(), 1u) << id;
  }
}

TEST(PluginInfo, TheSidecarSaysTheSame) {
  std::string hash, error;
  std::vector<PluginInfo> back;
  const std::string text = write_sidecar("/somewhere/clip.so", "0123", {clip()});
  ASSERT_TRUE(read_sidecar(text, hash, back, error)) << error;
  EXPECT_EQ(hash, "0123");
  ASSERT_EQ(back.size(), 1u);
  EXPECT_EQ(write_sidecar("/elsewhere/clip.so", "0123", back), text);
}

// a text without roles was written before cues had one, and stays as it was
TEST(PluginInfo, TheRoleOfACueIsKeptAndAnUnknownOneIsTold) {
  PluginInfo lesson = clip();
  lesson.kind = SWAGE_KIND_LESSON;
  lesson.traits.clear();
  lesson.cues = {{"clip.open", "It is open.", SWAGE_CHANNEL_COLOUR, SWAGE_CUE_NEUTRAL},
                 {"clip.lost", "It has fallen.", SWAGE_CHANNEL_COLOUR, SWAGE_CUE_BAD}};
  EXPECT_THAT(plugin_faults(lesson), IsEmpty());
  const std::string text = write_sidecar("/somewhere/clip.so", "0123", {lesson});
  EXPECT_EQ(text.find("role"), text.rfind("role")) << text;
  std::string hash, error;
  std::vector<PluginInfo> back;
  ASSERT_TRUE(read_sidecar(text, hash, back, error)) << error;
  ASSERT_EQ(back.size(), 1u);
  ASSERT_EQ(back[0].cues.size(), 2u);
  EXPECT_EQ(back[0].cues[0].role, SWAGE_CUE_NEUTRAL);
  EXPECT_EQ(back[0].cues[1].role, SWAGE_CUE_BAD);
  EXPECT_STREQ(cue_role_text(SWAGE_CUE_WARNING), "warning");
  lesson.cues[1].role = 5;
  EXPECT_THAT(plugin_faults(lesson), ElementsAre(say::kNoCueRole("clip.lost", 5)));
}

TEST(PluginInfo, RefusesWhatIsNoSidecar) {
  std::string hash, error;
  std::vector<PluginInfo> back;
  for (const char* text : {"", "{", "[]", "{}", R"({"format": "swage-plugin/2"})",
                           R"({"format": "swage-plugin/1", "hash": 3, "plugins": []})"}) {
    EXPECT_FALSE(read_sidecar(text, hash, back, error)) << text;
    EXPECT_THAT(error, testing::StartsWith(say::kOtherFile("swage-plugin/1", "")));
  }
}

TEST(PluginInfo, TheHashIsThatOfTheContent) {
  const swage::test::TempFolder folder;
  const std::string a = folder / "a", b = folder / "b";
  std::ofstream(a) << std::string(100'000, 'x');
  std::ofstream(b) << std::string(100'000, 'x');
  EXPECT_EQ(content_hash(a), content_hash(b));
  EXPECT_EQ(content_hash(a).size(), 16u);
  std::ofstream(b) << std::string(99'999, 'x') << 'y';
  EXPECT_NE(content_hash(a), content_hash(b));
  EXPECT_EQ(content_hash("/there/is/no/such/file"), "");
}
