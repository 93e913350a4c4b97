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

struct Named {
  Word word;
  std::string fault;          // what went wrong; empty when nothing did
  bool made_otherwise = false;  // its polygon is another knot than it was made to be, and named so
};

/// libhomfly judges a tie that is named otherwise than it was made: where its sheared curve has more turns than its nodes follow, the
/// polygon is another knot.
Named name_of(const Tie& tie, uint64_t seed) {
  static toolkit::KnotReader reader;
  toolkit::KnotThread thread;
  toolkit::KnotName name;
  EXPECT_TRUE(thread.begin(tie.data(), tie.nodes()));
  while (!reader.read(thread, 500, name)) {
  }
  Named out{word_of(name.word), "", false};
  if (name.certain && name.word.knots == (tie.word.empty() ? 0 : 1) && out.word == tie.word) return out;
  const std::string is = homfly(tie.closed(), 60, seed);
  out.made_otherwise = name.certain && !is.empty() && is != homfly(tie.word) && is == homfly(out.word);
  if (!out.made_otherwise)
    out.fault = std::to_string(seed) + ": tied " + text(tie.word) + ", named " + text(out.word) + " and " + std::to_string(name.word.others) +
                " others in " + std::to_string(name.word.knots) + " knots, " + (name.certain ? "certain" : "uncertain") + "\n";
  return out;
}

std::string fault(uint64_t seed) { return name_of(random_tie(seed), seed).fault; }

void name_ties(uint64_t from, uint64_t to) {
  int wrong = 0, made_otherwise = 0;
  std::string first;
  for (uint64_t seed = from; seed < to; ++seed) {
    const Named named = name_of(random_tie(seed), seed);
    made_otherwise += named.made_otherwise;
    if (!named.fault.empty() && ++wrong <= 20) first += named.fault;
  }
  EXPECT_EQ(wrong, 0) << first;
  EXPECT_LE(made_otherwise, 1) << "of two thousand: the others are what they were made to be";
}

TEST(Ties, RandomTiesAreNamed) { name_ties(0, 2000); }
// in one of the views of these a whole throw slides through another, which changes the order
TEST(Ties, OrderIsThatOfThePlainestView) {
  for (const uint64_t seed : {2231u, 50084u}) EXPECT_EQ(fault(seed), "");
}
// on the grid three places of these lie exactly in a line
TEST(Ties, AStraightPieceIsNotDegenerate) {
  for (const uint64_t seed : {5729u, 5860u}) EXPECT_EQ(fault(seed), "");
}
// the two of 10^5 that are not what they were made to be: of each a turn is lost between two nodes, which is read, and libhomfly agrees
TEST(Ties, ALostTurnIsRead) {
  for (const auto& [seed, word] : {std::pair<uint64_t, Word>{32591, {-2}}, {81355, {-1, -1, 2}}}) {
    const Named named = name_of(random_tie(seed), seed);
    EXPECT_TRUE(named.made_otherwise) << seed;
    EXPECT_EQ(named.word, word) << seed;
  }
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
