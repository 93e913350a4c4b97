// SPDX-License-Identifier: Apache-2.0
//
// A device in this program: counts its calls, moves as told, remembers the forces it was given.
#pragma once

#include <swage/abi/device.h>

#include <atomic>
#include <memory>

#include "base/clock.hpp"
#include "host/rig.hpp"

namespace swage::session {

struct FakeDevice {
  swage_instance raw{};
  swage_device table{};
  std::atomic<uint64_t> exchanges{0};
  std::atomic<double> force{0}, most{0}, most_y{0}, position{0};
  std::atomic<bool> frozen{false}, throws{false};
  std::atomic<int64_t> block_ns{0};

  FakeDevice(uint32_t flags, double max_force) {
    raw.self = this;
    raw.deactivate = raw.destroy = [](swage_instance*) {};
    raw.get_extension = [](swage_instance*, const char*) -> const void* { return nullptr; };
    table.flags = flags;
    table.rate_hz = 1000;
    table.max_force = max_force;
    table.exchange = exchange;
    table.open = [](swage_instance*) { return swage_result{SWAGE_OK}; };
    table.close = [](swage_instance*) {};
  }

  /// A slot of a rig with this device in it.
  host::DeviceSlot slot() {
    host::DeviceSlot out;
    out.instance = std::make_unique<host::Instance>();
    out.instance->name = "hand";
    out.instance->plugin_id = "test.device.fake";
    out.instance->raw = &raw;
    out.device = &table;
    out.force_scale = 1;
    return out;
  }

  static swage_result exchange(swage_instance* instance, const swage_command* command, swage_sample* out) {
    FakeDevice& self = *static_cast<FakeDevice*>(instance->self);
    const uint64_t n = ++self.exchanges;
    if (self.throws) throw 1;
    if (self.block_ns > 0) base::sleep_until_ns(base::wall_ns() + self.block_ns);
    self.force = command->force.x;
    if (command->force.x > self.most) self.most = command->force.x;
    if (command->force.y > self.most_y) self.most_y = command->force.y;
    if (self.frozen) return SWAGE_OK;
    out->sequence = n;
    out->time_s = command->time_s;
    out->pose.p.x = self.position;
    out->pose.q.w = 1;
    out->valid = SWAGE_VALID_POSE;
    return SWAGE_OK;
  }
};

}  // namespace swage::session
