// SPDX-License-Identifier: Apache-2.0
//
// The same for objects, and for calls from the wrong thread or in the wrong order.
#include "wrapper_bed.hpp"

namespace swage::test {
namespace {

TEST(Object, adds_forces_writes_signals_and_state) {
  Ball ball;
  ball.start();
  const auto* object = ball.get<swage_object>(SWAGE_EXT_OBJECT);
  ASSERT_NE(object, nullptr);
  EXPECT_EQ(object->forces(ball.raw, &ball.step), SWAGE_OK);
  EXPECT_EQ(object->forces(ball.raw, &ball.step), SWAGE_OK);
  EXPECT_EQ(ball.wrench.f.z, 2);
  EXPECT_EQ(ball.state[0], 2);
  EXPECT_EQ(object->finish(ball.raw, &ball.step), SWAGE_OK);
  EXPECT_EQ(ball.signal[0], 3);
  object->reset(ball.raw, &ball.step);
  EXPECT_EQ(ball.state[0], 0);
  EXPECT_TRUE(ball.host.faults.empty());
}

TEST(Object, results_of_a_step) {
  const struct {
    const char* words;
    swage_result result;
    int32_t code;
  } cases[] = {{"throw", SWAGE_FAULT, SWAGE_FAULT_THROWN},
               {"discard", SWAGE_DISCARD, 0},
               {"give up", SWAGE_ERROR, 42}};
  for (const auto& c : cases) {
    Ball ball;
    ball.values.words = c.words;
    ball.start();
    EXPECT_EQ(ball.get<swage_object>(SWAGE_EXT_OBJECT)->forces(ball.raw, &ball.step), c.result) << c.words;
    EXPECT_TRUE(ball.host.reports.empty()) << "no words on [rt]";
    if (c.code == 0) continue;
    ASSERT_EQ(ball.host.faults.size(), 1u) << c.words;
    EXPECT_EQ(ball.host.faults[0].code, c.code);
  }
}

TEST(Object, takes_live_parameters) {
  Ball ball;
  ball.start();
  const auto* live = ball.get<swage_live>(SWAGE_EXT_LIVE);
  ASSERT_NE(live, nullptr);
  const swage_value value{{4e-3, 0, 0, 0}, {}};
  EXPECT_EQ(live->change(ball.raw, 0, &value), SWAGE_OK);
  EXPECT_EQ(ball.get<swage_object>(SWAGE_EXT_OBJECT)->finish(ball.raw, &ball.step), SWAGE_OK);
  EXPECT_EQ(ball.signal[0], 4e-3);
  EXPECT_EQ(live->change(ball.raw, 1, &value), SWAGE_ERROR) << "count is not live";
  EXPECT_EQ(live->change(ball.raw, 9, &value), SWAGE_ERROR) << "there is no such parameter";
}

TEST(Object, offers_its_mechanics_and_traits) {
  Ball ball;
  ball.start();
  const auto* solver = ball.get<swage_solver>(SWAGE_EXT_SOLVER);
  const auto* graspable = ball.get<swage_graspable>(SWAGE_TRAIT_GRASPABLE);
  const auto* gripper = ball.get<swage_gripper>(SWAGE_TRAIT_GRIPPER);
  ASSERT_TRUE(solver != nullptr && graspable != nullptr && gripper != nullptr);
  EXPECT_NE(ball.raw->get_extension(ball.raw, SWAGE_TRAIT_SOLID), nullptr);
  EXPECT_NE(ball.raw->get_extension(ball.raw, "test.trait.sticky/1"), nullptr);
  EXPECT_EQ(ball.raw->get_extension(ball.raw, "test.trait.sticky/1x"), nullptr);
  EXPECT_EQ(ball.raw->get_extension(ball.raw, SWAGE_TRAIT_SOLID "x"), nullptr);
  EXPECT_EQ(ball.raw->get_extension(ball.raw, "swage.coupling/1"), nullptr);

  EXPECT_EQ(solver->advance(ball.raw, &ball.step), SWAGE_OK);
  EXPECT_EQ(ball.pose.p.x, 1);
  const swage_contact_point points[2] = {};
  double v_free[6] = {}, W[36] = {}, impulse[6] = {8, 0, 0, 0, 0, 0};
  EXPECT_EQ(solver->mobility(ball.raw, &ball.step, 2, points, v_free, W), SWAGE_OK);
  EXPECT_EQ(v_free[0], 2);
  EXPECT_EQ(W[0], 5);
  EXPECT_EQ(solver->apply_impulses(ball.raw, &ball.step, 2, points, impulse), SWAGE_OK);
  EXPECT_EQ(ball.twist.v.x, 8);

  swage_graspable_place place{};
  EXPECT_EQ(graspable->locate(ball.raw, &ball.step, {0.5, 0, 0}, &place), SWAGE_OK);
  EXPECT_EQ(place.s, 0.5);
  swage_gripper_state jaws{};
  EXPECT_EQ(gripper->describe(ball.raw, &ball.step, &jaws), SWAGE_OK);
  EXPECT_EQ(jaws.opening, 0.25);
}

TEST(Object, offers_nothing_that_it_did_not_inherit) {
  testbed::Host host;
  swage_instance* made = factory().create(&host.raw, Nothing::id);
  EXPECT_NE(made->get_extension(made, SWAGE_EXT_OBJECT), nullptr);
  for (const char* id :
       {SWAGE_EXT_LIVE, SWAGE_EXT_SOLVER, SWAGE_TRAIT_SOLID, SWAGE_TRAIT_GRASPABLE, SWAGE_TRAIT_GRIPPER})
    EXPECT_EQ(made->get_extension(made, id), nullptr) << id;
  made->destroy(made);
}

TEST(Guard, wrong_thread_is_reported_once_and_not_fatal) {
  static_assert(SWAGE_CHECKS == 1, "this test is compiled with checks");
  Ball ball;
  ball.start();
  const auto* object = ball.get<swage_object>(SWAGE_EXT_OBJECT);
  ball.host.role = SWAGE_THREAD_MAIN;
  EXPECT_EQ(object->forces(ball.raw, &ball.step), SWAGE_OK);
  EXPECT_EQ(object->forces(ball.raw, &ball.step), SWAGE_OK);
  EXPECT_EQ(ball.wrench.f.z, 2) << "the call went through";
  ASSERT_EQ(ball.host.faults.size(), 1u);
  EXPECT_EQ(ball.host.faults[0].code, SWAGE_FAULT_THREAD);
  EXPECT_EQ(ball.host.faults[0].b, SWAGE_THREAD_MAIN);
  EXPECT_EQ(ball.host.reports,
            std::vector<std::string>{std::string("ball: forces: ") + detail::kWrongThread});
}

TEST(Guard, main_calls_from_the_step_leave_a_record_without_words) {
  Ball ball;
  ball.host.role = SWAGE_THREAD_RT;
  EXPECT_EQ(ball.configure(), SWAGE_OK);
  ASSERT_EQ(ball.host.faults.size(), 1u);
  EXPECT_EQ(ball.host.faults[0].code, SWAGE_FAULT_THREAD);
  EXPECT_TRUE(ball.host.reports.empty());
}

TEST(Guard, wrong_order_is_reported_and_does_nothing) {
  Ball ball;
  const auto* object = ball.get<swage_object>(SWAGE_EXT_OBJECT);
  ball.host.role = SWAGE_THREAD_RT;
  EXPECT_EQ(object->forces(ball.raw, &ball.step), SWAGE_ERROR);
  EXPECT_EQ(ball.host.faults.back().code, SWAGE_FAULT_ORDER);
  ball.host.role = SWAGE_THREAD_MAIN;
  EXPECT_EQ(ball.raw->activate(ball.raw, 1e-3), SWAGE_ERROR);
  EXPECT_EQ(ball.host.reports.back(),
            std::string("test.object.everything: activate: ") + detail::kTooEarly);
  ball.raw->deactivate(ball.raw);
  EXPECT_EQ(ball.host.reports.back(), std::string("test.object.everything: deactivate: ") + detail::kNotActive);
  ASSERT_EQ(ball.configure(), SWAGE_OK);
  ASSERT_EQ(ball.raw->activate(ball.raw, 1e-3), SWAGE_OK);
  EXPECT_EQ(ball.raw->activate(ball.raw, 1e-3), SWAGE_ERROR);
  EXPECT_EQ(ball.configure(), SWAGE_ERROR);
  EXPECT_EQ(ball.host.reports.back(), std::string("ball: configure: ") + detail::kStillActive);
  ball.raw->deactivate(ball.raw);
  EXPECT_EQ(ball.configure(), SWAGE_OK);
}

}  // namespace
}  // namespace swage::test
