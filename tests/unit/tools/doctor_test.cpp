// SPDX-License-Identifier: Apache-2.0
#include "program.hpp"
#include "record/sentences.hpp"
#include "test_places.hpp"
#include "tools/sentences.hpp"

namespace swage::tools::test {
namespace {

using testing::HasSubstr;
using Doctor = Program;

nlohmann::json finding(const nlohmann::json& list, const std::string& name) {
  for (const auto& f : list)
    if (f["name"] == name) return f;
  ADD_FAILURE() << "no finding " << name;
  return {};
}

TEST_F(Doctor, LooksAtEverythingAndMakesNothing) {
  const Said said = swage({"doctor"});
  EXPECT_EQ(said.code, 0) << said.out;
  for (const char* name :
       {"scheduling", "memory", "processors", "graphics", "window", "plugins", "store", "disk"})
    EXPECT_THAT(said.out, HasSubstr(std::string("  ") + name + " "));
  EXPECT_THAT(said.out, HasSubstr("attempts.db" + say::kWillBeMade.words(1)));
  EXPECT_NE(access(path("data").c_str(), F_OK), 0);
}

TEST_F(Doctor, EveryLackHasARemedy) {
  const nlohmann::json list = swage({"doctor", "--json"}).json();
  for (const auto& f : list) EXPECT_EQ(f["state"] == "good", f["remedy"] == "") << f;
  EXPECT_EQ(finding(list, "graphics")["text"], say::kWithoutWindow());
}

TEST_F(Doctor, AStoreThatCannotBeIsBad) {
  write("letter.db", "Dear reader, this is a letter and not a database.");
  const Said said = swage({"doctor", "--store", path("letter.db"), "--json"});
  EXPECT_EQ(said.code, 2);
  const nlohmann::json store = finding(said.json(), "store");
  EXPECT_EQ(store["state"], "bad");
  EXPECT_THAT(store["text"].get<std::string>(), HasSubstr(record::say::kUnusable.words(1)));
  EXPECT_THAT(store["remedy"].get<std::string>(), HasSubstr("--store"));
}

TEST_F(Doctor, RefusedAndShadowedPluginsAreNamed) {
  const std::string bundle = std::string(SWAGE_BINARY_DIR) + "/plugins/swage.object.needle";
  write("broken.so", "this is no library");
  const Said said = swage({"doctor", "--plugin-dir", path(""), "--plugin-dir", bundle});
  EXPECT_EQ(said.code, 0);
  EXPECT_THAT(said.out, HasSubstr("broken.so" + say::kRefused.words(1)));
  EXPECT_THAT(said.out, HasSubstr(say::kRebuild()));
  EXPECT_THAT(said.out, HasSubstr("plugin swage.object.needle"));
  EXPECT_THAT(said.out, HasSubstr(say::kHidden.words(2)));
}

}  // namespace
}  // namespace swage::tools::test
