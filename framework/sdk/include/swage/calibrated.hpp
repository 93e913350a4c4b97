// SPDX-License-Identifier: Apache-2.0
//
// A device that measures with a calibration, which the host keeps with every attempt.
//
//   class Gauge final : public swage::CalibratedDevice<GaugeParams> {
//    public:
//     std::string_view calibration() const override { return text_; }
//     ...
//   };
#pragma once

#include <swage/abi/calibration.h>
#include <swage/device.hpp>

namespace swage {

namespace detail {
template <class T>
struct CalibratedDeviceTables;
}

/// Base of a device with a calibration.
template <class P = NoParams>
class CalibratedDevice : public Device<P> {
 public:
  using Kind = CalibratedDevice;
  template <class T>
  using Tables = detail::CalibratedDeviceTables<T>;

  /// The calibration in use as JSON text, "" for none; read once after open() and valid until close(). [main]
  virtual std::string_view calibration() const = 0;
};

namespace detail {

inline constexpr Entry kCalibration{"calibration", 37, kMain, When::kActive};

template <class T>
struct CalibratedDeviceTables : DeviceTables<T> {
  static swage_str text(swage_instance* i) noexcept {
    swage_str out{nullptr, 0};
    guarded<T>(i, kCalibration, [&](typename T::Kind& plugin, auto&) { out = str(plugin.calibration()); });
    return out;
  }

  static const void* find(const char* id) {
    static constexpr swage_device_calibration table{text};
    return same(id, SWAGE_EXT_CALIBRATION) ? static_cast<const void*>(&table) : DeviceTables<T>::find(id);
  }
};

}  // namespace detail

}  // namespace swage
