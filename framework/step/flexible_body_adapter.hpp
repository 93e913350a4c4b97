// SPDX-License-Identifier: Apache-2.0
//
// A flexible body for the contact solve: calls the plugin's swage.object.solver/1 or /2, and
// swage.object.band/1, behind the guard.
#pragma once

#include <swage/abi/band.h>

#include <vector>

#include "dynamics/flexible_body.hpp"
#include "host/rig.hpp"

namespace swage::step {

class FlexibleBodyAdapter final : public dynamics::FlexibleBody {
 public:
  /// `view`: the object's, kept up to date by the step. [main]
  FlexibleBodyAdapter(host::ObjectSlot& slot, uint32_t object, const swage_object_step& view,
                      const scene::World& world);

  uint32_t object() const noexcept override { return object_; }
  bool surface_is_shape() const noexcept override { return slot_.surface == nullptr; }
  bool displaces() const noexcept override { return slot_.surface != nullptr; }
  void locate(std::span<const swage_chain_place> place) noexcept override { place_ = place; }
  bool mobility(std::span<const swage_contact_point> point, double* v_free, double* W) noexcept override;
  bool displacement(std::span<const swage_contact_point> point, double* u_W) noexcept override;
  void apply_impulses(std::span<const swage_contact_point> point, const double* impulse) noexcept override;
  bool banded() const noexcept override { return band_ != nullptr; }
  bool linearise(uint32_t stiffer, double* stiffness, double* gradient) noexcept override;
  bool stiffness_is_sound(const double* stiffness) noexcept override;
  void displace(const double* change, std::span<const swage_contact_point> point,
                const double* impulse) noexcept override;

 private:
  uint32_t local(std::span<const swage_contact_point> point) noexcept;

  host::ObjectSlot& slot_;
  const uint32_t object_;
  const swage_object_step& view_;
  const swage_band* band_ = nullptr;  // of an object whose one chain is a band
  uint32_t unknowns_ = 0;             // unknowns of that band
  std::vector<swage_contact_point> local_;  // the points in the object's own indices
  std::span<const swage_chain_place> place_;  // their places on chains
};

}  // namespace swage::step
