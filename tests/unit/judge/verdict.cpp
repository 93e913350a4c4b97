// SPDX-License-Identifier: Apache-2.0
#include "judge/verdict.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "judge/host_events.hpp"

namespace swage::judge {
namespace {

TEST(Verdict, EveryOutcomeHasItsOwnWord) {
  std::set<std::string> words;
  for (uint32_t i = 0; i <= static_cast<uint32_t>(Outcome::kAborted); ++i)
    EXPECT_TRUE(words.insert(text(static_cast<Outcome>(i))).second);
  EXPECT_EQ(words.count("unknown"), 0u);
  EXPECT_STREQ(text(static_cast<Outcome>(99)), "unknown");
}

TEST(HostEvents, AreDeclaredOnceAfterThoseOfOthers) {
  Script script;
  script.events.push_back({"grasp", "grasp.taken", "1", ""});
  EXPECT_EQ(declare_host_events(script), 1u);
  EXPECT_EQ(script.events.size(), 1u + kHostEventCount);
  script.events.push_back({"late", "late.comer", "1", ""});
  EXPECT_EQ(declare_host_events(script), 1u);
  EXPECT_EQ(script.events.size(), 2u + kHostEventCount);
  EXPECT_EQ(script.events[1 + kObjectReset].id, "host.reset");
  EXPECT_EQ(script.events[1 + kForceStopped].id, "host.force_stopped");
}

}  // namespace
}  // namespace swage::judge
