// SPDX-License-Identifier: Apache-2.0
//
// A device with signals of its own: its battery, a temperature, raw volts. Recorded with the attempt and shown, never part of the scene.
//
//   class Pen final : public swage::TellingDevice<PenParams> {
//    public:
//     static constexpr std::array told{swage::DeviceSignal{"pen.battery", "1", "Charge of its battery."}};
//     void tell(std::span<double> out) override { out[0] = charge_; }
//     ...
//   };
#pragma once

#include <swage/abi/device_signals.h>
#include <swage/device.hpp>

#include <limits>
#include <span>

namespace swage {

inline constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

using DeviceSignal = swage_device_signal;  // id, unit, doc

namespace detail {
template <class T, class Base>
struct TellingDeviceTables;
}

/// Base of a device with signals. `Base`: its other base class, e.g. CalibratedDevice<P>.
template <class P = NoParams, class Base = Device<P>>
class TellingDevice : public Base {
 public:
  using Kind = TellingDevice;
  template <class T>
  using Tables = detail::TellingDeviceTables<T, typename Base::template Tables<T>>;

  /// Writes the values of `told`, in its order; kNotKnown where a value is unknown. [io, or rt when LOCKSTEP] right after exchange()
  virtual void tell(std::span<double> out) = 0;
};

namespace detail {

inline constexpr Entry kTell{"tell", 38, kIo, When::kActive};
inline constexpr Entry kTellRt{"tell", 38, kRt, When::kActive};

template <class T, class Base>
struct TellingDeviceTables : Base {
  static swage_result read(swage_instance* i, double* out) noexcept {
    constexpr const Entry& entry = (T::card.flags & SWAGE_DEVICE_LOCKSTEP) != 0 ? kTellRt : kTell;
    return guarded<T>(i, entry, [&](typename T::Kind& plugin, auto&) { plugin.tell({out, T::told.size()}); });
  }

  static const void* find(const char* id) {
    static_assert(T::told.size() >= 1 && T::told.size() <= SWAGE_MOST_DEVICE_SIGNALS, "a device tells one to eight signals");
    static constexpr swage_device_signals table{static_cast<uint32_t>(T::told.size()), 0, T::told.data(), read};
    return same(id, SWAGE_EXT_DEVICE_SIGNALS) ? static_cast<const void*>(&table) : Base::find(id);
  }
};

}  // namespace detail

}  // namespace swage
