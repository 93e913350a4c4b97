// SPDX-License-Identifier: Apache-2.0
#include "tools/doctor_devices.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "host/child.hpp"
#include "host/guard.hpp"
#include "tools/places.hpp"
#include "tools/sentences.hpp"
#include "tools/test_scene.hpp"

namespace swage::tools {
namespace {

constexpr double kLimit = 12;  // s: a session waits ten for a device to open

namespace fs = std::filesystem;

// opens a device and returns the result as JSON, "" for one that cannot be tested here
std::string ask(const host::PluginInfo& info, const host::Catalogue& catalogue) {
  const TestScene scene(info, catalogue);
  if (!scene.on_thread()) return nlohmann::json{{"ready", true}, {"said", say::kNoHardware()}}.dump();
  if (!scene.skipped().empty()) return "";
  Stepped made;
  std::string why;
  if (!scene.make({}, made, why)) return nlohmann::json{{"ready", false}, {"said", why}}.dump();
  host::DeviceSlot& slot = made.rig->devices[0];
  host::Instance& instance = *slot.instance;
  swage_result result = SWAGE_ERROR;
  host::guarded(instance, host::Call::kOpen, 0, [&] { return result = slot.device->open(instance.raw); });
  std::string said;
  for (const base::Problem& p : instance.services->take_reports()) said += (said.empty() ? "" : " ") + p.message;
  if (result >= 0) host::detail::contained(instance, host::Call::kClose, 0, [&] { slot.device->close(instance.raw); });
  return nlohmann::json{{"ready", result >= 0}, {"said", said}}.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

// splits a report: the first sentence is the fault, the others are the remedy
void split(const std::string& said, DeviceState& out) {
  const std::size_t end = said.find(". ");
  out.text = said.substr(0, end);
  out.remedy = end == std::string::npos ? say::kSeeItsPage() : said.substr(end + 2);
}

// path of a udev rule of the plugin or of Swage
std::string rule_file(const host::PluginInfo& info, const std::string& name) {
  std::error_code ignored;
  if (const fs::path beside = fs::path(info.bundle_dir) / name; fs::exists(beside, ignored)) return beside.string();
  std::vector<std::string> searched;
  const fs::path with_swage = fs::path(data_folder("udev", searched)) / name;
  return fs::exists(with_swage, ignored) ? with_swage.string() : "";
}

std::string command_for(const host::PluginInfo& info, const std::string& said) {
  const std::string name = "70-" + info.id + ".rules";
  if (said.find(name) != std::string::npos)
    if (const std::string file = rule_file(info, name); !file.empty())
      return "sudo install -m 644 '" + file + "' /etc/udev/rules.d/ && sudo udevadm control --reload && sudo udevadm trigger";
  const std::size_t begin = said.find("(sudo "), end = said.find(')', begin);
  return begin == std::string::npos || end == std::string::npos ? "" : said.substr(begin + 1, end - begin - 1);
}

}  // namespace

std::vector<DeviceState> ask_devices(const host::Catalogue& catalogue) {
  std::vector<DeviceState> out;
  for (const host::PluginInfo* info : catalogue.of_kind(SWAGE_KIND_DEVICE)) {
    const host::ChildResult child = host::run_forked([&] { return ask(*info, catalogue); }, kLimit);
    if (child.ok() && child.out.empty()) continue;
    DeviceState& state = out.emplace_back();
    state.id = info->id;
    const auto answer = nlohmann::json::parse(child.out, nullptr, false);
    if (!child.ok() || !answer.is_object()) {
      state.text = child.timed_out ? say::kNeverOpens() : say::kEndsProcess();
      state.remedy = say::kUnplug();
      continue;
    }
    state.ready = answer.value("ready", false);
    const std::string said = answer.value("said", "");
    if (!state.ready) {
      split(said.empty() ? say::kOpensSilently() : said, state);
      state.command = command_for(*info, said);
      continue;
    }
    state.text = said.empty() ? say::kReady() : say::kReadyAnd(said);
  }
  return out;
}

}  // namespace swage::tools
