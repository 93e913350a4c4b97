// SPDX-License-Identifier: Apache-2.0
//
// Knots as hands have drawn them (drawn_knots.json), most of whose views are hard to read, and knots that are no throws.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "test_places.hpp"
#include "ties.hpp"
#include "toolkit/knot/form.hpp"
#include "toolkit/knot/reader.hpp"
#include "toolkit/knot/touch.hpp"

namespace swage::test {
namespace {

using namespace toolkit;

KnotName read_all(const std::vector<Vec3>& node) {
  KnotThread thread;
  KnotReader reader;
  KnotName name;
  EXPECT_TRUE(thread.begin(node.front().data(), static_cast<int>(node.size())));
  while (!reader.read(thread, 500, name)) {
  }
  return name;
}

Word word_read(const KnotWord& w) {
  Word out;
  for (size_t i = 0; i < static_cast<size_t>(w.throws); ++i) out.push_back(w.tied[i].sign * w.tied[i].turns);
  return out;
}

struct DrawnKnot {
  Word word;
  std::vector<Vec3> node;  // m
};

DrawnKnot drawn_knot(const char* name) {
  std::ifstream file(SWAGE_SOURCE_DIR "/tests/knots/drawn_knots.json");
  const auto knot = nlohmann::json::parse(file).at(name);
  DrawnKnot out{knot.at("word").get<Word>(), {}};
  for (const auto& p : knot.at("nodes_um")) out.node.push_back(1e-6 * Vec3(p[0], p[1], p[2]));
  return out;
}

/// A Lissajous knot (cos(3 t + px), cos(2 t + py), cos(n t)), cut open where it is farthest out.
std::vector<Vec3> lissajous(double n, double px, double py) {
  std::vector<Vec3> round, out;
  for (int i = 0; i < 240; ++i) {
    const double t = 2 * std::numbers::pi * i / 240;
    round.emplace_back(std::cos(3 * t + px), std::cos(2 * t + py), std::cos(n * t));
  }
  const auto far = std::max_element(round.begin(), round.end(), [](const Vec3& a, const Vec3& b) { return a.norm() < b.norm(); });
  out.assign(far + 1, round.end());
  out.insert(out.end(), round.begin(), far);
  return out;
}

class Drawn : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Knots, Drawn, testing::Values("drawn_with_60_mN", "drawn_with_a_loop"));

TEST_P(Drawn, IsNamed) {
  const DrawnKnot knot = drawn_knot(GetParam());
  const KnotName name = read_all(knot.node);
  EXPECT_TRUE(name.certain);
  EXPECT_FALSE(name.tangled || name.unread);
  EXPECT_EQ(word_read(name.word), knot.word);
  EXPECT_EQ(name.word.knots, 1);
}

/// No strand of it runs straight: in its throws both turn alike, or each by more than three quarters of a turn.
TEST_P(Drawn, DoesNotSlide) {
  const DrawnKnot knot = drawn_knot(GetParam());
  const KnotName name = read_all(knot.node);
  ASSERT_EQ(name.word.throws, 3);
  for (size_t i = 0; i < 3; ++i) EXPECT_EQ(KnotForm(knot.node.front().data(), static_cast<int>(knot.node.size()), name.word.tied[i]).core(), -1) << i;
}

/// The diagrams are those of the word, by libhomfly: what was not reduced is no other knot.
TEST_P(Drawn, EachViewIsThatKnotByLibhomfly) {
  const DrawnKnot knot = drawn_knot(GetParam());
  KnotThread thread;
  KnotEye eye;
  KnotStrand strand;
  ASSERT_TRUE(thread.begin(knot.node.front().data(), static_cast<int>(knot.node.size())));
  while (!thread.straighten(1000)) {
  }
  int asked = 0, unreduced = 0;
  for (int k = 0; k < KnotReader::kFirstViews; ++k) {
    KnotDiagram diagram;
    if (eye.look(thread, KnotReader::view(k), diagram) != KnotSight::kSound) continue;
    strand.reduce(diagram);
    unreduced += KnotReading::read(diagram).others > 0;
    EXPECT_EQ(homfly(diagram), homfly(knot.word)) << k;
    ++asked;
  }
  EXPECT_GE(asked, 10);
  EXPECT_GE(unreduced, 2) << "else this knot tests nothing";
}

class DrawnLoop : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Knots, DrawnLoop, testing::Values("legs_in_the_last_strand", "a_leg_on_the_throw", "legs_crossed_in_the_air"));

/// Tied around 4 to 5 mm of thread, in pieces of 0.4 mm, by a first throw of some 2 mm in each strand. The diagrams have the loop in the throw.
TEST_P(DrawnLoop, IsNoPartOfTheFirstThrow) {
  constexpr double kPiece = 0.401;  // mm
  const DrawnKnot knot = drawn_knot(GetParam());
  const KnotName name = read_all(knot.node);
  ASSERT_TRUE(name.certain);
  ASSERT_EQ(word_read(name.word), knot.word);
  const KnotThrow& seen = name.word.tied[0];
  const KnotThrow first = KnotTouch(knot.node.front().data(), static_cast<int>(knot.node.size()), 44.5e-6).up_to_loop(seen);
  EXPECT_LT(kPiece * (seen.strand[1].first - seen.strand[0].last), 2) << "else this knot tests nothing";
  EXPECT_GT(kPiece * (first.strand[1].first - first.strand[0].last), 4);
  EXPECT_LT(kPiece * (first.strand[1].first - first.strand[0].last), 6);
  EXPECT_LT(kPiece * (first.strand[0].last - first.strand[0].first), 3.5);
  EXPECT_LT(kPiece * (first.strand[1].last - first.strand[1].first), 3.5);
  EXPECT_EQ(first.strand[0].first, seen.strand[0].first);
  EXPECT_EQ(first.strand[1].last, seen.strand[1].last);
}

/// Its third throw takes less than a piece of each strand, which turn by 0.4 and 0.8 rad: none is wound about the other one.
TEST(ShortThrow, DoesNotSlide) {
  const DrawnKnot knot = drawn_knot("a_leg_on_the_throw");
  const KnotName name = read_all(knot.node);
  ASSERT_EQ(name.word.throws, 3);
  const KnotForm form(knot.node.front().data(), static_cast<int>(knot.node.size()), name.word.tied[2]);
  EXPECT_LT(form.turned(0), 0.5 * form.turned(1));
  EXPECT_LT(form.turned(1), 1.5);
  EXPECT_EQ(form.core(), -1);
}

/// A loose throw touches nowhere, and its places are those of its crossings.
TEST(LooseThrow, KeepsItsPlaces) {
  const auto tie = make_tie({2, -1, 1}, {}, 1);
  const KnotName name = read_all(tie->node);
  ASSERT_EQ(name.word.throws, 3);
  const KnotTouch touch(tie->data(), tie->nodes(), 1e-3);
  const KnotThrow &seen = name.word.tied[0], kept = touch.up_to_loop(seen);
  EXPECT_LT(touch.touch(), 2) << "distance of its strands";
  EXPECT_EQ(kept.strand[0].last, seen.strand[0].last);
  EXPECT_EQ(kept.strand[1].first, seen.strand[1].first);
}

/// 5_2 has the determinant of a throw of three turns, 7, and another signature, 2 for 6: that proves it to be no throws.
TEST(Tangle, IsProvedByItsInvariants) {
  const KnotName name = read_all(lissajous(7, 0.7, 0.2));
  EXPECT_EQ(name.word.invariants.determinant, 7);
  EXPECT_EQ(std::abs(name.word.invariants.signature), 2);
  EXPECT_TRUE(name.tangled);
  EXPECT_FALSE(name.certain || name.unread);
}

/// 6_1 has the invariants of a square knot (9, 0) and is none: nothing is proved, and it is not taken for one.
TEST(Tangle, WithTheInvariantsOfAWordIsUnread) {
  const KnotName name = read_all(lissajous(5, 1.5, 0.2));
  EXPECT_EQ(name.word.invariants.determinant, 9);
  EXPECT_EQ(name.word.invariants.signature, 0);
  EXPECT_TRUE(name.unread);
  EXPECT_FALSE(name.certain || name.tangled);
}

}  // namespace
}  // namespace swage::test
