// SPDX-License-Identifier: Apache-2.0
//
// What is accepted is then run: lessons made from the shipped ones give a scene that can be stepped, or a sentence with a place.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>

#include "../../catalogue.hpp"
#include "assembly/assemble.hpp"
#include "host/call_watch.hpp"
#include "mutants.hpp"
#include "step/step.hpp"
#include "test_places.hpp"
#include "workers.hpp"

using namespace swage;

namespace {

const std::string kSeries = SWAGE_SOURCE_DIR "/lessons/series/";
constexpr int kSteps = 20;  // of an accepted scene: first contacts, first looks of the lesson

bool all_night() { return std::getenv("SWAGE_FUZZ_LONG") != nullptr; }

/// How many of a kind: some for CI, all for the soak; SWAGE_FUZZ_COUNT for whoever wants another number.
uint64_t count(uint64_t some, uint64_t all) {
  if (const char* given = std::getenv("SWAGE_FUZZ_COUNT")) return std::min<uint64_t>(all, std::strtoull(given, nullptr, 10));
  return all_night() ? all : some;
}

/// SWAGE_FUZZ_FIRST: where to begin, so that a night may be cut into parts.
uint64_t first() {
  const char* given = std::getenv("SWAGE_FUZZ_FIRST");
  return given != nullptr ? std::strtoull(given, nullptr, 10) : 0;
}

const host::Catalogue& catalogue() {
  static const host::Catalogue& found = [&]() -> const host::Catalogue& {
    // a trial has limits of its own, of processor time first: a machine that is held up accuses nobody
    host::CallWatch::off();
    const host::Catalogue& made = test::make_catalogue(SWAGE_BINARY_DIR "/plugins");
    // before the children: each would load them again
    std::string ignored;
    for (const host::PluginInfo& plugin : made.plugins()) made.load(plugin, ignored);
    return made;
  }();
  return found;
}

const fuzz::Mutants& mutants() {
  static const fuzz::Mutants all(fuzz::shipped_lessons(kSeries), catalogue());
  return all;
}

std::string step_it(host::Rig& rig) {
  for (const host::DeviceSlot& slot : rig.devices)
    if (slot.device->open != nullptr) slot.device->open(slot.instance->raw);
  step::Engine engine(rig, step::Options{});
  for (int i = 0; i < kSteps && engine.quarantined() == 0; ++i) engine.step();
  for (const swage_pose& X_WB : engine.world().X_WB)
    if (!std::isfinite(X_WB.p.x + X_WB.p.y + X_WB.p.z + X_WB.q.w)) return "a pose that is no number";
  return "";
}

fuzz::Tried attempt(const fuzz::Mutant& mutant) {
  base::Problems problems;
  assembly::LessonFile file;
  const std::string text = mutant.lesson.dump(2, ' ', false, fuzz::Json::error_handler_t::replace);
  const bool whole = assembly::parse_lesson(text, kSeries + "mutant.json", file, problems);
  if (whole == base::failed(problems)) return {false, "neither good nor told (reading)"};
  const auto rig = assembly::assemble(file, catalogue(), {"expert", ""}, problems);
  if ((rig != nullptr) == base::failed(problems)) return {false, "neither good nor told (assembling)"};
  for (const base::Problem& p : problems)
    if (p.where.empty() || p.message.empty()) return {false, "a problem without place or sentence"};
  if (problems.size() > 2000) return {false, std::to_string(problems.size()) + " problems"};
  return {rig != nullptr, rig != nullptr ? step_it(*rig) : ""};
}

/// One file for each failure, to look at: <build>/tests/fuzz_<kind>_<number>.json.
void report(const char* kind, const fuzz::Tally& tally, const std::function<fuzz::Mutant(uint64_t)>& make) {
  std::printf("%s: %llu lessons, %llu accepted and run\n", kind, static_cast<unsigned long long>(tally.trials),
              static_cast<unsigned long long>(tally.accepted));
  for (const fuzz::Failure& f : tally.failures) {
    const fuzz::Mutant mutant = make(f.trial);
    const std::string path = std::string(SWAGE_BINARY_DIR "/tests/fuzz_") + kind + "_" + std::to_string(f.trial) + ".json";
    std::ofstream(path) << mutant.lesson.dump(2, ' ', false, fuzz::Json::error_handler_t::replace);
    ADD_FAILURE() << kind << " " << f.trial << " of " << mutant.from << ": " << f.what << "\n  " << mutant.change << "\n  " << path;
  }
  EXPECT_GT(tally.accepted, 0u) << "some are harmless: both ways are walked";
}

}  // namespace

TEST(FuzzLessons, TheShippedOnesAreAccepted) {
  for (const fuzz::Seed& seed : fuzz::shipped_lessons(kSeries)) {
    const fuzz::Tried tried = attempt({seed.name, "", seed.lesson});
    EXPECT_TRUE(tried.accepted && tried.wrong.empty()) << seed.name << " " << tried.wrong;
  }
}

TEST(FuzzLessons, EachValueReplacedByNastyOnes) {
  const uint64_t all = mutants().substitutions(), n = count(2000, all);
  // a stride without a common divisor walks through all lessons and all values
  const uint64_t stride = n == all ? 1 : 104729;
  const auto number = [&](uint64_t trial) { return trial * stride % all; };
  const auto make = [&](uint64_t trial) { return mutants().substitution(number(trial)); };
  report("substitution", fuzz::run_trials(n, [&](uint64_t trial) { return attempt(make(trial)); }), make);
}

TEST(FuzzLessons, ParametersAtTheirBoundsInPairs) {
  const auto make = [](uint64_t trial) { return mutants().at_bounds(trial); };
  report("bounds", fuzz::run_trials(count(1000, 100'000), [&](uint64_t trial) { return attempt(make(trial)); }), make);
}

TEST(FuzzLessons, MixedMutants) {
  const auto make = [](uint64_t trial) { return mutants().mixed(first() + trial); };
  report("mixed", fuzz::run_trials(count(2000, 1'000'000), [&](uint64_t trial) { return attempt(make(trial)); }), make);
}
