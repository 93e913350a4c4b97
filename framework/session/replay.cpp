// SPDX-License-Identifier: Apache-2.0
//
// A recorded attempt stepped again: same samples, same commands, same bits.
#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "assembly/assemble.hpp"
#include "host/catalogue.hpp"
#include "record/recorder.hpp"
#include "session/session.hpp"
#include "step/step.hpp"

namespace swage::session {

namespace {

// gives the recorded sample of each step, whatever is asked
class ReplayPort final : public step::DevicePort {
 public:
  void read(uint64_t, double, swage_sample& sample) noexcept override { sample = sample_; }
  void send(const step::ToolForce&) noexcept override {}
  void set(const swage_sample& sample) { sample_ = sample; }

 private:
  swage_sample sample_{};
};

std::unique_ptr<host::Rig> build(const record::Recording& recording,
                                 const std::vector<std::string>& plugin_dirs, Problems& problems) {
  assembly::LessonFile file;
  const record::AttemptInfo& info = recording.info;
  if (!assembly::parse_lesson(info.descriptor_text, info.descriptor_path, file, problems)) return nullptr;
  host::Catalogue::Options search;
  search.plugin_dirs = plugin_dirs;
  const host::Catalogue catalogue(search);
  auto rig = assembly::assemble(file, catalogue, {info.device, ""}, problems);
  if (!rig) return nullptr;

  // other versions may well give other bits: told, not refused
  const std::vector<host::Instance*> all = host::instances(*rig);
  for (std::size_t i = 0; i < std::min(all.size(), info.plugins.size()); ++i) {
    const auto& [id, version] = info.plugins[i];
    if (all[i]->plugin_id == id && all[i]->plugin_version == version) continue;
    problems.push_back({base::Severity::kWarning, all[i]->name,
                        "Recorded with " + id + " " + version + ", replayed with " + all[i]->plugin_id + " " +
                            all[i]->plugin_version + "."});
  }
  if (rig->devices.size() == info.devices.size()) return rig;
  problems.push_back({base::Severity::kError, info.descriptor_path,
                      "The recording has " + std::to_string(info.devices.size()) + " devices, its lesson " +
                          std::to_string(rig->devices.size()) + "."});
  return nullptr;
}

// the commands of one step, in order
void push_commands(const record::Recording& recording, std::size_t& next, uint64_t step,
                   step::Engine& engine) {
  for (; next < recording.commands.size() && recording.commands[next].step <= step; ++next) {
    const record::CommandRecord& from = recording.commands[next];
    step::Command command;
    command.kind = static_cast<step::CommandKind>(from.kind);
    command.object = from.object;
    command.parameter = from.parameter;
    std::copy(std::begin(from.number), std::end(from.number), std::begin(command.number));
    engine.push(command);
  }
}

// Which part of the scene differs cannot be read from one hash; but what the signals say can be compared object by object.
std::string who_differs(const host::Rig& rig, const float* recorded) {
  const auto differs = [&](const host::Range& range) {
    for (uint32_t i = range.first; i < range.first + range.count; ++i)
      if (static_cast<float>(rig.world.signal[i]) != recorded[i]) return true;
    return false;
  };
  std::string out;
  const auto add = [&](const host::Instance& instance) {
    out += (out.empty() ? "the signals of \"" : ", \"") + instance.name + "\"";
  };
  for (const host::ObjectSlot& slot : rig.objects)
    if (differs(slot.signal)) add(*slot.instance);
  for (const host::CouplingSlot& slot : rig.couplings)
    if (differs(slot.signal)) add(*slot.instance);
  return out.empty() ? "" : out + " differ";
}

// from this step on a plugin was in quarantine: what it did, or when the clock lost patience with it, is not repeatable
uint64_t void_from(const record::Recording& recording) {
  for (const judge::Event& e : recording.events) {
    if (e.event >= recording.info.script.events.size()) continue;
    if (recording.info.script.events[e.event].id == "host.quarantined") return e.step;
  }
  return ~uint64_t{0};
}

}  // namespace

bool replay(const record::Recording& recording, const std::vector<std::string>& plugin_dirs, Replay& out,
            Problems& problems) {
  out = {};
  const std::unique_ptr<host::Rig> rig = build(recording, plugin_dirs, problems);
  if (!rig) return false;
  const std::size_t devices = rig->devices.size(), signals = recording.info.script.signals.size();
  std::vector<ReplayPort> port(devices);
  std::vector<step::DevicePort*> ports;
  for (ReplayPort& p : port) ports.push_back(&p);
  std::unique_ptr<step::Engine> engine;
  try {
    engine = std::make_unique<step::Engine>(*rig, step::Options(), ports);
  } catch (const std::exception& e) {
    problems.push_back({base::Severity::kError, recording.info.descriptor_path, e.what()});
    return false;
  }

  std::size_t command = 0;
  const uint64_t last = void_from(recording);
  for (std::size_t i = 0; i < recording.step.size(); ++i) {
    if (recording.step[i] != i) {
      out.reason = "step " + std::to_string(i) + " was not recorded";
      return true;
    }
    if (i >= last) {
      out.reason = "a plugin was in quarantine from step " + std::to_string(last) + " on";
      break;
    }
    for (std::size_t d = 0; d < devices; ++d) port[d].set(recording.sample[devices * i + d]);
    push_commands(recording, command, i, *engine);
    engine->step();
    ++out.steps;
    if (engine->hash() == recording.hash[i]) continue;
    out.first_difference = i;
    if (rig->world.signal.size() == signals) out.reason = who_differs(*rig, &recording.signal[signals * i]);
    return true;
  }
  out.identical = true;
  return true;
}

}  // namespace swage::session
