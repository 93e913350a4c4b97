// SPDX-License-Identifier: Apache-2.0
//
// swage describe: description and parameters of a plugin, from its own tables; its signals and events, from a scene.
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "host/catalogue.hpp"
#include "host/child.hpp"
#include "host/device_signals.hpp"
#include "host/nearest.hpp"
#include "host/params_json.hpp"
#include "host/schema.hpp"
#include "host/units.hpp"
#include "step/overlaps.hpp"
#include "tools/print.hpp"
#include "tools/sentences.hpp"
#include "tools/test_scene.hpp"
#include "tools/verbs.hpp"

namespace swage::tools {
namespace {

namespace fs = std::filesystem;
using host::Param;
using host::PluginInfo;

std::string range_text(const Param& p) {
  switch (p.type) {
    case SWAGE_PARAM_REAL:
    case SWAGE_PARAM_INTEGER:
    case SWAGE_PARAM_VECTOR:
      return host::format_quantity(p.min, p.display_unit) + " to " +
             host::format_quantity(p.max, p.display_unit);
    case SWAGE_PARAM_CHOICE:
      return host::join(p.choices);
    case SWAGE_PARAM_BOOL:
      return "true, false";
    case SWAGE_PARAM_FILE:
      return "a file";
    default:
      return "text";
  }
}

// default value in the notation of a lesson file
std::string default_text(const Param& p) {
  if (p.required()) return "required";
  swage_value value{};
  for (std::size_t i = 0; i < 4; ++i) value.number[i] = p.default_number[i];
  value.text = {p.default_text.data(), p.default_text.size()};
  return host::value_text(p, value);
}

/// Declarations of an instance, made in a scene in a child process, so that a plugin that crashes does no harm here.
struct Declared {
  nlohmann::ordered_json signals = nlohmann::ordered_json::array(), events = signals;
  nlohmann::ordered_json overlaps = nlohmann::ordered_json::array();  // sentences: what starts inside what, in the scene of a lesson
  std::string why_not;  // "" when the declarations are known
};

template <class Named>
nlohmann::ordered_json line_of(const Named& n) {
  return {{"id", n.id}, {"unit", n.unit}, {"doc", n.doc}};
}

// the first instance of a plugin in a scene, nullptr for none
const host::Instance* first_of(const host::Rig& rig, const PluginInfo& info) {
  for (const host::Instance* one : host::instances(rig))
    if (one->plugin_id == info.id) return one;
  return nullptr;
}

// signals and events of the first instance, and what a device tells of itself
void add_declared(host::Rig& rig, const PluginInfo& info, nlohmann::ordered_json& out, std::string& why) {
  const host::Instance* one = first_of(rig, info);
  if (one == nullptr) return;
  for (const judge::Name& s : rig.script.signals)
    if (s.owner == one->name) out["signals"].push_back(line_of(s));
  for (const host::DeviceSlot& slot : rig.devices) {
    if (slot.instance.get() != one) continue;
    const host::DeviceSignals told(*slot.instance, why);
    for (uint32_t i = 0; i < told.count(); ++i) out["signals"].push_back(line_of(told.signal(i)));
  }
  for (const judge::Name& e : rig.script.events)
    if (e.owner == one->name) out["events"].push_back(line_of(e));
}

// asked in a scene of its own, or in that of `lesson`
Declared declared(const PluginInfo& info, const host::Catalogue& catalogue, const assembly::LessonFile* lesson) {
  constexpr double kLimit = 20;  // s
  const auto ask = [&]() -> std::string {
    const TestScene scene = lesson != nullptr ? TestScene(info, catalogue, *lesson) : TestScene(info, catalogue);
    nlohmann::ordered_json out = {{"signals", nlohmann::json::array()}, {"events", nlohmann::json::array()}, {"overlaps", nlohmann::json::array()}};
    std::string why = scene.skipped();
    Stepped made;
    if (why.empty() && scene.make({}, made, why)) {
      add_declared(*made.rig, info, out, why);
      // a scene that is made for it places things as they come
      if (lesson != nullptr)
        for (const base::Problem& p : step::start_overlaps(*made.rig, contact::Options())) out["overlaps"].push_back(p.message);
    }
    out["why"] = why;
    return out.dump();
  };
  Declared known;
  const auto answer = nlohmann::ordered_json::parse(host::run_forked(ask, kLimit).out, nullptr, false);
  known.why_not = "It ended the process in which it was asked.";
  if (!answer.is_object()) return known;
  known.why_not = answer.value("why", "");
  known.signals = answer["signals"];
  known.events = answer["events"];
  known.overlaps = answer["overlaps"];
  return known;
}

// prints the signals and events that a lesson may watch
void print_declared(const Declared& known) {
  for (const auto& [title, rows] : {std::pair("Signals", &known.signals), std::pair("Events", &known.events)}) {
    if (!rows->empty()) std::printf("  [%s]\n", title);
    for (const auto& row : *rows)
      std::printf("  %-20s %-5s %s\n", row["id"].get<std::string>().c_str(), row["unit"].get<std::string>().c_str(),
                  row["doc"].get<std::string>().c_str());
  }
  if (!known.overlaps.empty()) std::printf("  [At the start]\n");
  for (const auto& sentence : known.overlaps) std::printf("  %s\n", printable(sentence.get<std::string>()).c_str());
  if (!known.why_not.empty()) std::printf("  Its signals and events are not known here: %s\n", known.why_not.c_str());
}

const char* criterion_text(int32_t kind) {
  return kind == SWAGE_CRITERION_PASS     ? "to pass"
         : kind == SWAGE_CRITERION_LIMIT  ? "limit"
         : kind == SWAGE_CRITERION_POINTS ? "points"
         : kind == SWAGE_CRITERION_ENDS   ? "ends every attempt"
                                          : "demonstration";
}

// text of a cue's channels and role: "colour, shape; good"
std::string cue_text(const host::CueInfo& c) {
  const std::string role = host::cue_role_text(c.role);
  return host::channels_text(c.channels) + (role.empty() ? "" : "; " + role);
}

// prints the criteria, metrics and cues of a lesson
void print_card(const PluginInfo& info) {
  if (!info.criteria.empty()) std::printf("  [Criteria]\n");
  for (const host::CriterionInfo& c : info.criteria)
    std::printf("  %-20s %s%s\n", criterion_text(c.kind), c.text.c_str(),
                c.when.empty() ? "" : (" (when " + c.when + ")").c_str());
  if (!info.metrics.empty()) std::printf("  [Metrics]\n");
  for (const host::MetricInfo& m : info.metrics) {
    const std::string better = host::better_text(m.better), evidence = host::evidence_text(m.evidence);
    std::printf("  %-20s %-5s %-17s %s%s%s\n  %-20s %s\n", m.id.c_str(), m.unit.c_str(),
                better.empty() ? "describes" : (better + " is better").c_str(), m.doc.c_str(),
                m.code.empty() ? "" : (" " + m.code + ".").c_str(),
                evidence.empty() ? "" : (" Evidence " + evidence + ".").c_str(), "", m.formula.c_str());
  }
  if (!info.cues.empty()) std::printf("  [Cues]\n");
  for (const host::CueInfo& c : info.cues)
    std::printf("  %-20s %s (%s)\n", c.id.c_str(), c.doc.c_str(), cue_text(c).c_str());
}

// prints the tables of a lesson's page; a test compares the page with them
void print_card_markdown(const PluginInfo& info) {
  if (!info.metrics.empty())
    std::printf(
        "\n| metric | unit | better | evidence | what | formula |\n| --- | --- | --- | --- | --- | --- |\n");
  for (const host::MetricInfo& m : info.metrics)
    std::printf("| `%s` | %s | %s | %s | %s%s | %s |\n", m.id.c_str(), m.unit.c_str(),
                host::better_text(m.better), host::evidence_text(m.evidence).c_str(), m.doc.c_str(),
                m.code.empty() ? "" : (" " + m.code).c_str(), m.formula.c_str());
  if (!info.cues.empty()) std::printf("\n| cue | when | channels |\n| --- | --- | --- |\n");
  for (const host::CueInfo& c : info.cues)
    std::printf("| `%s` | %s | %s |\n", c.id.c_str(), c.doc.c_str(), cue_text(c).c_str());
}

void print_text(const PluginInfo& info) {
  std::printf("%s %s (%s): %s\n  %s\n", info.id.c_str(), info.version.c_str(), host::kind_text(info.kind),
              info.name.c_str(), info.summary.c_str());
  std::printf("  by %s, %s; %s\n", info.author.c_str(), info.licence.c_str(), info.bundle_dir.c_str());
  if (!info.traits.empty()) std::printf("  offers %s\n", host::join(info.traits).c_str());
  std::string group;
  for (const Param& p : info.params) {
    // parameters without a group have the plugin's name as heading
    if (p.group != group) std::printf("  [%s]\n", p.group.empty() ? info.name.c_str() : p.group.c_str());
    group = p.group;
    std::printf("  %-20s %-14s %s\n  %-20s %s%s\n", p.id.c_str(), default_text(p).c_str(),
                range_text(p).c_str(), "", p.doc.c_str(),
                p.live() ? " May change while the lesson runs." : "");
  }
  print_card(info);
}

// prints the parameter table of a plugin's README; a test compares the README with it
void print_markdown(const PluginInfo& info) {
  std::printf("| Parameter | Default | Range | Meaning |\n| --- | --- | --- | --- |\n");
  for (const Param& p : info.params)
    std::printf("| `%s` | %s | %s | %s%s |\n", p.id.c_str(), default_text(p).c_str(), range_text(p).c_str(),
                p.doc.c_str(), p.live() ? " Live." : "");
  print_card_markdown(info);
}

nlohmann::ordered_json to_json(const PluginInfo& info) {
  nlohmann::ordered_json out = {{"id", info.id},
                                {"kind", host::kind_text(info.kind)},
                                {"version", info.version},
                                {"name", info.name},
                                {"summary", info.summary},
                                {"author", info.author},
                                {"licence", info.licence},
                                {"traits", info.traits},
                                {"bundle", info.bundle_dir},
                                {"params", host::table_to_json(info.params)}};
  for (const host::MetricInfo& m : info.metrics)
    out["metrics"].push_back({{"id", m.id},
                              {"unit", m.unit},
                              {"better", host::better_text(m.better)},
                              {"evidence", host::evidence_text(m.evidence)},
                              {"code", m.code},
                              {"doc", m.doc},
                              {"formula", m.formula},
                              {"title", m.title},
                              {"rank", m.rank}});
  for (const host::CriterionInfo& c : info.criteria)
    out["criteria"].push_back({{"kind", criterion_text(c.kind)}, {"text", c.text}, {"when", c.when}});
  for (const host::CueInfo& c : info.cues)
    out["cues"].push_back({{"id", c.id}, {"doc", c.doc}, {"channels", host::channels_text(c.channels)}, {"role", host::cue_role_text(c.role)}});
  return out;
}

// plugins of the bundle or library at `path` alone
std::vector<PluginInfo> in_bundle(const std::string& path, std::string& error) {
  std::error_code ignored;
  const bool folder = fs::is_directory(path, ignored);
  host::Catalogue::Options options;
  options.plugin_dirs = {folder ? path : fs::path(path).parent_path().string()};
  options.use_environment = false;
  options.install_dir = "/nonexistent";
  const host::Catalogue catalogue(options);
  std::vector<PluginInfo> out;
  for (const PluginInfo& p : catalogue.plugins())
    if (folder || fs::equivalent(p.library_path, path, ignored)) out.push_back(p);
  if (!out.empty()) return out;
  error = say::kNoPluginIn(path);
  for (const auto& refused : catalogue.refused()) error += " " + refused.path + ": " + refused.reason;
  return out;
}

}  // namespace

int describe(const DescribeOptions& o) {
  std::error_code ignored;
  std::vector<PluginInfo> plugins;
  const bool is_path = o.what.find('/') != std::string::npos || o.what.ends_with(".so");
  if (is_path && fs::exists(o.what, ignored)) {
    std::string error;
    plugins = in_bundle(o.what, error);
    if (plugins.empty()) return problem(error);
  } else if (is_path) {
    return problem(say::kNothingThere(o.what));
  } else {
    host::Catalogue::Options options;
    options.plugin_dirs = o.plugin_dirs;
    const host::Catalogue catalogue(options);
    if (o.what.empty()) plugins = catalogue.plugins();
    const PluginInfo* one = o.what.empty() ? nullptr : catalogue.find(o.what);
    if (one != nullptr) plugins = {*one};
    if (!o.what.empty() && one == nullptr) return problem(catalogue.missing_text(o.what));
  }

  // declarations of an instance are listed only when few plugins are described
  host::Catalogue::Options everything;
  everything.plugin_dirs = o.plugin_dirs;
  if (is_path) everything.plugin_dirs.insert(everything.plugin_dirs.begin(), plugins[0].bundle_dir);
  const bool deep = !o.what.empty() && plugins.size() <= 4;
  const host::Catalogue partners(everything);
  assembly::LessonFile lesson;
  base::Problems unread;
  if (!o.with.empty() && !assembly::read_lesson_file(o.with, lesson, unread))
    return problem(say::kNoScene(o.with, unread.empty() ? "" : unread[0].message));
  const auto known_of = [&](const PluginInfo& p) { return declared(p, partners, o.with.empty() ? nullptr : &lesson); };

  if (o.schema) {
    const bool one = !o.what.empty() && plugins.size() == 1;
    std::printf("%s\n", (one ? host::params_schema(plugins[0]) : host::lesson_schema(plugins)).c_str());
  } else if (o.json) {
    auto list = nlohmann::ordered_json::array();
    for (const PluginInfo& p : plugins) {
      list.push_back(to_json(p));
      if (!deep) continue;
      const Declared known = known_of(p);
      list.back()["signals"] = known.signals;
      list.back()["events"] = known.events;
      if (!o.with.empty()) list.back()["overlaps"] = known.overlaps;
    }
    print(list);
  } else if (o.markdown) {
    for (const PluginInfo& p : plugins) print_markdown(p);
  } else if (o.what.empty()) {
    for (const PluginInfo& p : plugins)
      std::printf("%-9s %-28s %-8s %s\n", host::kind_text(p.kind), p.id.c_str(), p.version.c_str(),
                  p.summary.c_str());
  } else {
    for (const PluginInfo& p : plugins) {
      print_text(p);
      if (deep) print_declared(known_of(p));
    }
  }
  return kPassed;
}

}  // namespace swage::tools
