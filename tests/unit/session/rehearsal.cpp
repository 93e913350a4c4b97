// SPDX-License-Identifier: Apache-2.0
//
// A lesson as its scripted hand plays it, beside a session: the same motion, and neither disturbs the other.
#include "session/rehearsal.hpp"

#include "session/sentences.hpp"
#include "session_bed.hpp"

namespace swage::session {
namespace {

TEST_F(SessionTest, ARehearsalIsWhatTheExpertDoesInASession) {
  Problems problems;
  const auto rehearsal = Rehearsal::open(options, "expert", problems);
  ASSERT_NE(rehearsal, nullptr) << told(problems);
  auto session = open();
  session->start();  // both at once
  while (rehearsal->step()) {
  }
  session->wait();
  const Result result = session->result();
  snapshot::Snapshot end, other;
  rehearsal->fill(end);
  ASSERT_TRUE(session->latest(other));
  EXPECT_EQ(end.outcome, static_cast<uint32_t>(judge::Outcome::kPassed));
  EXPECT_EQ(rehearsal->at(), result.steps);
  EXPECT_EQ(end.hash, result.hash) << "bit for bit";
  EXPECT_FALSE(rehearsal->step()) << "over";
  EXPECT_EQ(rehearsal->at(), result.steps);
}

TEST_F(SessionTest, ARehearsalNeedsAScriptedHand) {
  Problems problems;
  EXPECT_EQ(Rehearsal::open(options, "master", problems), nullptr);
  EXPECT_NE(told(problems).find(say::kNoHand("master")), std::string::npos) << told(problems);
}

TEST_F(SessionTest, ARehearsalOfTheSameSeedGoesToTheSameTarget) {
  options.lesson_path = SWAGE_SOURCE_DIR "/lessons/series/040_grasp_advanced_2.json";
  const auto end_of = [&](const char* seed) {
    options.settings = {seed};
    Problems problems;
    const auto rehearsal = Rehearsal::open(options, "expert", problems);
    EXPECT_NE(rehearsal, nullptr) << told(problems);
    snapshot::Snapshot out;
    if (!rehearsal) return out;
    while (rehearsal->step()) {
    }
    rehearsal->fill(out);
    return out;
  };
  const snapshot::Snapshot a = end_of("seed=3"), b = end_of("seed=3"), c = end_of("seed=4");
  EXPECT_EQ(a.hash, b.hash);
  const auto targets = [](const snapshot::Snapshot& s) {
    double sum = 0;
    for (uint32_t m = 0; m < s.n_mark; ++m) sum += s.mark_p_W[m].x + s.mark_p_W[m].y;
    return sum;
  };
  EXPECT_NE(targets(a), targets(c));
  EXPECT_EQ(targets(a), targets(b));
}

}  // namespace
}  // namespace swage::session
