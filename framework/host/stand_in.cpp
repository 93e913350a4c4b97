// SPDX-License-Identifier: Apache-2.0
#include "host/stand_in.hpp"

#include <swage/abi/device.h>

#include <string_view>

#include "scene/world.hpp"

namespace swage::host {

namespace {

struct Recorded {
  swage_instance instance{};
  swage_device device{};
};

const void* extension(swage_instance* instance, const char* id) {
  return std::string_view(id) == SWAGE_EXT_DEVICE ? &static_cast<Recorded*>(instance->self)->device : nullptr;
}

swage_result good(swage_instance*) { return SWAGE_OK; }
void nothing(swage_instance*) {}

}  // namespace

std::unique_ptr<Instance> stand_in_device(const std::string& name, const std::string& plugin_id,
                                          const std::string& plugin_version, uint32_t flags,
                                          const Shared& shared) {
  auto* recorded = new Recorded;
  recorded->instance.self = recorded;
  recorded->instance.configure = [](swage_instance*, const swage_values*, swage_builder*) {
    return swage_result{SWAGE_OK};
  };
  recorded->instance.activate = [](swage_instance*, double) { return swage_result{SWAGE_OK}; };
  recorded->instance.deactivate = nothing;
  recorded->instance.destroy = [](swage_instance* self) { delete static_cast<Recorded*>(self->self); };
  recorded->instance.get_extension = extension;
  recorded->device.flags = flags;
  recorded->device.rate_hz = 1000;
  recorded->device.open = good;
  recorded->device.close = nothing;
  recorded->device.exchange = [](swage_instance*, const swage_command*, swage_sample*) {
    return swage_result{SWAGE_OK};
  };

  auto out = std::make_unique<Instance>();
  out->name = name;
  out->plugin_id = plugin_id;
  out->plugin_version = plugin_version;
  out->services = std::make_unique<Services>(name, shared, scene::kNone, 0);
  out->raw = &recorded->instance;
  return out;
}

}  // namespace swage::host
