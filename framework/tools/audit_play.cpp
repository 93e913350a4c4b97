// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/clock.hpp"
#include "step/step.hpp"
#include "tools/audit.hpp"
#include "tools/print.hpp"
#include "tools/sentences.hpp"

namespace swage::tools {
namespace {

using Json = nlohmann::ordered_json;
using dynamics::FreeMotion;

/// A ladder and the place where its level is set.
struct Place {
  std::string name, plugin;
  std::vector<std::string> level;
  std::size_t own = 0;                                    // level of the lesson
  void (*choose)(step::Options&, std::size_t) = nullptr;  // of the engine
  std::string* params = nullptr;                          // parameters of the plugin in the lesson file; nullptr: a ladder of the engine
  std::string key = {};                                   // parameter
  std::vector<Json> value = {};                           // of the parameter, one per level
};

constexpr FreeMotion kMotions[] = {FreeMotion::kThesis,     FreeMotion::kSymplecticEuler,
                                   FreeMotion::kSplitting2, FreeMotion::kSplitting4,
                                   FreeMotion::kTaylor,     FreeMotion::kElliptic};

class Player {
 public:
  Player(const AuditPlan& plan, const host::Catalogue& catalogue, assembly::LessonFile file,
         void (*said)(const std::string&))
      : plan_(plan), catalogue_(catalogue), file_(std::move(file)), said_(said) {
    for (assembly::LessonObject& use : file_.objects) add(use.name, use);
    for (assembly::LessonCoupling& use : file_.couplings) add(use.name, use);
    add_engine();
    const auto unwanted = [&](const Place& place) {
      return !plan_.only.empty() &&
             std::find(plan_.only.begin(), plan_.only.end(), place.name) == plan_.only.end();
    };
    std::erase_if(places_, unwanted);
  }

  AuditLesson play() {
    AuditLesson out{file_.path, file_.id, file_.title, plan_.device, {}};
    for (const Place& place : places_) {
      AuditLadder& ladder = out.ladder.emplace_back();
      ladder.name = place.name;
      ladder.own = place.own;
      ladder.plugin = place.plugin;
      for (std::size_t i = 0; i < place.level.size(); ++i) {
        ladder.level.emplace_back().run = play(place, i);
        ladder.level.back().run.level = place.level[i];
      }
    }
    return out;
  }

 private:
  void add(const std::string& instance, assembly::PluginUse& use) {
    const host::PluginInfo* plugin = catalogue_.find(use.plugin);
    if (plugin == nullptr) return;
    for (const host::Param& p : plugin->params) {
      if (p.id == "level" && p.type == SWAGE_PARAM_CHOICE)
        add_levels(instance, use, p);
      else if (p.id == "segments" && p.type == SWAGE_PARAM_INTEGER)
        add_segments(instance, use, p);
    }
  }

  void add_levels(const std::string& instance, assembly::PluginUse& use, const host::Param& p) {
    Place place{instance + ".level", use.plugin, p.choices, static_cast<std::size_t>(p.default_number[0]),
                nullptr,             &use.params, p.id,      {p.choices.begin(), p.choices.end()}};
    const std::string own = Json::parse(use.params).value(p.id, std::string());
    const auto found = std::find(p.choices.begin(), p.choices.end(), own);
    if (found != p.choices.end()) place.own = static_cast<std::size_t>(found - p.choices.begin());
    places_.push_back(std::move(place));
  }

  // number of pieces of a thread: from a quarter to four times the lesson's, within the parameter's range
  void add_segments(const std::string& instance, assembly::PluginUse& use, const host::Param& p) {
    const double own = Json::parse(use.params).value(p.id, p.default_number[0]);
    Place place{instance + ".segments", use.plugin, {}, 0, nullptr, &use.params, p.id};
    for (const auto& [factor, name] : {std::pair{0.25, "quarter"},
                                       {0.5, "half"},
                                       {1.0, "its own"},
                                       {2.0, "twice"},
                                       {4.0, "four times"}}) {
      const double count = std::round(factor * own);
      if (count < p.min || count > p.max) continue;
      if (factor == 1) place.own = place.level.size();
      place.level.push_back(format("%s (%.0f)", name, count));
      place.value.emplace_back(static_cast<int64_t>(count));
    }
    places_.push_back(std::move(place));
  }

  void add_engine() {
    places_.push_back({"engine.contact", "", {"thesis", "exact"}, 1, [](step::Options& o, std::size_t i) {
                         o.contact.level = i == 0 ? contact::Level::kThesis : contact::Level::kExact;
                       }});
    const auto usual =
        std::find(std::begin(kMotions), std::end(kMotions), step::Options().dynamics.free_motion);
    places_.push_back({"engine.free_motion",
                       "",
                       {"thesis", "symplectic_euler", "splitting_2", "splitting_4", "taylor", "elliptic"},
                       static_cast<std::size_t>(usual - std::begin(kMotions)),
                       [](step::Options& o, std::size_t i) { o.dynamics.free_motion = kMotions[i]; }});
  }

  // the lesson's own level is part of every ladder and is played once
  AuditRun play(const Place& place, std::size_t level) {
    const bool as_it_is = level == place.own;
    if (as_it_is && own_played_) return own_;
    said_(file_.id + "  " + place.name + " " + place.level[level]);
    step::Options options;
    const std::string before = place.params != nullptr ? *place.params : "";
    if (place.params == nullptr) {
      place.choose(options, level);
    } else if (!as_it_is) {
      Json params = Json::parse(before);
      params[place.key] = place.value[level];
      *place.params = params.dump();
    }
    AuditRun out = play(options);
    if (place.params != nullptr) *place.params = before;
    if (as_it_is) own_ = out, own_played_ = true;
    return out;
  }

  // A short run is played twice; the smaller processor time is less disturbed by other programs.
  AuditRun play(const step::Options& options) const {
    constexpr double kShort = 5;  // s, of processor time
    AuditRun out = play_once(options);
    const double spent_s = out.cpu_s * out.simulated_s / file_dt();
    if (out.problem.empty() && spent_s < kShort) out.cpu_s = std::min(out.cpu_s, play_once(options).cpu_s);
    return out;
  }
  double file_dt() const { return 1 / file_.rate_hz; }

  AuditRun play_once(const step::Options& options) const {
    AuditRun out;
    base::Problems problems;
    const auto rig = assembly::assemble(file_, catalogue_, {plan_.device, ""}, problems);
    for (const base::Problem& p : problems)
      if (p.severity == base::Severity::kError && out.problem.empty()) out.problem = p.message;
    if (!rig) return out;
    for (const host::DeviceSlot& slot : rig->devices)
      if (slot.device->open != nullptr && slot.device->open(slot.instance->raw) < 0)
        out.problem = say::kNotOpened();
    if (!out.problem.empty()) return out;
    try {
      step::Engine engine(*rig, options);
      drive(engine, out);
      read(engine, *rig, out);
    } catch (const std::exception& e) {
      out.problem = e.what();
    }
    return out;
  }

  // steps until the verdict, or kAfter beyond the end of the hand's script
  void drive(step::Engine& engine, AuditRun& out) const {
    constexpr double kAfter = 0.5;     // s, simulated
    constexpr uint64_t kBetween = 64;  // steps between two readings of the clock
    double gone_s = 0, spent_s = 0;
    uint64_t steps = 0;
    const int64_t begin = base::cpu_ns();
    const auto look = [&] { spent_s = 1e-9 * static_cast<double>(base::cpu_ns() - begin); };
    while (engine.verdict().outcome == judge::Outcome::kRunning && gone_s < kAfter &&
           engine.world().time() < plan_.max_time_s && spent_s < plan_.budget_s) {
      engine.step();
      if (++steps % kBetween == 0) look();
      if (engine.hand_gone()) gone_s += engine.world().dt;
    }
    if (spent_s >= plan_.budget_s)
      out.problem = say::kTooSlow(format("%.2f", engine.world().time()), format("%.0f", spent_s));
    look();
    out.cpu_s = spent_s / static_cast<double>(std::max<uint64_t>(1, steps));
    out.simulated_s = engine.world().time();
  }

  static void read(const step::Engine& engine, const host::Rig& rig, AuditRun& out) {
    const judge::Verdict& v = engine.verdict();
    out.outcome = judge::text(v.outcome);
    out.reason = v.reason == SWAGE_NONE ? "" : rig.script.events[v.reason].id;
    out.score = v.score;
    for (std::size_t i = 0; i < v.metric.size(); ++i)
      out.metric.push_back({rig.script.metrics[i].id, rig.script.metrics[i].unit, v.metric[i]});
    for (const host::Instance* instance : host::instances(rig))
      if (out.problem.empty() && instance->quarantined.load() != 0)
        out.problem = host::quarantine_text(*instance);
  }

  const AuditPlan& plan_;
  const host::Catalogue& catalogue_;
  assembly::LessonFile file_;
  void (*const said_)(const std::string&);
  std::vector<Place> places_;
  AuditRun own_;
  bool own_played_ = false;
};

}  // namespace

AuditLesson play_levels(const AuditPlan& plan, const host::Catalogue& catalogue, assembly::LessonFile file,
                        void (*said)(const std::string&)) {
  return Player(plan, catalogue, std::move(file), said).play();
}

}  // namespace swage::tools
