// SPDX-License-Identifier: Apache-2.0
//
// What the host says to a person, in German: every sentence of its catalogues that reaches the console is translated.
#include <QString>
#include <gtest/gtest.h>
#include <set>
#include <string>
#include <vector>

#include "base/solver_health.hpp"
#include "console/models/said.hpp"
#include "console/models/sentence_words.hpp"
#include "host/units.hpp"
#include "judge/pull_rule.hpp"
#include "sensor/sentences.hpp"
#include "sentence_catalogue.hpp"
#include "session/sentences.hpp"

namespace swage::test {
namespace {

// With values that no language has.
std::string filled(std::string text) {
  int n = 0;
  for (std::size_t at = text.find("{}"); at != text.npos; at = text.find("{}")) text.replace(at, 2, "Qx" + std::to_string(n++));
  return text;
}

// What only people see who write plugins or use the command line stays English.
const std::set<std::string> kOfAuthors = {
    "a table of parameters", "any declaration", "bodies, particles and hinges", "shapes", "descriptors of a library", "files of rating scales",
    "end of a plugin's test", "findings of the tests of a plugin", "marks of a lesson"};
const std::set<std::string> kOfTheCommandLine = {"kNotBackedUp", "kNotRestored", "kNothingLeft", "kServerNotSalvaged", "kThereAlready", "kNoHome",
                                                 "kNeedsNovice", "kSchoolNeedsLesson", "kSchoolNeedsPeople", "kSyntheticAlready"};
// signs, names and values alone
const std::set<std::string> kWithoutWords = {" ({})", "\"{}\", {}: {}", " \"{}\"", "In {}: {}", "Inverse3 {}{}{}"};

class HostSentences : public ::testing::Test {
 protected:
  void SetUp() override { console::set_words_language(QStringLiteral("de")); }
  void TearDown() override { console::set_words_language(QStringLiteral("en")); }
};

// The number of sentences of a catalogue that a person may see; each is German, and its values stay.
int all_german(const std::string& folder) {
  int seen = 0;
  const std::vector<CatalogueSentence> all = sentence_catalogue(folder);
  EXPECT_FALSE(all.empty()) << folder;
  for (const CatalogueSentence& s : all) {
    if (kOfAuthors.contains(s.section) || kOfTheCommandLine.contains(s.name) || kWithoutWords.contains(s.text)) continue;
    ++seen;
    const std::string message = filled(s.text), german = console::said_message(message).toStdString();
    EXPECT_NE(german, message) << folder << " " << s.name << ": no German";
    for (int i = 0; message.find("Qx" + std::to_string(i)) != message.npos; ++i)
      EXPECT_NE(german.find("Qx" + std::to_string(i)), german.npos) << s.name << ": " << german;
  }
  return seen;
}

// In console/translations/words_host.de.json.
TEST_F(HostSentences, EachThatReachesAPersonIsGerman) {
  EXPECT_TRUE(console::problems_of_words().empty()) << console::problems_of_words().front().message;
  int seen = 0;
  for (const char* room : {"session", "step", "toolkit", "host", "assembly", "record"}) seen += all_german(std::string("framework/") + room);
  EXPECT_GT(seen, 250);
  EXPECT_GT(all_german("devices/sensor"), 50) << "the calibration of a jaw sensor, which the window makes itself";
  for (const auto& field : base::kSolverHealthFields) EXPECT_NE(console::said(std::string(field.doc)).toStdString(), field.doc);
  for (const judge::PullMetric& m : judge::kPullMetrics)
    for (const char* text : {m.title, m.doc}) EXPECT_NE(console::said(std::string(text)).toStdString(), text);
  for (const char* dimension : {"a length", "a force", "an angle"}) EXPECT_NE(console::said(std::string(dimension)).toStdString(), dimension);
}

// In the words.de.json of each device. What a hand in a file lacks only its author sees.
TEST_F(HostSentences, EachOfADeviceIsGerman) {
  for (const char* device : {"gamepad", "inverse3", "jaw_sensor", "openhaptics", "openxr", "spacemouse", "tablet"}) {
    const std::string folder = std::string("devices/") + device;
    console::learn_words(QString::fromStdString(SWAGE_SOURCE_DIR "/" + folder));
    EXPECT_GT(all_german(folder), 3);
  }
}

// A calibration's file and its part are named before what is wrong there.
TEST_F(HostSentences, OfACalibrationFileThePathStays) {
  const std::string path = "/school/a: b.json";
  EXPECT_EQ(console::said_of_file(path, path + ": " + sensor::say::kInPart("force", sensor::say::kForceFalls("3 mm"))),
            "/school/a: b.json: In force: Die Kraft einer Krafttabelle fällt nie; bei 3 mm tut sie es.");
  EXPECT_EQ(console::said_of_file(path, sensor::say::kWhoCalibrates()), "Angeben, wer kalibriert.");
}

TEST_F(HostSentences, ValuesStayAndSentencesInThemAreTranslated) {
  EXPECT_EQ(console::said_message(session::say::kNoHand("left hand")), "Diese Lektion hat keine Hand namens \"left hand\".");
  const std::string live = session::say::kNotLive("needle.arc", "swage.object.needle", session::say::kLiveAre("wire"));
  EXPECT_EQ(console::said_message(live), "\"needle.arc\" von swage.object.needle kann sich nicht ändern, während die Szene läuft. Was es kann: wire.");
  // one after the other, and what nobody has translated
  EXPECT_EQ(console::said_message(session::say::kNoKnot() + " Ask Ada."), "Hier ist kein Knoten, der sich sicher lesen lässt: nichts wird gezogen. Ask Ada.");
  EXPECT_EQ(console::said_message("Ask Ada. Or Bob."), "Ask Ada. Or Bob.");
  EXPECT_EQ(console::said_message(""), "");
  // a name that is a word of the host's too stays as it is
  EXPECT_EQ(console::said_message(session::say::kNoHand("environment")), "Diese Lektion hat keine Hand namens \"environment\".");
}

TEST_F(HostSentences, EnglishStaysAsItIsWritten) {
  console::set_words_language(QStringLiteral("en"));
  EXPECT_EQ(console::said_message(session::say::kNoKnot()).toStdString(), session::say::kNoKnot());
}

TEST(SentenceWordsTest, OfSeveralThatFitTheOneWithMostLettersIsUsed) {
  const host::Words words = {{"{} is there.", "{} ist da."}, {"The {} is there.", "Das {} ist da."}, {"{}: {}; {}.", "{} - {} / {}!"}};
  const console::SentenceWords german(words);
  EXPECT_EQ(german.of("The cat is there."), "Das cat ist da.");
  EXPECT_EQ(german.of("Max is there."), "Max ist da.");
  EXPECT_EQ(german.of("a: b: c; d; e."), "a - b: c / d; e!");
  EXPECT_EQ(german.of("Nobody is here"), "");
}

}  // namespace
}  // namespace swage::test
