// SPDX-License-Identifier: Apache-2.0
#include "step/device_port.hpp"

#include "host/guard.hpp"

namespace swage::step {

void show(host::DeviceSlot& slot, uint64_t step, const swage_sight& sight) noexcept {
  if (slot.sight == nullptr) return;
  host::Instance& instance = *slot.instance;
  host::guarded(instance, host::Call::kExchange, step,
                [&] { return slot.sight->look(instance.raw, &sight); });
}

swage_command no_force(double time_s) noexcept {
  swage_command out{};
  out.time_s = time_s;
  out.anchor.q.w = 1;
  return out;
}

void exchange(host::DeviceSlot& slot, uint64_t step, const swage_command& command, swage_sample& sample) noexcept {
  host::Instance& instance = *slot.instance;
  const swage_sample last = sample;
  const bool good = host::guarded(instance, host::Call::kExchange, step,
                                  [&] { return slot.device->exchange(instance.raw, &command, &sample); });
  if (!good) sample = last;
}

}  // namespace swage::step
