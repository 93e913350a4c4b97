// SPDX-License-Identifier: Apache-2.0
#include "step/step.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "fake_scene.hpp"

namespace swage::step {
namespace {

uint32_t host_event(FakeScene& s, judge::HostEvent e) { return judge::declare_host_events(s.rig.script) + e; }

TEST(Engine, CallsInTheOrderOfThePhases) {
  FakeScene s;
  std::string order;
  const auto say = [&order](const char* what) {
    return [&order, what](const auto*) {
      order += what;
      return swage_result{SWAGE_OK};
    };
  };
  s.device_.exchange = [&](const swage_command*, swage_sample*) {
    order += "read ";
    return swage_result{SWAGE_OK};
  };
  s.tool_.forces = say("forces0 ");
  s.ball_.forces = say("forces1 ");
  s.coupling_.resolve = say("resolve ");
  s.tool_.finish = say("finish0 ");
  s.ball_.finish = say("finish1 ");
  s.coupling_.coupling_finish = say("finish ");
  s.lesson_.observe = [&](const swage_view*, const swage_verdict*, double*) {
    order += "observe";
    return swage_result{SWAGE_OK};
  };
  s.run(1);
  EXPECT_EQ(order, "read forces0 forces1 resolve finish0 finish1 finish observe");
}

TEST(Engine, EveryPhaseHasItsOwnName) {
  std::set<std::string> names;
  for (uint32_t i = 0; i < snapshot::kPhases; ++i) names.insert(text(static_cast<Phase>(i)));
  EXPECT_EQ(names.size(), snapshot::kPhases);
}

TEST(Engine, TheLessonSeesEventsOfTheStepAndJudges) {
  FakeScene s;
  s.coupling_.coupling_finish = [](const swage_coupling_step* step) {
    if (step->step == 2) step->event(step, 0, 1);
    return swage_result{SWAGE_OK};
  };
  s.lesson_.observe = [](const swage_view* view, const swage_verdict* say, double* state) {
    state[0] += view->n_event;
    say->metric(say, 0, state[0]);
    if (view->n_event > 0) say->event(say, 0, 7);
    if (view->step == 4) say->finish(say, 1, 80, 0);
    return swage_result{SWAGE_OK};
  };
  s.run(3);
  ASSERT_EQ(s.engine().events().size(), 2u);
  EXPECT_EQ(s.engine().events()[1].event, 1u);
  EXPECT_EQ(s.engine().events()[1].step, 2u);
  s.run(2);
  EXPECT_EQ(s.engine().verdict().outcome, judge::Outcome::kPassed);
  EXPECT_EQ(s.engine().verdict().reason, 1u);
  EXPECT_EQ(s.engine().verdict().finished_step, 4u);
  EXPECT_EQ(s.engine().verdict().metric[0], 1);
}

TEST(Engine, TheLessonHearsOfAQuarantine) {
  FakeScene s;
  s.ball_.forces = [](const swage_object_step* step) {
    return swage_result{step->step == 3 ? SWAGE_ERROR : SWAGE_OK};
  };
  std::vector<uint32_t> heard;
  s.lesson_.observe = [&](const swage_view* view, const swage_verdict*, double*) {
    for (uint32_t i = 0; i < view->n_event; ++i) heard.push_back(view->event[i].event);
    return swage_result{SWAGE_OK};
  };
  s.run(6);
  ASSERT_EQ(heard.size(), 1u);
  EXPECT_EQ(heard[0], host_event(s, judge::kInstanceQuarantined));
}

// what an object writes is looked at before the lesson looks: it hears of nonsense in the same step, once
TEST(Engine, TheLessonHearsOfNonsenseInTheStepInWhichItIsWritten) {
  FakeScene s;
  s.rig.world.body[1].motion = SWAGE_MOTION_FLEXIBLE;
  s.rig.objects[1].solver = &s.ball_.solver;
  s.ball_.finish = [](const swage_object_step* step) {
    if (step->step == 2) step->X_WB[0].p.x = std::numeric_limits<double>::quiet_NaN();
    return swage_result{SWAGE_OK};
  };
  std::vector<uint64_t> when;
  s.lesson_.observe = [&](const swage_view* view, const swage_verdict*, double*) {
    for (uint32_t i = 0; i < view->n_event; ++i) when.push_back(view->step);
    return swage_result{SWAGE_OK};
  };
  s.run(6);
  EXPECT_EQ(when, std::vector<uint64_t>{2});
}

TEST(Engine, ALessonThatMisusesItsWordsIsQuarantined) {
  FakeScene s;
  s.lesson_.observe = [](const swage_view*, const swage_verdict* say, double*) {
    say->metric(say, 5, 1);
    return swage_result{SWAGE_OK};
  };
  s.run(1);
  EXPECT_EQ(s.rig.lesson.instance->fault_call.load(), host::Call::kObserve);
}

TEST(Engine, CommandsComeTrueInTheNextStep) {
  FakeScene s;
  Command mark;
  mark.object = 3;
  EXPECT_TRUE(s.engine().push(mark));
  s.run(1);
  ASSERT_EQ(s.engine().events().size(), 1u);
  EXPECT_EQ(s.engine().events()[0].event, host_event(s, judge::kMomentMarked));
  EXPECT_EQ(s.engine().events()[0].value, 3);
  s.run(1);
  EXPECT_TRUE(s.engine().events().empty());
  int taken = 0;
  while (s.engine().push(mark)) ++taken;
  EXPECT_GE(taken, 16);
}

TEST(Engine, LiveParametersReachThePlugin) {
  FakeScene s;
  s.ball_.has_live = true;
  s.rig.objects[1].instance->values.resize(4);
  uint32_t index = 99;
  double value = 0;
  s.ball_.change = [&](uint32_t i, const swage_value* v) {
    index = i;
    value = v->number[0];
    return swage_result{SWAGE_OK};
  };
  Command c;
  c.kind = CommandKind::kLiveParameter;
  c.object = 1;
  c.parameter = 2;
  c.number[0] = 0.25;
  s.engine().push(c);
  s.run(1);
  EXPECT_EQ(index, 2u);
  EXPECT_EQ(value, 0.25);
  // nobody, nothing and no table: no call
  index = 99;
  for (const auto& [object, parameter] : {std::pair{0u, 0u}, {77u, 0u}, {1u, 4u}}) {
    c.object = object;
    c.parameter = parameter;
    s.engine().push(c);
  }
  s.run(1);
  EXPECT_EQ(index, 99u);
}

TEST(Engine, FillsASnapshot) {
  FakeScene s;
  s.run(3);
  auto shot = std::make_unique<snapshot::Snapshot>();
  s.engine().fill(*shot);
  EXPECT_EQ(shot->step, 3u);
  EXPECT_EQ(shot->hash, s.engine().hash());
  EXPECT_EQ(shot->n_body, 2u);
  EXPECT_EQ(shot->n_object, 2u);
  EXPECT_EQ(shot->n_device, 1u);
  EXPECT_EQ(shot->X_WB[1].p.z, s.ball().p.z);
  EXPECT_EQ(shot->object_cue[0], SWAGE_NONE);
  EXPECT_TRUE(std::isnan(shot->metric[0]));
}

TEST(Engine, TimesItsPhases) {
  FakeScene s;
  s.run(50);
  double sum = 0;
  for (uint32_t i = 0; i < snapshot::kPhases; ++i) {
    EXPECT_GE(s.engine().phase_s()[i], 0);
    sum += s.engine().phase_s()[i];
  }
  EXPECT_GT(sum, 0);
  EXPECT_LT(sum, 1e-2);
}

}  // namespace
}  // namespace swage::step
