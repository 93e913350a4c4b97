// SPDX-License-Identifier: Apache-2.0
//
// Ties of known words are named, and libhomfly says that they are what they are said to be.
#include <gtest/gtest.h>

#include <map>

#include "ties.hpp"
#include "toolkit/knot/reader.hpp"

namespace swage::test {
namespace {

Word word_of(const toolkit::KnotWord& w) {
  Word out;
  for (int i = 0; i < w.throws; ++i) out.push_back(w.tied[static_cast<size_t>(i)].sign * w.tied[static_cast<size_t>(i)].turns);
  return out;
}

/// What went wrong with a tie; empty when nothing did.
std::string fault(const Tie& tie, const std::string& what) {
  static toolkit::KnotReader reader;
  toolkit::KnotThread thread;
  toolkit::KnotName name;
  EXPECT_TRUE(thread.begin(tie.data(), tie.nodes()));
  while (!reader.read(thread, 500, name)) {
  }
  if (name.certain && name.word.knots == (tie.word.empty() ? 0 : 1) && word_of(name.word) == tie.word) return "";
  return what + ": tied " + text(tie.word) + ", named " + text(word_of(name.word)) + " and " +
         std::to_string(name.word.others) + " others in " + std::to_string(name.word.knots) + " knots, " +
         (name.certain ? "certain" : "uncertain") + "\n";
}

void name_ties(uint64_t from, uint64_t to) {
  int wrong = 0;
  std::string first;
  for (uint64_t seed = from; seed < to; ++seed) {
    const std::string f = fault(random_tie(seed), std::to_string(seed));
    if (!f.empty() && ++wrong <= 20) first += f;
  }
  EXPECT_EQ(wrong, 0) << first;
}

TEST(Ties, RandomTiesAreNamed) { name_ties(0, 2000); }
// in one of the views of these a whole throw slides through another, which changes the order
TEST(Ties, OrderIsThatOfThePlainestView) {
  for (const uint64_t seed : {2231u, 50084u}) EXPECT_EQ(fault(random_tie(seed), std::to_string(seed)), "");
}
// on the grid three places of these lie exactly in a line
TEST(Ties, AStraightPieceIsNotDegenerate) {
  for (const uint64_t seed : {5729u, 5860u}) EXPECT_EQ(fault(random_tie(seed), std::to_string(seed)), "");
}
/// 10^5 ties, 2 000 in each part: how far a run has come is seen.
class TiesMany : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Soak, TiesMany, testing::Range(0, 50));
TEST_P(TiesMany, RandomTiesAreNamed) {
  const auto from = static_cast<uint64_t>(2000 * GetParam());
  name_ties(from, from + 2000);
}

TEST(Ties, HomflyConfirmsTheGenerator) {
  std::map<Word, std::string> known;
  int asked = 0;
  for (uint64_t seed = 0; seed < 300; ++seed) {
    const Tie tie = random_tie(seed);
    const std::string said = homfly(tie.closed(), 60, seed);
    if (said.empty()) continue;
    ++asked;
    std::string& expected = known[tie.word];
    if (expected.empty()) expected = homfly(tie.word);
    EXPECT_EQ(said, expected) << seed << " " << text(tie.word);
  }
  EXPECT_GT(asked, 150);
  RecordProperty("asked", asked);
}

}  // namespace
}  // namespace swage::test
