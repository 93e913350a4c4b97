// SPDX-License-Identifier: Apache-2.0
//
// An object whose chain is a band is asked for its stiffness again and again where the host cannot factor it. The time of each question
// is its own, that of so many questions is not.
#include <gtest/gtest.h>
#include <swage/abi/band.h>

#include <vector>

#include "base/clock.hpp"
#include "step/flexible_body_adapter.hpp"

namespace swage::step {
namespace {

constexpr uint32_t kVertices = 4;
constexpr int64_t kBudget = 2'000'000;  // ns; ten times the real one, as a guest is charged for what its host takes away

void work_ns(int64_t ns) {
  const int64_t end = base::cpu_ns() + ns;
  while (base::cpu_ns() < end) {
  }
}

/// One body with one chain, whose object takes `answers_in` ns of processor time for a question.
struct Scene {
  explicit Scene(int64_t ns) : answers_in(ns) {
    scene::BodyInfo body;
    body.motion = SWAGE_MOTION_FLEXIBLE;
    world.body.push_back(body);
    scene::Shape shape;
    shape.kind = SWAGE_SHAPE_CHAIN;
    shape.object = 0, shape.chain = 0;
    world.shape.push_back(shape);
    scene::ChainInfo chain;
    chain.start.resize(kVertices);
    world.chain.push_back(chain);

    raw.self = this;
    raw.deactivate = raw.destroy = [](swage_instance*) {};
    raw.get_extension = [](swage_instance*, const char* id) -> const void* {
      static constexpr swage_band kBand{
          [](swage_instance* i, const swage_object_step*, uint32_t, double*, double*) {
            work_ns(static_cast<Scene*>(i->self)->answers_in);
            return swage_result{SWAGE_OK};
          },
          [](swage_instance*, const swage_object_step*, const double*, uint32_t, const swage_contact_point*,
             const swage_chain_place*, const double*) { return swage_result{SWAGE_OK}; }};
      return std::string(id) == SWAGE_EXT_BAND ? &kBand : nullptr;
    };
    slot.instance = std::make_unique<host::Instance>();
    slot.instance->name = "rubber";
    slot.instance->raw = &raw;
    slot.instance->watch.budget_ns = kBudget;
    slot.solver_2 = &solver;
    slot.body = slot.shape = {0, 1};
  }

  /// Steps in each of which it is asked so often.
  void ask(int steps, uint32_t times) {
    FlexibleBodyAdapter adapter(slot, 0, view, world);
    ASSERT_TRUE(adapter.banded());
    std::vector<double> stiffness(std::size_t{SWAGE_BAND_UNKNOWNS} * kVertices * SWAGE_BAND_COLUMN), gradient(SWAGE_BAND_UNKNOWNS * kVertices);
    for (int i = 0; i < steps; ++i, ++view.step)
      for (uint32_t stiffer = 0; stiffer < times; ++stiffer) static_cast<void>(adapter.linearise(stiffer, stiffness.data(), gradient.data()));
  }

  int64_t answers_in;
  scene::World world;
  swage_instance raw{};
  swage_solver_2 solver{};
  swage_object_step view{};
  host::ObjectSlot slot;
};

// seven questions of a seventh of the budget or so: a thread that is wound about a tool, which the host makes stiffer six times a step
TEST(Bands, EachQuestionHasTheBudgetOfAStep) {
  Scene s(kBudget / 5);
  s.ask(30, 7);
  EXPECT_EQ(s.slot.instance->watch.late_steps, 0u);
  EXPECT_EQ(s.slot.instance->quarantined, 0u);
}

TEST(Bands, WhoIsLateWithOneQuestionIsQuarantined) {
  Scene s(kBudget + kBudget / 2);
  s.ask(30, 2);
  EXPECT_EQ(s.slot.instance->fault, host::FaultKind::kLate);
  EXPECT_EQ(s.slot.instance->watch.late_steps, 20u) << "a step counts once, however many questions are over the line";
}

}  // namespace
}  // namespace swage::step
