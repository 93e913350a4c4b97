// SPDX-License-Identifier: Apache-2.0
#include "host/instance.hpp"

#include <array>
#include <utility>

#include "host/builder.hpp"
#include "host/guard.hpp"
#include "host/library.hpp"
#include "host/plugin_info.hpp"
#include "host/sentences.hpp"

namespace swage::host {

namespace {

constexpr std::array kCalls = {
    "none",      "create",         "configure", "activate", "deactivate", "destroy",   "get_extension",
    "bind",      "open",           "close",     "forces",   "finish",     "reset",     "advance",
    "mobility",  "apply_impulses", "resolve",   "observe",  "exchange",   "change",    "ties",
    "on_solved", "displacement",   "draw",      "linearise", "displace",  "load",      "init",
    "descriptor"};

static_assert(kCalls.size() == static_cast<std::size_t>(Call::kDescribe) + 1, "each call has its word");

constexpr std::array kFaults = {"nothing",
                                  "returned an error",
                                  "threw an exception",
                                  "wrote a number that is not finite",
                                  "wrote a number beyond the limit of the scene",
                                  "changed how the processor calculates",
                                  "was late in 20 of 100 steps by its own processor time",
                                  "slept or waited in 20 of 100 steps",
                                  "held the steps up for a quarter of a second",
                                  "changed the language of the program (setlocale)",
                                  "wrote into another object's part of the scene"};
static_assert(kFaults.size() == static_cast<std::size_t>(FaultKind::kMeddled) + 1, "each fault has its words");

}  // namespace

const char* text(FaultKind fault) { return kFaults.at(static_cast<std::size_t>(fault)); }
const char* text(Call call) { return kCalls.at(static_cast<std::size_t>(call)); }

std::string quarantine_text(const Instance& instance) {
  return say::kQuarantine(instance.name, instance.plugin_id, instance.plugin_version, text(instance.fault.load()), text(instance.fault_call.load()), instance.quarantine_step.load());
}

std::unique_ptr<Instance> Instance::create(const PluginInfo& plugin, const Library& library,
                                           const std::string& name, const Shared& shared,
                                           uint32_t random_index, uint64_t seed, std::string& error) {
  auto instance = std::make_unique<Instance>();
  instance->name = name;
  instance->plugin_id = plugin.id;
  instance->plugin_version = plugin.version;
  instance->traits = plugin.traits;
  instance->services = std::make_unique<Services>(name, shared, random_index, seed);
  const bool kept = guarded(*instance, Call::kCreate, 0, [&] {
    instance->raw = library.factory().create(instance->services->abi(), plugin.id.c_str());
  });
  const swage_instance* raw = instance->raw;
  if (!kept) {
    error = quarantine_text(*instance);
  } else if (raw == nullptr) {
    error = plugin.id + " created nothing.";
  } else if (raw->configure == nullptr || raw->activate == nullptr || raw->deactivate == nullptr ||
             raw->destroy == nullptr || raw->get_extension == nullptr) {
    error = plugin.id + " created an instance with missing functions.";
    instance->raw = nullptr;
  } else {
    return instance;
  }
  return nullptr;
}

bool Instance::configure(ParamValues given, Builder& builder, std::string& error) {
  values = std::move(given.value);
  texts = std::move(given.text);
  for (std::size_t i = 0; i < values.size(); ++i) values[i].text = {texts[i].data(), texts[i].size()};
  const swage_values all{
      sizeof(swage_values), static_cast<uint32_t>(values.size()), values.data(), {name.data(), name.size()}};
  swage_result result = SWAGE_OK;
  const bool kept = guarded(*this, Call::kConfigure, 0, [&] {
    result = raw->configure(raw, &all, builder.abi());
    // a refusal is no fault: the plugin reports the reasons
    return result == SWAGE_ERROR ? SWAGE_OK : result;
  });
  if (!kept && quarantined.load() != 0) error = quarantine_text(*this);
  if (!kept || result < 0) return false;
  builder.finish();
  return !builder.failed();
}

bool Instance::activate(double dt_s, std::string& error) {
  swage_result result = SWAGE_OK;
  const bool kept = guarded(*this, Call::kActivate, 0, [&] {
    result = raw->activate(raw, dt_s);
    return result == SWAGE_ERROR ? SWAGE_OK : result;
  });
  active_ = kept && result >= 0;
  if (!active_) error = kept ? name + " (" + plugin_id + ") refused to start." : quarantine_text(*this);
  return active_;
}

void Instance::deactivate() {
  if (!active_) return;
  active_ = false;
  // also in quarantine: its resources must be released
  detail::contained(*this, Call::kDeactivate, 0, [&] { raw->deactivate(raw); });
}

const void* Instance::extension(const char* id) {
  const void* table = nullptr;
  guarded(*this, Call::kExtension, 0, [&] { table = raw->get_extension(raw, id); });
  return table;
}

Instance::~Instance() {
  deactivate();
  if (raw != nullptr) detail::contained(*this, Call::kDestroy, 0, [&] { raw->destroy(raw); });
}

}  // namespace swage::host
