// SPDX-License-Identifier: Apache-2.0
//
// Another object, used through its traits. Couplings and lessons use objects in this way, without knowing
// their class.
#pragma once

#include <swage/abi/object.h>
#include <swage/step.hpp>

#include <optional>

namespace swage {

/// An object of another plugin. Cheap to copy; keep it from bind() on.
class Peer {
 public:
  Peer() = default;
  explicit Peer(swage_instance* raw)
      : raw_(raw),
        graspable_(table<swage_graspable>(raw, SWAGE_TRAIT_GRASPABLE)),
        gripper_(table<swage_gripper>(raw, SWAGE_TRAIT_GRIPPER)),
        piercing_(table<swage_piercing>(raw, SWAGE_TRAIT_PIERCING)),
        pierceable_(table<swage_pierceable>(raw, SWAGE_TRAIT_PIERCEABLE)) {}

  bool graspable() const { return graspable_ != nullptr; }
  bool gripper() const { return gripper_ != nullptr; }
  /// Whether it offers a trait at all. [main]
  bool has(const char* trait) const { return raw_ != nullptr && raw_->get_extension(raw_, trait) != nullptr; }
  /// The table of any trait, or nullptr. [main]
  template <class Table>
  const Table* trait(const char* id) const {
    return table<Table>(raw_, id);
  }

  /// Place on its centre line nearest to p_W; empty when the call fails. [rt]
  std::optional<swage_graspable_place> locate(const Step& step, swage_vec3 p_W) const SWAGE_RT {
    swage_graspable_place place{};
    if (graspable_ == nullptr || graspable_->locate(raw_, step.raw(), p_W, &place) != SWAGE_OK)
      return std::nullopt;
    return place;
  }
  /// State of its jaws; empty when the call fails. [rt]
  std::optional<swage_gripper_state> describe(const Step& step) const SWAGE_RT {
    swage_gripper_state state{};
    if (gripper_ == nullptr || gripper_->describe(raw_, step.raw(), &state) != SWAGE_OK) return std::nullopt;
    return state;
  }

  /// Place at s of an object with the trait piercing; empty when the call fails. [rt]
  std::optional<swage_piercing_place> place(const Step& step, double s) const SWAGE_RT {
    swage_piercing_place place{};
    if (piercing_ == nullptr || piercing_->place(raw_, step.raw(), s, &place) != SWAGE_OK)
      return std::nullopt;
    return place;
  }
  /// Place nearest to p_W of such an object. [rt]
  std::optional<swage_piercing_place> nearest(const Step& step, swage_vec3 p_W) const SWAGE_RT {
    swage_piercing_place place{};
    if (piercing_ == nullptr || piercing_->nearest(raw_, step.raw(), p_W, &place) != SWAGE_OK)
      return std::nullopt;
    return place;
  }
  /// Properties of a pierceable object. [rt]
  std::optional<swage_pierceable_law> law(const Step& step) const SWAGE_RT {
    swage_pierceable_law law{};
    if (pierceable_ == nullptr || pierceable_->law(raw_, step.raw(), &law) != SWAGE_OK) return std::nullopt;
    return law;
  }
  /// Place of p_W in a pierceable object. [rt]
  std::optional<swage_pierceable_place> inside(const Step& step, swage_vec3 p_W) const SWAGE_RT {
    swage_pierceable_place place{};
    if (pierceable_ == nullptr || pierceable_->locate(raw_, step.raw(), p_W, &place) != SWAGE_OK)
      return std::nullopt;
    return place;
  }

  swage_instance* raw() const { return raw_; }

 private:
  template <class Table>
  static const Table* table(swage_instance* raw, const char* id) {
    return raw == nullptr ? nullptr : static_cast<const Table*>(raw->get_extension(raw, id));
  }

  swage_instance* raw_ = nullptr;
  const swage_graspable* graspable_ = nullptr;
  const swage_gripper* gripper_ = nullptr;
  const swage_piercing* piercing_ = nullptr;
  const swage_pierceable* pierceable_ = nullptr;
};

}  // namespace swage
