// SPDX-License-Identifier: Apache-2.0
//
// A device that observes the scene before it returns a sample: a scripted hand that aims at the real positions.
//
//   class Surgeon final : public swage::SeeingDevice<SurgeonParams> {
//    public:
//     static constexpr swage::DeviceCard card{.flags = SWAGE_DEVICE_LOCKSTEP | SWAGE_DEVICE_WORLD};
//     ...
//   };
#pragma once

#include <swage/abi/sight.h>
#include <swage/device.hpp>
#include <swage/lesson.hpp>

namespace swage {

/// The present scene: all that a lesson sees, and the positions of the lesson's point marks. [rt]
class Sight {
 public:
  explicit Sight(const swage_sight* raw) : raw_(raw) {}
  View view() const { return View(raw_->view); }
  /// Position of a point mark, m in W. `mark`: index as in bind().
  const swage_vec3& mark(uint32_t mark) const {
    assert(mark < raw_->n_mark);
    return raw_->mark_p_W[mark];
  }

 private:
  const swage_sight* raw_;
};

namespace detail {
template <class T>
struct SeeingDeviceTables;
}

/// Base of a LOCKSTEP device that observes the scene.
template <class P = NoParams>
class SeeingDevice : public Device<P> {
 public:
  using Kind = SeeingDevice;
  template <class T>
  using Tables = detail::SeeingDeviceTables<T>;

  /// Finds the objects and marks that it needs, by name; refuse() reports a missing one. [main]
  virtual void bind(const Scene& scene, std::span<const swage_scene_mark> marks) = 0;
  /// Observes the scene after the last step; exchange() follows. [rt]
  virtual void look(const Sight& sight) SWAGE_RT = 0;
};

namespace detail {

inline constexpr Entry kBindSight{"bind", 26, kMain, When::kReady};
inline constexpr Entry kLook{"look", 27, kRt, When::kActive};

template <class T>
struct SeeingDeviceTables : DeviceTables<T> {
  static swage_result bind(swage_instance* i, const swage_sight_card* card) noexcept {
    return guarded<T>(i, kBindSight, [&](typename T::Kind& plugin, auto&) {
      plugin.bind(Scene(card->scene), {card->mark, card->n_mark});
    });
  }
  static swage_result look(swage_instance* i, const swage_sight* sight) noexcept {
    return guarded<T>(i, kLook, [&](typename T::Kind& plugin, auto&) { plugin.look(Sight(sight)); });
  }

  static const void* find(const char* id) {
    static_assert((T::card.flags & SWAGE_DEVICE_LOCKSTEP) != 0,
                  "a device that sees is asked in the step: LOCKSTEP");
    static constexpr swage_device_sight table{bind, look};
    return same(id, SWAGE_EXT_SIGHT) ? static_cast<const void*>(&table) : DeviceTables<T>::find(id);
  }
};

}  // namespace detail

}  // namespace swage
