// SPDX-License-Identifier: Apache-2.0
#include "step/flexible_body_adapter.hpp"

#include <algorithm>

#include "host/guard.hpp"
#include "host/tables.hpp"
#include "scene/view.hpp"
#include "step/limits.hpp"

namespace swage::step {

FlexibleBodyAdapter::FlexibleBodyAdapter(host::ObjectSlot& slot, uint32_t object,
                                         const swage_object_step& view, const scene::World& world)
    : slot_(slot), object_(object), view_(view), local_(std::max(world.capacity.points, 2 * (world.capacity.contacts + world.capacity.ties))) {
  std::string gap;  // a table with gaps counts as none
  const auto* band = host::find_table<swage_band>(*slot.instance, SWAGE_EXT_BAND, false, gap);
  const auto chain = [&](const scene::Shape& s) { return s.object == object && s.kind == SWAGE_SHAPE_CHAIN; };
  const auto first = std::find_if(world.shape.begin(), world.shape.end(), chain);
  if (band == nullptr || slot.solver_2 == nullptr || slot.body.count != 1 ||
      std::count_if(world.shape.begin(), world.shape.end(), chain) != 1)
    return;
  band_ = band;
  unknowns_ = SWAGE_BAND_UNKNOWNS * static_cast<uint32_t>(world.chain[first->chain].start.size());
}

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
  const bool given = host::guarded(instance, host::Call::kMobility, step, [&] {
    if (slot_.solver_2 == nullptr)
      return slot_.solver->mobility(instance.raw, &view_, n, local_.data(), v_free, W);
    return slot_.solver_2->mobility(instance.raw, &view_, n, local_.data(), place_.data(), v_free, W);
  });
  return given && host::accept(instance, host::Call::kMobility, step, v_free, 3 * n, kMaxSpeed) &&
         host::accept(instance, host::Call::kMobility, step, W, std::size_t{9} * n * n, kMaxMobility);
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
  host::guarded(instance, host::Call::kApplyImpulses, view_.step, [&] {
    if (slot_.solver_2 == nullptr)
      return slot_.solver->apply_impulses(instance.raw, &view_, n, local_.data(), impulse);
    return slot_.solver_2->apply_impulses(instance.raw, &view_, n, local_.data(), place_.data(), impulse);
  });
}

bool FlexibleBodyAdapter::linearise(uint32_t stiffer, double* stiffness, double* gradient) noexcept {
  host::Instance& instance = *slot_.instance;
  // the host asks again, up to SWAGE_BAND_STIFFER times, where it cannot factor the answer: each time with the budget of a step
  if (stiffer > 0) instance.watch.renew();
  const bool given = host::guarded(instance, host::Call::kLinearise, view_.step, [&] {
    return band_->linearise(instance.raw, &view_, stiffer, stiffness, gradient);
  });
  return given && host::accept(instance, host::Call::kLinearise, view_.step, gradient, unknowns_, kAnyNumber);
}

bool FlexibleBodyAdapter::stiffness_is_sound(const double* stiffness) noexcept {
  return host::accept(*slot_.instance, host::Call::kLinearise, view_.step, stiffness, std::size_t{unknowns_} * SWAGE_BAND_COLUMN, kAnyNumber);
}

void FlexibleBodyAdapter::displace(const double* change, std::span<const swage_contact_point> point,
                                   const double* impulse) noexcept {
  const uint32_t n = local(point);
  host::Instance& instance = *slot_.instance;
  host::guarded(instance, host::Call::kDisplace, view_.step, [&] {
    return band_->displace(instance.raw, &view_, change, n, local_.data(), place_.data(), impulse);
  });
}

}  // namespace swage::step
