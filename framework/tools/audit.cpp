// SPDX-License-Identifier: Apache-2.0
//
// swage audit: plays a lesson at every level of its ladders with a scripted hand, and tells which level is enough. How to read
// it: README.md.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>

#include "assembly/assemble.hpp"
#include "base/clock.hpp"
#include "host/guard.hpp"
#include "host/nearest.hpp"
#include "step/step.hpp"
#include "tools/print.hpp"
#include "tools/verbs.hpp"

namespace swage::tools {
namespace {

using Json = nlohmann::ordered_json;

/// A choice named "level" of an object or coupling, or one of the engine: levels from the simplest to the finest.
struct Ladder {
  std::string name;
  std::vector<std::string> level;
  std::size_t own = 0;            // the lesson's
  std::string* params = nullptr;  // of the plugin in the lesson file; nullptr: of the engine
  void (*choose)(step::Options&, std::size_t) = nullptr;
};

/// How one run went.
struct Played {
  std::string problem;  // why it could not be played, "" when it was
  std::string outcome, reason;
  double score = 0, cpu_s = 0;  // s of processor time per step
  uint64_t steps = 0;
  std::vector<judge::Name> names;
  std::vector<double> metric;
};

/// What of a run differs from the finest level's.
struct Verdict {
  bool enough = false;
  std::string why;  // the largest difference
};

// Processor times closer than this are equal: what a busy machine adds to a step.
constexpr double kCheaper = 0.95;

// Metrics closer than this are equal whatever their size: what a trainee could not notice, by unit.
double noticeable(const std::string& unit) {
  if (unit == "m") return 20e-6;
  if (unit == "rad") return 0.02;
  if (unit == "s") return 0.1;
  return 0.02;  // N, N s, shares and counts
}

using dynamics::FreeMotion;
constexpr FreeMotion kMotions[] = {FreeMotion::kThesis,     FreeMotion::kSymplecticEuler,
                                   FreeMotion::kSplitting2, FreeMotion::kSplitting4,
                                   FreeMotion::kTaylor,     FreeMotion::kElliptic};

class Audit {
 public:
  Audit(const AuditOptions& options, const host::Catalogue& catalogue, assembly::LessonFile file)
      : options_(options), catalogue_(catalogue), file_(std::move(file)) {
    for (assembly::LessonObject& use : file_.objects) add(use.name, use);
    for (assembly::LessonCoupling& use : file_.couplings) add(use.name, use);
    ladders_.push_back(
        {"engine.contact", {"thesis", "exact"}, 1, nullptr, [](step::Options& o, std::size_t i) {
           o.contact.level = i == 0 ? contact::Level::kThesis : contact::Level::kExact;
         }});
    ladders_.push_back({"engine.free_motion",
                        {"thesis", "symplectic_euler", "splitting_2", "splitting_4", "taylor", "elliptic"},
                        5,
                        nullptr,
                        [](step::Options& o, std::size_t i) { o.dynamics.free_motion = kMotions[i]; }});
    const auto usual =
        std::find(std::begin(kMotions), std::end(kMotions), step::Options().dynamics.free_motion);
    ladders_.back().own = static_cast<std::size_t>(usual - std::begin(kMotions));
  }

  /// True when the lesson's own level is enough on every ladder.
  bool run(Json& out) {
    bool good = true;
    for (Ladder& ladder : ladders_) good &= climb(ladder, out["ladders"].emplace_back());
    return good;
  }

 private:
  void add(const std::string& instance, assembly::PluginUse& use) {
    const host::PluginInfo* plugin = catalogue_.find(use.plugin);
    if (plugin == nullptr) return;
    for (const host::Param& p : plugin->params) {
      if (p.id != "level" || p.type != SWAGE_PARAM_CHOICE) continue;
      Ladder ladder{instance + ".level", p.choices, static_cast<std::size_t>(p.default_number[0]),
                    &use.params, nullptr};
      const std::string own = Json::parse(use.params).value("level", std::string());
      const auto found = std::find(p.choices.begin(), p.choices.end(), own);
      if (found != p.choices.end()) ladder.own = static_cast<std::size_t>(found - p.choices.begin());
      ladders_.push_back(std::move(ladder));
    }
  }

  bool climb(Ladder& ladder, Json& out) {
    std::vector<Played> played;
    for (std::size_t i = 0; i < ladder.level.size(); ++i) played.push_back(play(ladder, i));
    // the finest level that could be played is the measure of the others
    std::size_t finest = ladder.level.size() - 1;
    while (finest > 0 && !played[finest].problem.empty()) --finest;
    std::vector<Verdict> verdict;
    for (const Played& p : played) verdict.push_back(compare(p, played[finest]));
    std::size_t best = finest;
    for (std::size_t i = 0; i < played.size(); ++i)
      if (verdict[i].enough && played[i].cpu_s < kCheaper * played[best].cpu_s) best = i;

    const double saved = 1 - played[best].cpu_s / played[finest].cpu_s;
    out["ladder"] = ladder.name;
    out["own"] = ladder.level[ladder.own];
    out["reference"] = ladder.level[finest];
    out["cheapest_enough"] = ladder.level[best];
    out["saves"] = number(saved);
    if (!options_.json) std::printf("\n%s\n", ladder.name.c_str());
    for (std::size_t i = 0; i < played.size(); ++i) tell_level(ladder, i, finest, played[i], verdict[i], out);
    const bool good = verdict[ladder.own].enough;
    if (!options_.json)
      std::printf("  enough: %s, saves %.0f %% of the processor time of %s; the lesson has %s%s\n",
                  ladder.level[best].c_str(), 100 * saved, ladder.level[finest].c_str(),
                  ladder.level[ladder.own].c_str(), good ? "" : ", which is NOT enough");
    return good;
  }

  void tell_level(const Ladder& ladder, std::size_t i, std::size_t finest, const Played& p, const Verdict& v,
                  Json& out) const {
    Json& row = out["levels"].emplace_back();
    row = {{"level", ladder.level[i]}, {"enough", v.enough},         {"why", v.why},
           {"outcome", p.outcome},     {"reason", p.reason},         {"score", number(p.score)},
           {"cpu_s", number(p.cpu_s)}, {"simulated_steps", p.steps}, {"problem", p.problem}};
    for (std::size_t m = 0; m < p.metric.size(); ++m) row["metrics"][p.names[m].id] = number(p.metric[m]);
    if (options_.json) return;
    if (!p.problem.empty())
      return static_cast<void>(
          std::printf("  %-17s cannot be played: %s\n", ladder.level[i].c_str(), p.problem.c_str()));
    std::printf("  %-17s %-8s score %5.1f  %6.1f us a step  %s\n", ladder.level[i].c_str(), p.outcome.c_str(),
                p.score, 1e6 * p.cpu_s,
                i == finest ? "reference"
                : v.enough  ? "enough"
                            : ("differs: " + v.why).c_str());
  }

  Played play(Ladder& ladder, std::size_t level) {
    step::Options options;
    const std::string before = ladder.params != nullptr ? *ladder.params : "";
    if (ladder.params != nullptr) {
      Json params = Json::parse(before);
      params["level"] = ladder.level[level];
      *ladder.params = params.dump();
    } else {
      ladder.choose(options, level);
    }
    const Played out = play(options);
    if (ladder.params != nullptr) *ladder.params = before;
    return out;
  }

  Played play(const step::Options& options) const {
    Played out;
    base::Problems problems;
    const auto rig = assembly::assemble(file_, catalogue_, {options_.device, ""}, problems);
    for (const base::Problem& p : problems)
      if (p.severity == base::Severity::kError && out.problem.empty()) out.problem = p.message;
    if (!rig) return out;
    for (const host::DeviceSlot& slot : rig->devices)
      if (slot.device->open != nullptr && slot.device->open(slot.instance->raw) < 0)
        out.problem = "A device did not open.";
    if (!out.problem.empty()) return out;
    try {
      step::Engine engine(*rig, options);
      drive(engine, *rig, out);
    } catch (const std::exception& e) {
      out.problem = e.what();
    }
    return out;
  }

  // until the verdict, or half a second after the hand has come to its end
  void drive(step::Engine& engine, const host::Rig& rig, Played& out) const {
    constexpr double kAfter = 0.5;  // s, simulated
    double gone_s = 0;
    const int64_t begin = base::cpu_ns();
    while (engine.verdict().outcome == judge::Outcome::kRunning && gone_s < kAfter &&
           engine.world().time() < options_.max_time_s) {
      engine.step();
      ++out.steps;
      if (engine.hand_gone()) gone_s += engine.world().dt;
    }
    out.cpu_s = 1e-9 * static_cast<double>(base::cpu_ns() - begin) /
                static_cast<double>(std::max<uint64_t>(1, out.steps));
    const judge::Verdict& v = engine.verdict();
    out.outcome = judge::text(v.outcome);
    out.reason = v.reason == SWAGE_NONE ? "" : rig.script.events[v.reason].id;
    out.score = v.score;
    out.names = rig.script.metrics;
    out.metric = v.metric;
    if (engine.quarantined() > 0) out.problem = "A plugin went into quarantine.";
  }

  Verdict compare(const Played& p, const Played& reference) const {
    if (!p.problem.empty()) return {false, p.problem};
    if (p.outcome != reference.outcome || p.reason != reference.reason)
      return {false, "it ended " + p.outcome + (p.reason.empty() ? "" : " (" + p.reason + ")")};
    double worst = std::abs(p.score - reference.score) / (100 * options_.tolerance);
    std::string what = format("score by %.1f", std::abs(p.score - reference.score));
    for (std::size_t i = 0; i < p.metric.size(); ++i) {
      const double a = p.metric[i], b = reference.metric[i];
      if (std::isnan(a) || std::isnan(b)) continue;  // what a level cannot know, it cannot get wrong
      const double differs = std::abs(a - b);
      const double allowed =
          std::max(noticeable(p.names[i].unit), options_.tolerance * std::max(std::abs(a), std::abs(b)));
      if (differs / allowed <= worst) continue;
      worst = differs / allowed;
      what = format("%s %.4g instead of %.4g %s", p.names[i].id.c_str(), a, b, p.names[i].unit.c_str());
    }
    return {worst <= 1, what};
  }

  const AuditOptions& options_;
  const host::Catalogue& catalogue_;
  assembly::LessonFile file_;
  std::vector<Ladder> ladders_;
};

}  // namespace

int audit(const AuditOptions& o) {
  const host::ScopedRole main_role(SWAGE_THREAD_MAIN);
  bool good = true;
  Json all = Json::array();
  for (const std::string& path : o.lessons) {
    base::Problems problems;
    assembly::LessonFile file;
    host::Catalogue::Options search;
    search.plugin_dirs = o.plugin_dirs;
    const host::Catalogue catalogue(search);
    if (!assembly::read_lesson_file(path, file, problems) ||
        !assembly::assemble(file, catalogue, {o.device, ""}, problems)) {
      tell(problems);
      return kProblem;
    }
    if (!o.json)
      std::printf("%s%s: hand %s, tolerance %.3g %%\n", all.empty() ? "" : "\n", file.title.c_str(),
                  o.device.c_str(), 100 * o.tolerance);
    Json out = {{"lesson", path}, {"device", o.device}, {"tolerance", o.tolerance}};
    Audit audit(o, catalogue, std::move(file));
    good &= audit.run(out);
    all.push_back(std::move(out));
  }
  if (o.json) print(all);
  return good ? kPassed : kNotPassed;
}

}  // namespace swage::tools
