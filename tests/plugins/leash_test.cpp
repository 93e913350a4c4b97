// SPDX-License-Identifier: Apache-2.0
//
// Ties in the stock testbed: what an author of such a coupling can test without a scene.
#include "tests/plugins_for_tests/leash/leash.hpp"

#include <gtest/gtest.h>
#include <swage/testbed.hpp>

namespace swage::test {
namespace {

struct TwoBodies {
  testbed::CouplingBench<Leash> bench;
  swage_pose a = kIdentity, b = kIdentity;
  TwoBodies() {
    EXPECT_TRUE(bench.start(nullptr, nullptr));
    bench.a.X_WB = &a, bench.b.X_WB = &b;
    bench.a.n_body = bench.b.n_body = 1;
  }
};

TEST(Leash, RestsWhereItBeganAndPullsWhereItIsStretched) {
  TwoBodies s;
  ASSERT_EQ(s.bench.ask_ties(), SWAGE_OK);
  ASSERT_EQ(s.bench.ties.size(), 3u);
  for (const swage_tie& tie : s.bench.ties) EXPECT_EQ(tie.offset_W.x, 0);
  s.a.p.x = 1e-5;
  ASSERT_EQ(s.bench.ask_ties(), SWAGE_OK);
  for (const swage_tie& tie : s.bench.ties) EXPECT_NEAR(tie.offset_W.x, 1e-5, 1e-18);
}

TEST(Leash, ForgetsWhatItGaveUp) {
  TwoBodies s;
  s.bench.ask_ties();
  s.a.p.z = 3e-5;
  s.bench.ask_ties();
  for (swage_tie& tie : s.bench.ties) tie.plastic_slip_W = {0, 0, 2e-5};
  ASSERT_EQ(s.bench.on_solved(), SWAGE_OK);
  s.bench.ask_ties();
  for (const swage_tie& tie : s.bench.ties) EXPECT_NEAR(tie.offset_W.z, 1e-5, 1e-18);
  EXPECT_TRUE(s.bench.content());
}

}  // namespace
}  // namespace swage::test
