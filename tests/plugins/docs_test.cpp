// SPDX-License-Identifier: Apache-2.0
//
// Every shipped bundle has a page, and the parameter table on it is the one in the code.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "host/catalogue.hpp"
#include "host/units.hpp"
#include "test_places.hpp"

namespace swage::host {
namespace {

const std::map<std::string, std::string> kPages = {
    {"swage.object.needle", "plugins/needle/needle.md"},
    {"swage.object.jaws", "plugins/jaws/jaws.md"},
    {"swage.object.solids", "plugins/solids/solids.md"},
    {"swage.coupling.contact", "plugins/coupling_contact/coupling_contact.md"},
    {"swage.coupling.grasp", "plugins/coupling_grasp/coupling_grasp.md"},
    {"swage.object.tissue", "plugins/tissue/tissue.md"},
    {"swage.object.thread", "plugins/thread/thread.md"},
    {"swage.coupling.pierce", "plugins/coupling_pierce/coupling_pierce.md"},
    {"swage.coupling.swage", "plugins/coupling_swage/coupling_swage.md"},
    {"swage.coupling.knot", "plugins/coupling_knot/coupling_knot.md"},
    {"swage.coupling.winding", "plugins/coupling_winding/coupling_winding.md"},
    {"swage.coupling.pull_through", "plugins/coupling_pull_through/coupling_pull_through.md"},
    {"swage.coupling.cut", "plugins/coupling_cut/coupling_cut.md"},
    {"swage.coupling.meniscus", "plugins/coupling_meniscus/coupling_meniscus.md"},
    {"swage.device.scripted", "devices/scripted/scripted.md"},
    {"swage.device.skilled", "devices/skilled/skilled.md"},
    {"swage.device.replay", "devices/replay/replay.md"},
    {"swage.device.mouse", "devices/mouse/mouse.md"},
    {"swage.device.gamepad", "devices/gamepad/gamepad.md"},
    {"swage.device.openhaptics", "devices/openhaptics/openhaptics.md"},
    {"swage.device.inverse3", "devices/inverse3/inverse3.md"},
    {"swage.device.openxr", "devices/openxr/openxr.md"},
    {"swage.device.spacemouse", "devices/spacemouse/spacemouse.md"},
    {"swage.device.tablet", "devices/tablet/tablet.md"},
    {"swage.device.jaw_sensor", "devices/jaw_sensor/jaw_sensor.md"},
    {"swage.lesson.grasp", "lessons/grasp/grasp.md"},
    {"swage.lesson.insertion", "lessons/insertion/insertion.md"},
    {"swage.lesson.angles", "lessons/angles/angles.md"},
    {"swage.lesson.free_practice", "lessons/free_practice/free_practice.md"},
    {"swage.lesson.loop", "lessons/loop/loop.md"},
    {"swage.lesson.fault", "lessons/fault/fault.md"},
    {"swage.lesson.knot", "lessons/knot/knot.md"},
    {"swage.lesson.pass", "lessons/pass/pass.md"},
    {"swage.lesson.pull", "lessons/pull/pull.md"},
    {"swage.lesson.ring", "lessons/ring/ring.md"},
    {"swage.lesson.look", "lessons/look/look.md"},
};

std::string read(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string range(const Param& p) {
  switch (p.type) {
    case SWAGE_PARAM_REAL:
    case SWAGE_PARAM_VECTOR:
      return format_quantity(p.min, p.display_unit) + " to " + format_quantity(p.max, p.display_unit);
    case SWAGE_PARAM_INTEGER:
      return format_number(p.min) + " to " + format_number(p.max);
    case SWAGE_PARAM_CHOICE: {
      std::string all;
      for (const std::string& name : p.choices) all += (all.empty() ? "" : ", ") + name;
      return all;
    }
    default:
      return "";
  }
}

std::string usual(const Param& p) {
  const auto number = [&](int i) {
    return format_quantity(p.default_number[static_cast<size_t>(i)], p.display_unit);
  };
  switch (p.type) {
    case SWAGE_PARAM_REAL:
      return number(0);
    case SWAGE_PARAM_INTEGER:
      return format_number(p.default_number[0]);
    case SWAGE_PARAM_BOOL:
      return p.default_number[0] != 0 ? "yes" : "no";
    case SWAGE_PARAM_CHOICE:
      return p.choices[static_cast<size_t>(p.default_number[0])];
    case SWAGE_PARAM_VECTOR: {
      std::string all = number(0);
      for (uint32_t i = 1; i < p.dimension; ++i) all += ", " + number(static_cast<int>(i));
      return all;
    }
    default:
      return p.required() ? "must be given" : p.default_text;
  }
}

/// The rows as they must stand on the page.
std::string table(const ParamTable& params) {
  std::string out = "| parameter | default | range | meaning |\n| --- | --- | --- | --- |\n";
  for (const Param& p : params) {
    out += "| `" + p.id + "` | " + usual(p) + " | " + range(p) + " | " + p.doc + " |\n";
  }
  return out;
}

/// The rows of a lesson's card as they must stand on the page, "" without one.
std::vector<std::string> card(const PluginInfo& plugin) {
  std::vector<std::string> out;
  const auto spaced = [](const std::string& code) { return code.empty() ? "" : " " + code; };
  for (const MetricInfo& m : plugin.metrics) {
    out.push_back("| `" + m.id + "` | " + m.unit + " | " + better_text(m.better) + " | " +
                  evidence_text(m.evidence) + " | " + m.doc + spaced(m.code) + " | " + m.formula + " |\n");
  }
  for (const CueInfo& c : plugin.cues)
    out.push_back("| `" + c.id + "` | " + c.doc + " | " + channels_text(c.channels) + " |\n");
  return out;
}

Catalogue::Options stock() {
  Catalogue::Options options;
  options.plugin_dirs = {SWAGE_BINARY_DIR "/plugins"};
  options.use_environment = false;
  options.install_dir = SWAGE_BINARY_DIR "/no_such_folder";
  return options;
}

// titles, limits and curves are looked up by the id alone
TEST(Docs, AMetricsIdHasOneUnit) {
  const Catalogue catalogue(stock());
  std::map<std::string, std::pair<std::string, std::string>> known;  // id: unit, who declared it
  for (const auto& [id, page] : kPages) {
    const PluginInfo* plugin = catalogue.find(id);
    ASSERT_NE(plugin, nullptr) << id;
    for (const MetricInfo& m : plugin->metrics) {
      const auto& [unit, owner] = known.emplace(m.id, std::pair(m.unit, id)).first->second;
      EXPECT_EQ(m.unit, unit) << m.id << " of " << id << " and of " << owner;
    }
  }
  EXPECT_GT(known.size(), 50u);
}

TEST(Docs, EveryBundleHasAPageWithTheTableOfItsParameters) {
  const Catalogue catalogue(stock());
  for (const auto& [id, page] : kPages) {
    const PluginInfo* plugin = catalogue.find(id);
    ASSERT_NE(plugin, nullptr) << id;
    const std::string text = read(std::string(SWAGE_SOURCE_DIR) + "/" + page);
    ASSERT_FALSE(text.empty()) << page << " is missing";
    EXPECT_NE(text.find("`" + id + "`"), std::string::npos) << page << " does not name its plugin";
    const std::string rows = table(plugin->params);
    EXPECT_TRUE(text.find(rows) != std::string::npos) << page << " needs this table:\n" << rows;
    for (const std::string& row : card(*plugin))
      EXPECT_TRUE(text.find(row) != std::string::npos) << page << " needs this row:\n" << row;
    // what looking measures is up to the lesson file
    if (plugin->kind == SWAGE_KIND_LESSON && id != "swage.lesson.look") {
      EXPECT_FALSE(plugin->metrics.empty()) << id << " has no card";
    }
    for (const char* part : {"## Model", "## Limits", "## Parameters"}) {
      EXPECT_NE(text.find(part), std::string::npos) << page << " has no part \"" << part << "\"";
    }
  }
}

}  // namespace
}  // namespace swage::host
