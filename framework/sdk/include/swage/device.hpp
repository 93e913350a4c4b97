// SPDX-License-Identifier: Apache-2.0
//
// A device: returns samples and, when it can, takes forces. It owns no thread and needs no lock: the host calls
// exchange() on a thread of its own and carries the samples to the step; a LOCKSTEP device is called in the
// step itself.
//
//   class Pen final : public swage::Device<PenParams> {
//    public:
//     static constexpr swage::DeviceCard card{.flags = SWAGE_DEVICE_FORCE, .rate_hz = 1000, .max_force
//     = 3.3};
//     ...
//   };
#pragma once

#include <swage/abi/device.h>
#include <swage/plugin.hpp>

namespace swage {

/// Capabilities of a device; static.
struct DeviceCard {
  uint32_t flags = 0;     // SWAGE_DEVICE_*
  double rate_hz = 1000;  // preferred rate of exchange
  double max_force = 0;   // N, upper bound; 0 without SWAGE_DEVICE_FORCE
};

namespace detail {
template <class T>
struct DeviceTables;
}

/// Base of every device plugin.
template <class P = NoParams>
class Device : public WithParams<P> {
 public:
  using Kind = Device;
  using Builder = DeviceBuilder;
  template <class T>
  using Tables = detail::DeviceTables<T>;
  static constexpr int32_t kKind = SWAGE_KIND_DEVICE;

  /// Checks the parameters; files are read here. [main]
  virtual void build(const P& params, DeviceBuilder& builder) {
    static_cast<void>(params);
    static_cast<void>(builder);
  }
  /// Opens the hardware; refuse() reports why that failed. [main]
  virtual void open() {}
  virtual void close() {}
  /// Takes the command, writes the newest sample; leaves `sample` unchanged when there is none. [io, or rt
  /// when LOCKSTEP]
  virtual void exchange(const swage_command& command, swage_sample& sample) = 0;
};

namespace detail {

inline constexpr Entry kOpen{"open", 16, kMain, When::kActive};
inline constexpr Entry kClose{"close", 17, kMain, When::kActive};
inline constexpr Entry kExchange{"exchange", 18, kIo, When::kActive};
inline constexpr Entry kExchangeRt{"exchange", 18, kRt, When::kActive};

/// The table that device T offers.
template <class T>
struct DeviceTables {
  static constexpr const char* no_traits[] = {nullptr};
  static constexpr const char* const* traits = no_traits;
  static constexpr const Entry& exchange_entry() {
    return (T::card.flags & SWAGE_DEVICE_LOCKSTEP) != 0 ? kExchangeRt : kExchange;
  }

  static swage_result open(swage_instance* i) noexcept {
    return guarded<T>(i, kOpen, [](typename T::Kind& plugin, auto&) { plugin.open(); });
  }
  static void close(swage_instance* i) noexcept {
    guarded<T>(i, kClose, [](typename T::Kind& plugin, auto&) { plugin.close(); });
  }
  static swage_result exchange(swage_instance* i, const swage_command* command, swage_sample* out) noexcept {
    return guarded<T>(i, exchange_entry(),
                      [&](typename T::Kind& plugin, auto&) { plugin.exchange(*command, *out); });
  }

  static const void* find(const char* id) {
    static_assert(
        requires { uint32_t{T::card.flags}; },
        "a device says what it can: static constexpr swage::DeviceCard card{.rate_hz = 1000}");
    static_assert(T::card.rate_hz > 0, "a device is asked at a rate above zero");
    static_assert(((T::card.flags & SWAGE_DEVICE_FORCE) != 0) == (T::card.max_force > 0),
                  "max_force is above zero exactly when the device takes forces");
    static constexpr swage_device table{T::card.flags, 0,     T::card.rate_hz, T::card.max_force,
                                        open,          close, exchange};
    return same(id, SWAGE_EXT_DEVICE) ? &table : nullptr;
  }
};

}  // namespace detail

}  // namespace swage
