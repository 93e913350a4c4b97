// SPDX-License-Identifier: Apache-2.0
//
// One library whose fault is the name of the folder that it lies in: "constructor_crashes", "init_loops", "factory_throws",
// "descriptor_null", "deinit_exits". Tests copy it into folders of such names.
#include <swage/abi/plugin.h>

#include "evil.hpp"

extern "C" {
__attribute__((visibility("default"))) extern const swage_entry swage_plugin_entry;
}

namespace {

const std::string& fault() {
  static const std::string name = evil::bundle_of(&swage_plugin_entry);
  return name;
}

__attribute__((constructor)) void constructor() { evil::misbehave_in("constructor", fault()); }

swage_result init(const char*) {
  evil::misbehave_in("init", fault());
  return fault() == "init_refuses" ? SWAGE_ERROR : SWAGE_OK;
}

const char* const kTraits[] = {nullptr};
const swage_descriptor* describe(uint32_t index) {
  static swage_descriptor d{sizeof(swage_descriptor), SWAGE_KIND_DEVICE, "org.example.bad.loaded", "1.0.0", "Loaded", "Does nothing.",
                            "Swage", "Apache-2.0", kTraits};
  evil::misbehave_in("descriptor", fault());
  if (fault() == "descriptor_null") return nullptr;
  if (fault() == "descriptor_nameless") d.id = d.name = nullptr;
  if (fault() == "descriptor_kindless") d.kind = 77;
  return index == 0 ? &d : nullptr;
}

const void* get_factory(const char* id) {
  static const swage_factory factory = {[] { return fault() == "descriptor_endless" ? ~0u : 1u; }, describe,
                                        [](const swage_host*, const char*) -> swage_instance* { return nullptr; }};
  evil::misbehave_in("factory", fault());
  if (fault() == "factory_null") return nullptr;
  return std::strcmp(id, SWAGE_FACTORY_INSTANCES) == 0 ? &factory : nullptr;
}

}  // namespace

const swage_entry swage_plugin_entry = {sizeof(swage_entry), SWAGE_ABI_MAJOR, SWAGE_ABI_MINOR, 0, "plain C++",
                                        init,                nullptr,         get_factory};
