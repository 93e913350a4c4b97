// SPDX-License-Identifier: Apache-2.0
#include "host/words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "../../temp_folder.hpp"
#include "host/sentences.hpp"

using namespace swage;
using namespace swage::host;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;
using testing::UnorderedElementsAre;

namespace {

struct Parsed {
  Words words;
  base::Problems problems;
  explicit Parsed(const std::string& text) { parse_words(text, "words.de.json", "de", words, problems); }
  std::string said() const { return problems.empty() ? "" : problems[0].where + ": " + problems[0].message; }
};

std::string file(const std::string& words) {
  return R"({ "format": "swage-words/1", "language": "de", "words": )" + words + " }";
}

TEST(Words, AreThoseOfTheFileAndTheFirstStays) {
  Parsed p(file(R"({ "Grasp it.": "Greifen.", "grasp.taken": "Gegriffen" })"));
  EXPECT_THAT(p.words, UnorderedElementsAre(Pair("Grasp it.", "Greifen."), Pair("grasp.taken", "Gegriffen")));
  parse_words(file(R"({ "Grasp it.": "Anders." })"), "more.de.json", "de", p.words, p.problems);
  EXPECT_EQ(p.words["Grasp it."], "Greifen.");
  EXPECT_EQ(p.said(), "");
}

TEST(Words, AWordThatWouldMisleadIsLeftOutAndTheOthersStay) {
  const Parsed p(file(R"({ "Hold it for {hold_time}.": "{hold} lang halten.", "A": "", "B": 3, "Lift it.": "Heben." })"));
  EXPECT_THAT(p.words, ElementsAre(Pair("Lift it.", "Heben.")));
  ASSERT_EQ(p.problems.size(), 3u);
  EXPECT_EQ(p.said(), "words.de.json #/words: " + say::kTranslation("Hold it for {hold_time}.", say::kOtherPlaces()));
  // the same places in another order are the same
  EXPECT_THAT(Parsed(file(R"({ "{a} of {b}": "von {b} {a}" })")).words, testing::SizeIs(1));
}

TEST(Words, AFileThatIsNoneIsNotUsedAndSaysWhy) {
  const std::pair<const char*, std::string> wrong[] = {
      {"{", say::kWordsNoJson()},
      {"[]", say::kWordsFormat("swage-words/1")},
      {R"({ "format": 1 })", say::kWordsFormat("swage-words/1")},
      {R"({ "format": "swage-words/1", "language": "fr", "words": {} })", say::kWordsLanguage("de")},
      {R"({ "format": "swage-words/1", "language": "de", "words": [] })", say::kWordsNone()}};
  for (const auto& [text, why] : wrong) {
    const Parsed p(text);
    EXPECT_THAT(p.words, IsEmpty()) << text;
    EXPECT_THAT(p.said(), HasSubstr(why)) << text;
  }
}

TEST(Words, LieInFilesOfTheirLanguageInTheOrderOfTheirNames) {
  const test::TempFolder folder;
  const auto put = [&](const std::string& name, const std::string& text) { std::ofstream(folder / name) << text; };
  put("words_b.de.json", file(R"({ "x y": "b" })"));
  put("words.de.json", file(R"({ "x y": "a" })"));
  put("words.fr.json", "{");
  put("lesson.de.json", "{");
  const auto files = word_files(folder.path(), "de");
  ASSERT_EQ(files.size(), 2u);
  Words words;
  base::Problems problems;
  for (const std::string& f : files) read_words(f, "de", words, problems);
  EXPECT_EQ(words["x y"], "a");
  EXPECT_THAT(problems, IsEmpty());
  read_words(folder / "none.de.json", "de", words, problems);
  EXPECT_EQ(problems.size(), 1u);
  EXPECT_THAT(word_files("/no/such/folder", "de"), IsEmpty());
}

TEST(Words, OfAPluginAreWhatPeopleSee) {
  PluginInfo plugin;
  plugin.kind = SWAGE_KIND_OBJECT;
  plugin.name = "Bent needle";
  plugin.summary = "It bends.";
  Param shown, hidden, file_name;
  shown.type = SWAGE_PARAM_CHOICE;
  shown.id = "arc";
  shown.label = "Arc";
  shown.doc = "How much of a circle.";
  shown.choices = {"straight", "3/8"};
  hidden = shown;
  hidden.doc = "Nobody sees this.";
  hidden.flags = SWAGE_PARAM_HIDDEN;
  file_name = shown;
  file_name.type = SWAGE_PARAM_FILE;
  file_name.doc = "A name of a file is in no form.";
  plugin.params = {shown, hidden, file_name};
  plugin.criteria = {{"Hold it.", "", SWAGE_CRITERION_PASS}};
  MetricInfo titled, plain;
  titled.id = "force.peak", titled.doc = "Greatest force.", titled.formula = "max F", titled.title = "Grip force, peak";
  plain.id = "x.y", plain.doc = "Greatest force.";
  plugin.metrics = {titled, plain};
  plugin.cues = {{"grasp.good", "Named by a theme.", SWAGE_CHANNEL_COLOUR, SWAGE_CUE_NEUTRAL},
                 {"clip.lost", "Shown by its id's words.", SWAGE_CHANNEL_COLOUR, SWAGE_CUE_BAD}};
  EXPECT_THAT(words_of(plugin), ElementsAre("Bent needle", "It bends.", "Arc", "How much of a circle.", "straight", "Hold it.", "Grip force, peak",
                                            "Greatest force.", "x.y", "clip.lost"));
  plugin.kind = SWAGE_KIND_LESSON;  // whose summary is in no list
  EXPECT_THAT(words_of(plugin), testing::Not(testing::Contains("It bends.")));
}

TEST(Words, OfASceneAndOfALessonAreWhatPeopleSee) {
  snapshot::SceneCard card;
  card.script.signals = {{"grasp", "grasp.force", "N", "The grip."}};
  card.script.events = {{"grasp", "grasp.taken", "N", "Both jaws hold it; value: the force."}, {"swage", "host.gap", "1", "steps were lost"}};
  card.script.phases = {{"lesson", "hold", "1", "Hold it."}};
  card.script.metrics = {{"lesson", "time.task", "s", "The time."}};
  EXPECT_THAT(words_of(card), ElementsAre("grasp.force", "The grip.", "grasp.taken", "Both jaws hold it", "Hold it.", "time.task", "The time."));
  const auto lesson = nlohmann::ordered_json::parse(R"({ "title": "A lesson", "reset": { "label": "Lay anew", "tip": "Undoes it" }, "objects": [ { "name": "needle" } ],
    "devices": [ { "name": "hand", "as": "mouse", "or": [ { "as": "expert" } ] } ], "couplings": [ { "plugin": "x" } ] })");
  EXPECT_THAT(words_of(lesson), ElementsAre("A lesson", "Lay anew", "Undoes it", "needle", "hand", "mouse", "expert"));
  EXPECT_THAT(words_of(nlohmann::ordered_json::array()), IsEmpty());
}

}  // namespace
