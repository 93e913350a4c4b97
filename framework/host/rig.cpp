// SPDX-License-Identifier: Apache-2.0
#include "host/rig.hpp"

namespace swage::host {

Rig::Rig() : shared{&world, &attempt} {}

Rig::~Rig() {
  // the reverse of the order of creation; the lesson may read objects until it is destroyed
  lesson.instance.reset();
  while (!couplings.empty()) couplings.pop_back();
  while (!objects.empty()) objects.pop_back();
  while (!devices.empty()) devices.pop_back();
}

std::vector<Instance*> instances(const Rig& rig) {
  std::vector<Instance*> all;
  for (const ObjectSlot& slot : rig.objects) all.push_back(slot.instance.get());
  for (const CouplingSlot& slot : rig.couplings) all.push_back(slot.instance.get());
  for (const DeviceSlot& slot : rig.devices) all.push_back(slot.instance.get());
  if (rig.lesson.instance) all.push_back(rig.lesson.instance.get());
  return all;
}

bool activate(Rig& rig, base::Problems& problems) {
  bool good = true;
  for (Instance* instance : instances(rig)) {
    std::string error;
    if (!instance->activate(rig.world.dt, error)) {
      problems.push_back({base::Severity::kError, instance->name, error});
      good = false;
    }
    for (base::Problem& p : instance->services->take_reports()) problems.push_back(std::move(p));
  }
  return good;
}

void set_budgets(Rig& rig, double seconds) {
  for (Instance* instance : instances(rig)) instance->watch.budget_ns = static_cast<int64_t>(seconds * 1e9);
  for (DeviceSlot& slot : rig.devices)
    slot.instance->watch.may_wait = (slot.device->flags & SWAGE_DEVICE_LOCKSTEP) == 0;
}

void renew_budgets(Rig& rig) noexcept {
  for (ObjectSlot& slot : rig.objects) slot.instance->watch.renew();
  for (CouplingSlot& slot : rig.couplings) slot.instance->watch.renew();
}

}  // namespace swage::host
