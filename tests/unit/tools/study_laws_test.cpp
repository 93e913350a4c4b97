// SPDX-License-Identifier: Apache-2.0
//
// swage study with laws of reaction: the stock plan, read back from its table, and plans that are none.
#include <cmath>
#include <fstream>
#include <sstream>
#include <vector>

#include "program.hpp"
#include "tools/sentences.hpp"

namespace swage::tools::test {
namespace {

using testing::HasSubstr;

class StudyLaws : public Program {
 protected:
  std::string plan(const std::string& laws, const std::string& more = R"("device": "hand", )") const {
    write("laws.json", R"({ "format": "swage-laws/1", "title": "Laws", "lesson": "drop.json", "hand": "mouse", )" + more + R"("laws": [ )" +
                           laws + R"( ], "file": "laws.svg" })");
    return path("laws.json");
  }
};

constexpr const char* kTwo = R"({ "name": "a", "reaction": { "law": "proportional" } }, { "name": "b", "reaction": { "law": "threshold", "from": "1 mN" } })";

// every row of the table: the scene's force, and per law what it makes of it (wanted) and what the guard let through (given)
TEST_F(StudyLaws, TheStockPlanComparesThreeLawsOnOneHand) {
  const Said said = swage({"study", source("lessons/studies/reactions.json"), "--out", path("figures")});
  ASSERT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.out, HasSubstr("null zone of 5 mN"));
  std::istringstream csv(read("figures/reactions.csv"));
  std::string line;
  std::getline(csv, line);
  EXPECT_THAT(line, testing::StartsWith("time [s],scene [N],as it is wanted [N],as it is given [N],null zone of 5 mN wanted [N]"));
  std::size_t rows = 0, touched = 0;
  double peak = 0;
  while (std::getline(csv, line)) {
    std::vector<double> v;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) v.push_back(std::stod(cell));
    ASSERT_EQ(v.size(), 8u);
    ++rows;
    const double f = v[1], most = 20 * f;
    touched += f > 0;
    ASSERT_NEAR(v[2], most, 1e-6 + 1e-6 * most);
    ASSERT_NEAR(v[4], 20 * std::max(0.0, f - 5e-3), 1e-6 + 1e-6 * most);
    ASSERT_NEAR(v[6], 20 * f * f / 50e-3, 1e-6 + 1e-5 * v[6]);
    for (const int given : {3, 5, 7}) ASSERT_LE(v[static_cast<std::size_t>(given)], 3.0 + 1e-9) << "N: the guard";
    peak = std::max(peak, v[2]);
  }
  EXPECT_GT(rows, 5000u);
  EXPECT_GT(touched, 1000u);
  EXPECT_GT(peak, 0.1) << "N: there is something to feel";
  const std::string figure = read("figures/reactions.svg");
  EXPECT_THAT(figure, HasSubstr("quadratic about 50 mN"));
  EXPECT_THAT(figure, testing::EndsWith("</svg>\n"));
}

TEST_F(StudyLaws, WhatIsNoPlanIsTold) {
  EXPECT_THAT(swage({"study", plan(R"({ "name": "a", "reaction": { "law": "proportional" } })")}).err, HasSubstr(say::kFewLaws()));
  EXPECT_THAT(swage({"study", plan(R"({ "name": "a", "reaction": { "law": "sticky" } }, { "name": "a", "reaction": { "law": "proportional" } })")}).err,
              testing::AllOf(HasSubstr("sticky"), HasSubstr(say::kSameLaw("a"))));
  EXPECT_THAT(swage({"study", plan(kTwo, R"("device": "hand", "colour": "red", )")}).err, HasSubstr("colour"));
  EXPECT_THAT(swage({"study", plan(kTwo), "--shard", "1/2", "--out", path("x")}).err, HasSubstr(say::kOneAttempt()));
}

TEST_F(StudyLaws, ADeviceThatWasNotThereIsNamed) {
  write_drop_lesson();
  const Said none = swage({"study", plan(kTwo, R"("device": "arm", )")});
  EXPECT_NE(none.code, 0);
  EXPECT_THAT(none.err, HasSubstr(say::kNoDevice()));
  // one that touches nothing gives nothing, and that is no error
  const Said nothing = swage({"study", plan(kTwo)});
  EXPECT_EQ(nothing.code, 0) << nothing.err;
}

}  // namespace
}  // namespace swage::tools::test
