// SPDX-License-Identifier: Apache-2.0
//
// Tests that the host can do alone. Each tests every plugin of the library and reports the
// worst finding.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

#include "base/rng.hpp"
#include "host/elf_exports.hpp"
#include "host/lesson_card.hpp"
#include "host/malloc_guard.hpp"
#include "host/nearest.hpp"
#include "host/sentences.hpp"
#include "host/tables.hpp"
#include "host/trial.hpp"
#include "host/validate.hpp"
#include "toolkit/read_file.hpp"

namespace swage::host {

namespace {

constexpr uint64_t kSteps = 300;  // of a trial: a third of a second, longer than the memory of any filter here

// the worst mark so far, and all sentences
class Findings {
 public:
  void add(Mark mark, const std::string& text) {
    if (mark > found_.mark) found_.mark = mark;
    // a sentence that applies to fifty parameters is reported once
    if (said_.insert(text).second && said_.size() <= 10)
      found_.text += (found_.text.empty() ? "" : "\n") + text;
  }
  void fail(const std::string& text) { add(Mark::kFailed, text); }
  void warn(const std::string& text) { add(Mark::kWarning, text); }
  Finding take() const { return found_; }

 private:
  Finding found_;
  std::set<std::string> said_;
};

const Library* load(const Subject& subject, Findings& f) {
  std::string error;
  const Library* library = Library::load(subject.library_path, error);
  if (library == nullptr) f.fail(error);
  return library;
}

std::string reasons(const Trial& trial) {
  std::string text = trial.error();
  for (const base::Problem& p : trial.problems()) text += (text.empty() ? "" : " ") + p.message;
  return text;
}

std::string trouble(Trial& trial, const std::string& id) {
  if (trial.instance() != nullptr && trial.instance()->quarantined.load() != 0)
    return quarantine_text(*trial.instance());
  return id + ": " + reasons(trial);
}

// calls f(trial) with the defaults of each plugin that can be stepped alone; reports why for the
// others
template <class F>
void each_trial(const Subject& subject, Findings& f, F&& run) {
  const Library* library = load(subject, f);
  uint32_t stepped = 0;
  std::string why;
  for (const PluginInfo& plugin : subject.plugins) {
    if (library == nullptr) break;
    Trial trial(*library, plugin, default_values(plugin.params, plugin.bundle_dir));
    if (!trial.ready()) {
      why += (why.empty() ? "" : " ") + plugin.id + " does not start with its defaults: " + reasons(trial);
    } else if (!trial.steps()) {
      why += (why.empty() ? "" : " ") + plugin.id + " cannot be stepped alone.";
    } else {
      ++stepped;
      run(trial, plugin, *library);
    }
  }
  if (stepped == 0 && library != nullptr) f.add(Mark::kSkipped, why);
}

Finding test_load(const Subject& subject) {
  Findings f;
  std::vector<std::string> symbols;
  if (!exported_symbols(subject.library_path, symbols)) f.fail(say::kNoElf());
  std::erase(symbols, SWAGE_ENTRY_SYMBOL);
  if (!symbols.empty())
    f.fail(say::kExportsMore(SWAGE_ENTRY_SYMBOL, join({symbols.begin(),
                                                       symbols.begin() + static_cast<long>(std::min<std::size_t>(symbols.size(), 5))})));
  const Library* library = load(subject, f);
  if (library == nullptr) return f.take();
  if (load(subject, f) != library) f.fail(say::kLoadsTwo());
  std::vector<PluginInfo> plugins;
  std::string error;
  if (!describe(*library, plugins, error)) f.fail(error);
  // starting with thirty plugins must not take seconds
  if (library->load_seconds() > 0.1)
    f.warn(say::kSlowLoad(static_cast<int>(library->load_seconds() * 1e3)));
  return f.take();
}

void check_factory(const Library& library, const PluginInfo& plugin, Findings& f) {
  Services services("trial", {}, scene::kNone, 1);
  const swage_factory& factory = library.factory();
  for (const std::string& id : {plugin.id + "x", std::string("org.example.nobody"), std::string()}) {
    swage_instance* made = factory.create(services.abi(), id.c_str());
    if (made == nullptr) continue;
    f.fail(say::kCreatesAnything(id));
    if (made->destroy != nullptr) made->destroy(made);
  }
  uint32_t count = 0;
  if (library.params("org.example.nobody", &count) != nullptr || count != 0)
    f.fail(say::kTableOfNobody());
  if (library.entry().get_factory("swage.factory.nobody/1") != nullptr)
    f.fail(say::kAnyFactory());
}

Finding test_descriptor(const Subject& subject) {
  Findings f;
  const Library* library = load(subject, f);
  if (library == nullptr) return f.take();
  std::set<std::string> ids;
  for (const PluginInfo& plugin : subject.plugins) {
    PluginInfo bare = plugin;
    // the table has its own test; the card refers to parameters of the table
    bare.params.clear(), bare.metrics.clear(), bare.cues.clear(), bare.criteria.clear();
    std::vector<std::string> faults = plugin_faults(bare);
    card_faults(plugin, faults);
    for (const std::string& fault : faults) f.fail(plugin.id + ": " + fault);
    if (!ids.insert(plugin.id).second) f.fail(say::kSameId(plugin.id));
    check_factory(*library, plugin, f);
  }
  if (library->factory().descriptor(static_cast<uint32_t>(subject.plugins.size())) != nullptr)
    f.fail(say::kAnyDescriptor());

  // the sidecar must agree with the binary
  std::string text, why;
  toolkit::read_file(library->bundle_dir() + "/plugin.json", kMostSidecarBytes, text, why);
  const std::string fresh =
      write_sidecar(subject.library_path, content_hash(subject.library_path), subject.plugins);
  if (text.empty()) {
    f.warn(say::kNoPluginJson());
  } else if (text != fresh) {
    f.fail(say::kOldPluginJson());
  }
  return f.take();
}

Finding test_parameters(const Subject& subject) {
  Findings f;
  for (const PluginInfo& plugin : subject.plugins) {
    for (const std::string& fault : table_faults(plugin.params)) f.fail(plugin.id + ": " + fault);
    // the defaults, written as in a lesson, must pass the checker
    std::string json;
    const ParamValues defaults = default_values(plugin.params);
    for (std::size_t i = 0; i < plugin.params.size(); ++i) {
      const Param& p = plugin.params[i];
      if (p.type == SWAGE_PARAM_FILE) continue;  // its file may not exist here
      json += (json.empty() ? "" : ", ") + ("\"" + p.id + "\": ") + value_text(p, defaults.value[i]);
    }
    ParamTable no_files = plugin.params;
    std::erase_if(no_files, [](const Param& p) { return p.type == SWAGE_PARAM_FILE; });
    ParamValues read;
    base::Problems problems;
    check_params("{" + json + "}", no_files, {plugin.id, "/", "", {}}, read, problems);
    for (const base::Problem& p : problems) f.fail(say::kOwnDefault(plugin.id, p.message));
  }
  return f.take();
}

// the table that the kind of plugin requires, complete; and a complete solver if there is one
std::string tables_of(Instance& instance, int32_t kind) {
  std::string error;
  if (kind == SWAGE_KIND_OBJECT) {
    find_table<swage_solver>(instance, SWAGE_EXT_SOLVER, false, error);
    find_table<swage_solver_2>(instance, SWAGE_EXT_SOLVER_2, false, error);
    find_table<swage_band>(instance, SWAGE_EXT_BAND, false, error);
    find_table<swage_object>(instance, SWAGE_EXT_OBJECT, true, error);
  }
  if (kind == SWAGE_KIND_COUPLING) find_table<swage_coupling>(instance, SWAGE_EXT_COUPLING, true, error);
  if (kind == SWAGE_KIND_DEVICE) find_table<swage_device>(instance, SWAGE_EXT_DEVICE, true, error);
  if (kind == SWAGE_KIND_LESSON) find_table<swage_lesson>(instance, SWAGE_EXT_LESSON, true, error);
  return error;
}

void lifecycle_of(const Library& library, const PluginInfo& plugin, Findings& f) {
  std::string error;
  const auto create = [&] { return Instance::create(plugin, library, "trial", {}, scene::kNone, 1, error); };
  // created and destroyed; activated without a configuration
  if (!create()) return f.fail(error);
  const auto early = create();
  if (early && early->activate(1e-3, error))
    f.warn(say::kEarlyActivate(plugin.id));
  if (early && early->extension("org.example.nobody/1") != nullptr)
    f.fail(say::kAnyExtension(plugin.id));

  // configured twice, each time in a new world; then activated and deactivated a hundred times
  const auto twice = create();
  for (int i = 0; i < 2 && twice; ++i) {
    error.clear();
    scene::World world;
    judge::Script script;
    base::Problems problems;
    Builder builder({plugin.kind, "trial", 0, {{0, 0, 0}, {1, 0, 0, 0}}, {}}, world, script, problems);
    if (twice->configure(default_values(plugin.params, plugin.bundle_dir), builder, error)) continue;
    const bool said = !error.empty() || !problems.empty() || !twice->services->take_reports().empty();
    if (!said) f.fail(say::kRefusesDefaults(plugin.id));
    if (i == 1) f.fail(say::kConfiguresOnce(plugin.id));
    return;
  }
  if (!twice) return;
  if (const std::string gap = tables_of(*twice, plugin.kind); !gap.empty()) f.fail(gap);
  for (const std::string& trait : plugin.traits)
    if (twice->extension(trait.c_str()) == nullptr)
      f.fail(say::kTraitNotOffered(plugin.id, trait));
  for (int i = 0; i < 100; ++i) {
    if (!twice->activate(1e-3, error))
      return f.fail(say::kActivates(plugin.id, i + 1, error));
    twice->deactivate();
  }
}

Finding test_lifecycle(const Subject& subject) {
  Findings f;
  if (const Library* library = load(subject, f))
    for (const PluginInfo& plugin : subject.plugins) lifecycle_of(*library, plugin, f);
  return f.take();
}

Finding test_threads(const Subject& subject) {
  Findings f;
  each_trial(subject, f, [&](Trial& trial, const PluginInfo& plugin, const Library&) {
    if (trial.run(kSteps) != 0) f.fail(trouble(trial, plugin.id));
    if (const uint32_t n = trial.instance()->services->role_breaches())
      f.fail(say::kWrongThread(plugin.id, n));
  });
  return f.take();
}

// hashes of n steps
std::vector<uint64_t> record(Trial& trial, uint64_t n) {
  std::vector<uint64_t> hashes;
  for (uint64_t i = 0; i < n; ++i) {
    trial.step();
    hashes.push_back(trial.hash());
  }
  return hashes;
}

Finding test_state(const Subject& subject) {
  Findings f;
  each_trial(subject, f, [&](Trial& trial, const PluginInfo& plugin, const Library& library) {
    if (plugin.kind != SWAGE_KIND_OBJECT) return;  // other kinds in the same library
    trial.reset();
    record(trial, kSteps / 3);
    const scene::World saved = trial.world();
    const auto first = record(trial, kSteps / 3);
    trial.restore(saved);
    if (record(trial, kSteps / 3) != first)
      f.fail(say::kRewinds(plugin.id));
    // a second run of the same instance, and of a second instance
    trial.reset();
    const auto again = record(trial, kSteps / 3);
    Trial other(library, plugin, default_values(plugin.params, plugin.bundle_dir));
    other.reset();
    if (record(other, kSteps / 3) != again)
      f.fail(say::kSecondInstance(plugin.id));
  });
  return f.take();
}

// random value: at an end of the range, or inside
swage_value random_value(const Param& p, base::Xoshiro256& random) {
  swage_value value{};
  const auto pick = [&] {
    const double low = std::max(p.min, -1e6), high = std::min(p.max, 1e6);
    const uint64_t end = random() % 4;
    double v = end == 0 ? low : end == 1 ? high : random.uniform(low, high);
    // wide ranges would rarely give small values: half of the inner draws are on a logarithmic scale
    if (end == 2 && low > 0) v = low * std::pow(high / low, random.uniform());
    return p.type == SWAGE_PARAM_INTEGER ? std::clamp(std::round(v), std::ceil(low), std::floor(high))
                                         : std::clamp(v, low, high);
  };
  for (double& v : value.number) v = pick();
  if (p.type == SWAGE_PARAM_BOOL) value.number[0] = static_cast<double>(random() % 2);
  if (p.type == SWAGE_PARAM_CHOICE)
    value.number[0] = static_cast<double>(random() % std::max<std::size_t>(1, p.choices.size()));
  return value;
}

void try_values(const Library& library, const PluginInfo& plugin, ParamValues values,
                const std::string& which, Findings& f) {
  Trial trial(library, plugin, std::move(values));
  if (!trial.configured()) {
    if (trial.instance() != nullptr && trial.instance()->quarantined.load() != 0)
      f.fail(which + ": " + trial.error());
    if (reasons(trial).empty()) f.fail(say::kRefusesSilently(which, plugin.id));
  } else if (trial.steps() && trial.run(20) != 0 && trial.instance()->quarantined.load() != 0) {
    f.fail(which + ": " + quarantine_text(*trial.instance()));
  }
}

Finding test_bounds(const Subject& subject) {
  Findings f;
  const Library* library = load(subject, f);
  for (const PluginInfo& plugin : subject.plugins) {
    if (library == nullptr) break;
    for (std::size_t i = 0; i < plugin.params.size(); ++i) {
      const Param& p = plugin.params[i];
      if (p.type != SWAGE_PARAM_REAL && p.type != SWAGE_PARAM_INTEGER && p.type != SWAGE_PARAM_VECTOR)
        continue;
      for (const double end : {p.min, p.max}) {
        if (!std::isfinite(end)) continue;
        ParamValues values = default_values(plugin.params, plugin.bundle_dir);
        for (double& v : values.value[i].number) v = end;
        try_values(*library, plugin, std::move(values),
                   say::kAtEnd(p.id, end == p.min ? "min" : "max"), f);
      }
    }
    for (uint64_t k = 0; k < 200 && !plugin.params.empty(); ++k) {
      base::Xoshiro256 random(subject.seed + k);
      ParamValues values = default_values(plugin.params, plugin.bundle_dir);
      for (std::size_t i = 0; i < plugin.params.size(); ++i) {
        const swage_str text = values.value[i].text;
        values.value[i] = random_value(plugin.params[i], random);
        values.value[i].text = text;
      }
      try_values(*library, plugin, std::move(values), "seed " + std::to_string(subject.seed + k), f);
    }
  }
  return f.take();
}

Finding test_chains(const Subject& subject) {
  Findings f;
  each_trial(subject, f, [&](Trial& trial, const PluginInfo& plugin, const Library&) {
    trial.reset();
    for (uint64_t i = 0; i < kSteps && trial.step(); ++i)
      if (const std::string fault = trial.chain_fault(); !fault.empty())
        return f.fail(plugin.id + ", step " + std::to_string(i + 1) + ": " + fault);
  });
  return f.take();
}

Finding test_real_time(const Subject& subject) {
  Findings f;
  if (!counts_allocations()) return {Mark::kSkipped, say::kNoCount()};
  each_trial(subject, f, [&](Trial& trial, const PluginInfo& plugin, const Library&) {
    trial.run(kSteps);
    if (trial.instance()->quarantined.load() != 0) return;  // a throw allocates; test "threads" reports it
    if (trial.allocations() > 0)
      f.fail(say::kAllocates(plugin.id, trial.allocations(), kSteps));
  });
  return f.take();
}

}  // namespace

std::vector<ValidateTest> host_tests() {
  constexpr uint32_t kObjects = kind_bit(SWAGE_KIND_OBJECT), kDevices = kind_bit(SWAGE_KIND_DEVICE);
  return {
      {1, "load", "One exported symbol, loads twice and quickly, leaves the arithmetic alone.", test_load},
      {1, "descriptor", "Ids, versions and texts are there and agree; unknown ids give NULL.",
       test_descriptor},
      {2, "parameters", "Ranges, defaults, units and choices of the table make sense.", test_parameters},
      {3, "lifecycle", "Create, configure and activate in any number and order.", test_lifecycle},
      {3, "threads", "Runs in the step, and calls the host only from where it may.", test_threads,
       kObjects | kDevices},
      {5, "state", "The same results after a rewind, a reset, and in a second instance.", test_state,
       kObjects},
      {6, "bounds", "Every parameter at its ends and 200 random sets: an error or a good run.", test_bounds},
      {6, "chains", "Arc lengths of chains rise, and their velocities lead where their vertices stand.",
       test_chains, kObjects},
      {7, "real_time", "No allocation in the step.", test_real_time, kObjects | kDevices},
  };
}

}  // namespace swage::host
