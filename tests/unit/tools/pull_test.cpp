// SPDX-License-Identifier: Apache-2.0
//
// swage pull: the knot of a kept attempt, copied and pulled.
#include <nlohmann/json.hpp>

#include "program.hpp"
#include "session/sentences.hpp"
#include "test_places.hpp"
#include "tools/sentences.hpp"

namespace swage::tools::test {
namespace {

using testing::HasSubstr;

const std::string kKnot = SWAGE_SOURCE_DIR "/lessons/series/139_pull_test.json";

class Pull : public Program {};

// lesson 139 is itself an attempt with a knot: pulled at its start it does what it does there
TEST_F(Pull, SaysWhatTheKnotBears) {
  ASSERT_EQ(swage({"run", kKnot, "--headless", "--device", "expert", "--as-fast-as-possible", "--max-time", "0.01", "--store", store()}).code, 1);
  const Said holds = swage({"pull", "last", "--at", "0", "--json", "--store", store()});
  EXPECT_EQ(holds.code, 0) << holds.err;
  const nlohmann::json said = holds.json();
  EXPECT_EQ(said["knot"], "2 -1 1");
  EXPECT_EQ(said["friction"], 0.3) << "that of the lesson";
  EXPECT_TRUE(said["holds"]);
  EXPECT_GE(said["bears_N"].get<double>(), 0.1);
  EXPECT_LT(said["slip_m"].get<double>(), 0.25e-3) << "0.5 mm is giving way";

  const Said slips = swage({"pull", "last", "--friction", "0.05", "--store", store()});
  EXPECT_EQ(slips.code, 1) << "two strands that hardly rub";
  EXPECT_THAT(slips.out, HasSubstr(R"(knot 2 -1 1 in "knot")"));
  EXPECT_THAT(slips.out, HasSubstr("gives way"));
}

TEST_F(Pull, SaysWhatCannotBePulled) {
  EXPECT_EQ(swage({"pull", "nobody", "--store", store()}).code, 2);
  EXPECT_EQ(swage({"pull", path("no.swage"), "--store", store()}).code, 2);
  EXPECT_EQ(swage({"pull", "last", "--load", "-1", "--store", store()}).code, 2);

  ASSERT_EQ(swage({"run", SWAGE_SOURCE_DIR "/lessons/series/090_needle_bench.json", "--headless", "--device", "expert", "--as-fast-as-possible", "--max-time", "0.01", "--store", store()}).code, 1);
  const Said none = swage({"pull", "last", "--store", store()});
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.err, HasSubstr(session::say::kNoKnot()));
  const Said late = swage({"pull", "last", "--at", "7", "--store", store()});
  EXPECT_EQ(late.code, 2);
  EXPECT_THAT(late.err, HasSubstr(say::kNoSuchMoment("0.010")));
}

}  // namespace
}  // namespace swage::tools::test
