// SPDX-License-Identifier: Apache-2.0
#include "host/rating_scales.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "../../temp_folder.hpp"
#include "host/sentences.hpp"
#include "test_places.hpp"

namespace swage::host {
namespace {

using testing::HasSubstr;

const std::string kGood = R"({"format": "swage-scale/1", "id": "s", "title": {"en": "Scale", "de": "Skala"}, "source": "a book",
  "lowest_points": 1, "highest_points": 5, "items": [{"id": "i", "title": {"en": "Item"},
  "metrics": [{"id": "stitch.obliquity", "best": "0 deg", "worst": "30 deg"}]}]})";

std::string with(const std::string& from, const std::string& to) {
  std::string text = kGood;
  const size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return text.replace(place, from.size(), to);
}

TEST(RatingScales, AreReadInSiUnits) {
  judge::RatingScale scale;
  std::string error;
  ASSERT_TRUE(read_rating_scale(kGood, scale, error)) << error;
  EXPECT_EQ(scale.id, "s");
  EXPECT_EQ(judge::said_in(scale.title, "de"), "Skala");
  ASSERT_EQ(scale.items.size(), 1u);
  EXPECT_EQ(scale.items[0].by[0].unit, "rad");
  EXPECT_NEAR(scale.items[0].by[0].worst, M_PI / 6, 1e-12);
}

TEST(RatingScales, ASourceIsOneTextOrOneForEachLanguage) {
  judge::RatingScale scale;
  std::string error;
  ASSERT_TRUE(read_rating_scale(kGood, scale, error)) << error;
  EXPECT_EQ(judge::said_in(scale.source, "de"), "a book") << "a single text counts in each language";
  ASSERT_TRUE(read_rating_scale(with("\"a book\"", R"({"en": "a book", "de": "ein Buch"})"), scale, error)) << error;
  EXPECT_EQ(judge::said_in(scale.source, "en"), "a book");
  EXPECT_EQ(judge::said_in(scale.source, "de"), "ein Buch");
  EXPECT_FALSE(read_rating_scale(with("\"a book\"", R"({"de": "ein Buch"})"), scale, error));
  EXPECT_THAT(error, HasSubstr("the source of the scale"));
}

TEST(RatingScales, EachFaultHasItsSentence) {
  const std::pair<std::string, std::string> faults[] = {
      {"{", "parse error"},
      {"[]", say::kIsNoObject.words(1)},
      {with("swage-scale/1", "swage-scale/9"), say::kScaleFormat("swage-scale/1")},
      {with("\"source\"", "\"sauce\""), say::kUnknownKey.words(1) + "sauce"},
      {with("\"a book\"", "\"\""), say::kEmptyKey.words(2)},
      {with("\"highest_points\": 5", "\"highest_points\": 1"), say::kNotBelow()},
      {with("\"lowest_points\": 1", "\"lowest_points\": \"1\""), say::kNoNumberKey.words(1) + "lowest_points"},
      {with("\"en\": \"Item\"", "\"de\": \"Item\""), say::kNoKey.words(1) + "en"},
      {with("\"lowest_points\"", "\"needs\": [1], \"lowest_points\""), "\"needs\""},
      {with("\"metrics\"", "\"product\": 1, \"metrics\""), "\"product\""},
      {with("\"30 deg\"", "\"30 mm\""), say::kUnlikeUnits.words(1)},
      {with("\"30 deg\"", "\"0 deg\""), say::kSameEnds.words(1)},
      {with("\"30 deg\"", "\"steep\""), "worst"},
      {with("\"30 deg\"", "30"), say::kOtherKind.words(2) + "text"},
      {with("{\"id\": \"i\"", "{\"id\": \"i\", \"title\": {\"en\": \"Item\"}, \"metrics\": []}, {\"id\": \"i\""), say::kSameItem("i")},
  };
  for (const auto& [text, sentence] : faults) {
    judge::RatingScale scale;
    std::string error;
    EXPECT_FALSE(read_rating_scale(text, scale, error)) << text;
    EXPECT_THAT(error, HasSubstr(sentence)) << text;
  }
}

TEST(RatingScales, AFaultyFileIsLeftOutAndTold) {
  const test::TempFolder folder;
  std::ofstream(folder / "a.json") << kGood;
  std::ofstream(folder / "b.json") << "{";
  std::ofstream(folder / "c.txt") << "no scale";
  std::vector<std::string> errors;
  EXPECT_EQ(rating_scales(folder.path(), errors).size(), 1u);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_THAT(errors[0], HasSubstr("b.json"));
}

TEST(RatingScales, OnesOwnComeFromTheHomeFolder) {
  const test::TempFolder folder;
  std::filesystem::create_directories(folder / "swage/scales");
  std::ofstream(folder / "swage/scales/own.json") << kGood;
  const char* before = std::getenv("XDG_DATA_HOME");
  const std::string kept = before != nullptr ? before : "";
  setenv("XDG_DATA_HOME", folder.path().c_str(), 1);
  std::vector<judge::RatingScale> scales;
  std::vector<std::string> errors;
  add_own_scales(scales, errors);
  ASSERT_EQ(scales.size(), 1u);
  EXPECT_EQ(scales[0].id, "s");
  add_own_scales(scales, errors);
  before != nullptr ? setenv("XDG_DATA_HOME", kept.c_str(), 1) : unsetenv("XDG_DATA_HOME");
  EXPECT_EQ(scales.size(), 1u);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_THAT(errors[0], HasSubstr(say::kSameScale("s")));
}

// An attempt that failed with a wound of 301 %, without a stray touch: of lost points nothing is told.
TEST(RatingScales, ATornWoundIsNoRespectForTissue) {
  std::vector<std::string> errors;
  const auto scales = rating_scales(SWAGE_SOURCE_DIR "/resources/scales", errors);
  const auto smart = std::find_if(scales.begin(), scales.end(), [](const judge::RatingScale& s) { return s.id == "smart"; });
  ASSERT_NE(smart, scales.end());
  const std::vector<std::pair<std::string, double>> told = {
      {"wound.size", 3.01}, {"tissue.swept", 0}, {"tissue.stray", 0}, {"insert.deflections", 0}, {"task.success", 0}};
  const judge::Rating rating = judge::rate(*smart, told, false);
  for (size_t i = 0; i < smart->items.size(); ++i)
    if (smart->items[i].id == "respect_for_tissue") {
      EXPECT_THAT(rating.item[i], testing::Optional(testing::DoubleEq(1)));
    }
  EXPECT_DOUBLE_EQ(rating.mean, 1);
}

TEST(RatingScales, ThoseThatComeWithSwageAreWhole) {
  std::vector<std::string> errors;
  const auto scales = rating_scales(SWAGE_SOURCE_DIR "/resources/scales", errors);
  EXPECT_THAT(errors, testing::IsEmpty());
  ASSERT_EQ(scales.size(), 3u);
  for (const judge::RatingScale& s : scales) EXPECT_EQ(s.source.size(), 2u) << s.id << ": what is assumed is told in each language";
  for (const judge::RatingScale& s : scales)
    for (const judge::RatingItem& item : s.items) EXPECT_EQ(item.title.size(), 2u) << s.id << " " << item.id;
}

}  // namespace
}  // namespace swage::host
