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

void LockstepPort::read(uint64_t step, double time_s, swage_sample& sample) noexcept {
  swage_command command{};
  command.time_s = time_s;
  command.anchor.q.w = 1;
  host::Instance& instance = *slot_.instance;
  const swage_sample last = sample;
  const bool given = host::guarded(instance, host::Call::kExchange, step,
                                   [&] { return slot_.device->exchange(instance.raw, &command, &sample); });
  if (!given) sample = last;
}

}  // namespace swage::step
