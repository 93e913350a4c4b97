// SPDX-License-Identifier: Apache-2.0
#include "step/flexible_body_adapter.hpp"

#include <algorithm>

#include "host/guard.hpp"
#include "scene/view.hpp"
#include "step/limits.hpp"

namespace swage::step {

FlexibleBodyAdapter::FlexibleBodyAdapter(host::ObjectSlot& slot, uint32_t object,
                                         const swage_object_step& view, uint32_t capacity)
    : slot_(slot), object_(object), view_(view), local_(capacity) {}

uint32_t FlexibleBodyAdapter::local(std::span<const swage_contact_point> point) noexcept {
  const auto n = static_cast<uint32_t>(std::min(point.size(), local_.size()));
  for (uint32_t i = 0; i < n; ++i) {
    local_[i] = point[i];
    local_[i].body = scene::local(slot_.body, point[i].body);
    local_[i].shape = scene::local(slot_.shape, point[i].shape);
  }
  return n;
}

bool FlexibleBodyAdapter::mobility(std::span<const swage_contact_point> point, double* v_free,
                                   double* W) noexcept {
  const uint32_t n = local(point);
  if (n != point.size() || (slot_.solver_2 != nullptr && n != place_.size())) return false;
  host::Instance& instance = *slot_.instance;
  const uint64_t step = view_.step;
  const bool given = host::guarded(instance, host::Call::kCompliance, step, [&] {
    if (slot_.solver_2 == nullptr)
      return slot_.solver->compliance(instance.raw, &view_, n, local_.data(), v_free, W);
    return slot_.solver_2->compliance(instance.raw, &view_, n, local_.data(), place_.data(), v_free, W);
  });
  return given && host::accept(instance, host::Call::kCompliance, step, v_free, 3 * n, kMaxSpeed) &&
         host::accept(instance, host::Call::kCompliance, step, W, std::size_t{9} * n * n, kMaxMobility);
}

bool FlexibleBodyAdapter::displacement(std::span<const swage_contact_point> point, double* u_W) noexcept {
  if (slot_.surface == nullptr) return true;
  const uint32_t n = local(point);
  host::Instance& instance = *slot_.instance;
  const bool given = host::guarded(instance, host::Call::kDisplacement, view_.step, [&] {
    return slot_.surface->displacement(instance.raw, &view_, n, local_.data(), u_W);
  });
  return given && host::accept(instance, host::Call::kDisplacement, view_.step, u_W, 3 * n, kMaxPosition);
}

void FlexibleBodyAdapter::apply_impulses(std::span<const swage_contact_point> point,
                                         const double* impulse) noexcept {
  const uint32_t n = local(point);
  host::Instance& instance = *slot_.instance;
  host::guarded(instance, host::Call::kYield, view_.step, [&] {
    if (slot_.solver_2 == nullptr)
      return slot_.solver->yield(instance.raw, &view_, n, local_.data(), impulse);
    return slot_.solver_2->yield(instance.raw, &view_, n, local_.data(), place_.data(), impulse);
  });
}

}  // namespace swage::step
