// SPDX-License-Identifier: Apache-2.0
//
// Everything that stock lessons, plugins and devices say to people has a German translation beside it, and no translation is of
// something that nobody says any more. What a scene says is asked of the scene: sentences may be made when it is built.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>

#include "assembly/lesson_text.hpp"
#include "host/catalogue.hpp"
#include "host/device_signals.hpp"
#include "host/library.hpp"
#include "host/words.hpp"
#include "judge/host_events.hpp"
#include "run_lesson.hpp"
#include "sentence_catalogue.hpp"
#include "test_places.hpp"

namespace swage::stage {
namespace {

const std::string kSeries = SWAGE_SOURCE_DIR "/lessons/series";

host::Words words_in(const std::string& folder, const std::string& language = "de") {
  host::Words out;
  base::Problems problems;
  for (const std::string& file : host::word_files(folder, language)) host::read_words(file, language, out, problems);
  for (const base::Problem& p : problems) ADD_FAILURE() << p.where << ": " << p.message;
  return out;
}

std::string untranslated(const std::vector<std::string>& said, const host::Words& known) {
  std::string out;
  for (const std::string& w : said)
    if (known.find(w) == known.end()) out += "\n  \"" + w + "\"";
  return out;
}

const host::Catalogue& stock() {
  static const host::Catalogue one([] {
    host::Catalogue::Options options;
    options.plugin_dirs = {SWAGE_BINARY_DIR "/plugins"};
    options.use_environment = false;
    return options;
  }());
  return one;
}

/// Of all lessons, and what each plugin may add.
struct Stock {
  host::Words known;              // translations of the series and of all plugins
  std::set<std::string> said;
};

void add(const std::vector<std::string>& words, Stock& out) { out.said.insert(words.begin(), words.end()); }

/// What a device tells of itself, asked of one that is made and not opened.
std::vector<std::string> told_by(const host::PluginInfo& p) {
  std::vector<std::string> out;
  if (p.kind != SWAGE_KIND_DEVICE) return out;
  std::string error;
  const host::Library* library = stock().load(p, error);
  const auto instance = library != nullptr ? host::Instance::create(p, *library, "asked", {}, scene::kNone, 1, error) : nullptr;
  if (!instance) return ADD_FAILURE() << error, out;
  const host::DeviceSignals signals(*instance, error);
  EXPECT_EQ(error, "");
  for (uint32_t i = 0; i < signals.count(); ++i) {
    out.push_back(signals.signal(i).id);
    out.push_back(signals.signal(i).doc);
  }
  return out;
}

Stock collect() {
  Stock out;
  out.known = words_in(kSeries);
  for (const host::PluginInfo& p : stock().plugins()) {
    if (!p.id.starts_with("swage.")) continue;  // those of tests lie beside them
    const host::Words own = words_in(p.bundle_dir);
    EXPECT_EQ(untranslated(host::words_of(p), own), "") << "\nof " << p.id << " is in no words*.de.json of its bundle";
    EXPECT_EQ(untranslated(told_by(p), own), "") << "\nof " << p.id << " is in no words*.de.json of its bundle";
    add(host::words_of(p), out);
    add(told_by(p), out);
    out.known.insert(own.begin(), own.end());
  }
  return out;
}

// What is said only in scenes of other lessons: tissue with a slit whose edges are drawn; knots with instruments of other names.
const std::vector<std::string> kOfNoStockLesson = {"tissue.gap", "Width of the slit as its edges are drawn now; 0: they meet.",
                                                   "Take the thread with one instrument.", "Take the long end of the thread with one instrument.",
                                                   "Wind it about the tips of the other.", "Take the tail with that one."};

/// The messages of devices to people: what is missing, where, and what to do.
std::vector<std::string> told_by_devices() {
  std::vector<std::string> out;
  for (const auto& entry : std::filesystem::directory_iterator(SWAGE_SOURCE_DIR "/devices"))
    for (const test::CatalogueSentence& s : test::sentence_catalogue("devices/" + entry.path().filename().string())) out.push_back(s.text);
  return out;
}

/// A lesson of the series: what its file and its scene say, and the events of its couplings and its judge.
struct Lesson {
  std::string path;
  std::vector<std::string> said, events;
};

/// Each scene is built once for all tests.
const std::vector<Lesson>& series() {
  static const std::vector<Lesson> all = [] {
    std::vector<Lesson> out;
    for (const auto& entry : std::filesystem::directory_iterator(kSeries)) {
      if (entry.path().extension() != ".json") continue;
      assembly::LessonText text;
      base::Problems problems;
      EXPECT_TRUE(assembly::read_lesson_text(entry.path(), {}, text, problems));
      const LessonRun run(entry.path(), std::string());
      EXPECT_TRUE(run.ready()) << run.problems();
      if (!run.ready()) continue;
      Lesson lesson{entry.path(), host::words_of(text.json), {}};
      for (const std::string& w : host::words_of(run.rig().card)) lesson.said.push_back(w);
      for (const judge::Name& event : run.rig().card.script.events)
        if (event.owner != judge::kHostOwner) lesson.events.push_back(event.id);
      out.push_back(std::move(lesson));
    }
    return out;
  }();
  return all;
}

TEST(StockWords, AreAllGermanAndNoneIsLeftOver) {
  Stock all = collect();
  add(kOfNoStockLesson, all);
  add(told_by_devices(), all);
  ASSERT_GT(all.known.size(), 700u);
  for (const Lesson& lesson : series()) {
    EXPECT_EQ(untranslated(lesson.said, all.known), "") << "\nof " << lesson.path << " has no translation";
    add(lesson.said, all);
  }
  EXPECT_GE(series().size(), 28u);
  for (const auto& [english, german] : all.known)
    EXPECT_TRUE(all.said.contains(english)) << "\"" << english << "\" is translated, but nobody says it";
}

// A person reads "Wound tears" in the timeline, and not the id made readable. All files of one id say the same: the window knows one.
TEST(StockWords, EveryEventHasAnEnglishName) {
  host::Words names;
  std::set<std::string> events = {"cut.parted"};  // of no stock lesson
  for (const Lesson& lesson : series()) events.insert(lesson.events.begin(), lesson.events.end());
  ASSERT_GT(events.size(), 50u);
  for (const host::PluginInfo& p : stock().plugins()) {
    for (const auto& [id, name] : words_in(p.bundle_dir, "en")) {
      EXPECT_TRUE(events.contains(id)) << p.id << ": " << id << " is named, but nobody tells of it";
      EXPECT_EQ(names.emplace(id, name).first->second, name) << p.id << ": " << id << " has another name in another plugin";
      EXPECT_LE(name.size(), 31u) << name << " is cut off in the column of the list";
    }
  }
  EXPECT_EQ(untranslated({events.begin(), events.end()}, names), "");
}

// Red and green are the same to some, and another theme has other colours.
TEST(StockWords, NameNoColour) {
  const std::regex colour(R"(\b(red|green|blue|yellow|pink|white|black|orange)\b)", std::regex::icase);
  Stock all = collect();
  for (const Lesson& lesson : series()) add(lesson.said, all);
  ASSERT_GT(all.said.size(), 700u);
  for (const std::string& words : all.said) EXPECT_FALSE(std::regex_search(words, colour)) << words;
}

TEST(StockWords, AWordThatIsMissingIsNamed) {
  EXPECT_EQ(untranslated({"Lift it.", "Hold it."}, {{"Lift it.", "Heben."}}), "\n  \"Hold it.\"");
}

// Versions have a point in any language.
std::string without_versions(std::string text) {
  for (const std::string version : {"OpenHaptics 3.4", "OpenHaptics 3.0", "libsdl2-2.0-0"})
    for (size_t at = text.find(version); at != std::string::npos; at = text.find(version)) text.erase(at, version.size());
  return text;
}

// Units, places for values and full stops are those of the source; a German decimal number has a comma.
TEST(StockWords, TranslationsEndAsTheirSource) {
  for (const auto& [english, german] : collect().known) {
    EXPECT_EQ(english.ends_with('.'), german.ends_with('.')) << english << " -> " << german;
    // a sentence that is put behind another begins with the space between them
    EXPECT_EQ(english.starts_with(' '), german.starts_with(' ')) << english;
    EXPECT_FALSE(german.ends_with(' ')) << english;
    const std::string plain = without_versions(german);
    for (size_t at = plain.find('.'); at != std::string::npos && at + 1 < plain.size(); at = plain.find('.', at + 1))
      EXPECT_FALSE(at > 0 && isdigit(static_cast<unsigned char>(plain[at - 1])) && isdigit(static_cast<unsigned char>(plain[at + 1])))
          << german << ": a number with a decimal point";
  }
}

}  // namespace
}  // namespace swage::stage
