// SPDX-License-Identifier: Apache-2.0
//
// Tests of what an object draws, and of what couplings and lessons do with time and memory in the step.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "host/guard.hpp"
#include "host/malloc_guard.hpp"
#include "host/sentences.hpp"
#include "host/services.hpp"
#include "host/tables.hpp"
#include "scene/view.hpp"
#include "tools/extension_tests.hpp"
#include "tools/fuzz_harness.hpp"
#include "tools/sentences.hpp"
#include "tools/visual_test.hpp"

namespace swage::tools {

using host::Finding;
using host::Mark;

std::vector<std::string> ways_of(const host::ParamTable& table) {
  std::vector<std::string> out = {"{}"};
  for (const host::Param& p : table)
    if (p.type == SWAGE_PARAM_CHOICE)
      for (const std::string& choice : p.choices) out.push_back(nlohmann::json{{p.id, choice}}.dump());
  return out;
}

namespace {

constexpr uint64_t kSteps = 1000;
// s: of an instance in a step of a paced run (session/run.cpp); a build for finding faults is slower
#if defined(__OPTIMIZE__) && !defined(SWAGE_SANITIZED)
constexpr double kBudget = 200e-6;
#else
constexpr double kBudget = 1e-3;
#endif

std::string drawn(Stepped& s, uint32_t object, bool pierceable, std::string& note) {
  const host::ObjectSlot& slot = s.rig->objects[object];
  scene::World& world = s.rig->world;
  const swage_input input{{{0, 0, 0}, {1, 0, 0, 0}}, 0, 0, 0, 0};
  const swage_object_step view =
      scene::view(world, {slot.body, slot.particle, slot.shape, slot.hinge, slot.state, slot.signal}, &input);
  const host::ScopedRole rt(SWAGE_THREAD_RT);
  const std::string wrong = visuals(
      [&](uint32_t room, swage_visual* out, uint32_t* n) {
        return host::guarded(*slot.instance, host::Call::kDraw, world.step,
                             [&] { return slot.visuals->draw(slot.instance->raw, &view, nullptr, room, out, n); });
      },
      slot.body.count, world, &note, pierceable);
  return slot.instance->quarantined.load() != 0 ? host::quarantine_text(*slot.instance) : wrong.empty() ? "" : wrong + ".";
}

}  // namespace

Finding drawing(const TestScene& scene, uint64_t) {
  bool draws = false;
  std::string warning;
  const std::vector<std::string>& traits = scene.plugin().traits;
  const bool pierceable = std::find(traits.begin(), traits.end(), SWAGE_TRAIT_PIERCEABLE) != traits.end();
  for (const std::string& params : ways_of(scene.plugin().params)) {
    Stepped s;
    std::string error;
    Wish wish;
    wish.params = params;
    if (!scene.make(wish, s, error)) continue;  // test "range" covers parameters that are refused
    const uint32_t subject = scene.subject(wish);
    if (s.rig->objects[subject].visuals == nullptr) continue;
    draws = true;
    for (int round = 0; round < 5; ++round) {
      std::string wrong = s.run(7), note;
      if (wrong.empty()) wrong = drawn(s, subject, pierceable, note);
      const std::string where = params == "{}" ? "" : say::kParameters(params);
      if (!wrong.empty()) return {Mark::kFailed, wrong + where};
      if (!note.empty() && warning.empty()) warning = note + "." + where;
    }
  }
  if (!draws) return {Mark::kSkipped, say::kDrawsNothing()};
  return {warning.empty() ? Mark::kSuccess : Mark::kWarning, warning};
}

Finding real_time(const TestScene& scene, uint64_t seed) {
  if (!host::counts_allocations()) return {Mark::kSkipped, host::say::kNoCount()};
  std::string error;
  const auto harness = make_fuzz_harness(scene, seed, error);
  if (!harness) return {Mark::kFailed, error};
  harness->reset();
  for (uint64_t i = 0; i < kSteps && harness->fault().empty(); ++i) harness->step(i);
  if (harness->fault().empty() && harness->allocations() > 0) return {Mark::kFailed, say::kAllocates(harness->allocations(), kSteps)};
  return {};  // test "fuzz_values" reports a fault
}

Finding waits(const TestScene& scene, uint64_t) {
  Stepped s;
  std::string error;
  if (!scene.make({}, s, error)) return {Mark::kFailed, error};
  host::set_budgets(*s.rig, kBudget);
  for (uint64_t i = 0; i < kSteps; ++i) {
    s.engine->step();
    for (const host::Instance* instance : host::instances(*s.rig)) {
      if (instance->quarantined.load() == 0 || instance->plugin_id != scene.plugin().id) continue;
      const std::string told = host::quarantine_text(*instance);
      const host::FaultKind fault = instance->fault.load();
      const bool slow = fault == host::FaultKind::kLate ||
                        (fault == host::FaultKind::kStalled && instance->watch.waited_ns <= instance->watch.cpu_ns);
      return slow ? Finding{Mark::kWarning, say::kLateHere(told)} : Finding{Mark::kFailed, told};
    }
  }
  return {};
}

}  // namespace swage::tools
