// SPDX-License-Identifier: Apache-2.0
//
// swage.device.jaw_sensor: a displacement sensor in the handle of a needleholder, on a serial port (thesis chapter 3, appendix B). It
// measures closure and force of the jaws; the pose comes from another device. See jaw_sensor.md.
#pragma once

#include <swage/calibrated.hpp>
#include <swage/device_signals.hpp>

#include <array>

#include "sensor/calibration.hpp"
#include "sensor/sensor_link.hpp"

namespace swage::jaw_sensor {

enum class Dialect : int32_t { kLine, kBinary, kForeign };
enum class Force : int32_t { kTravel, kGauge, kJaws };

struct JawSensorParams {
  std::string port, calibration;
  int32_t bits_per_s = 4;  // 115200
  Dialect dialect = Dialect::kLine;
  double rate = 0;  // Hz
  Force force = Force::kTravel;
  std::array<double, 3> volts = {2, -1, -2};  // V: open, just closed, squeezed
  double meets = 0.6;
  double held = 0.1e-3, held_at = 9e-3;  // m
  double handle_ratio = 0.2;             // N at the tips per N at the handle
  double smoothing = 5.3e-3;             // s: 30 Hz
  std::string poll, end = "\\r";
  sensor::ForeignTable::Format format = sensor::ForeignTable::kText;
  int32_t length = 0, at = 0;
  double scale = 1, offset = 0;  // V per unit, V
};

inline constexpr const char* kRates[] = {"9600",   "19200",  "38400",  "57600",   "115200",
                                         "230400", "460800", "921600", "1000000", nullptr};
inline constexpr const char* kDialects[] = {"line", "binary", "foreign", nullptr};
inline constexpr const char* kForces[] = {"travel", "gauge", "jaws", nullptr};
inline constexpr const char* kFormats[] = {"text",   "u16_big_endian",    "u16_little_endian", "i16_big_endian",
                                           "i16_little_endian", "i24_big_endian", nullptr};

class JawSensor final : public TellingDevice<JawSensorParams, CalibratedDevice<JawSensorParams>> {
 public:
  using P = JawSensorParams;
  static constexpr auto id = "swage.device.jaw_sensor";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Jaw sensor";
  static constexpr auto summary =
      "A displacement sensor in the handle of a real needleholder, on a serial port: how far the jaws are closed, and how hard.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";
  static constexpr DeviceCard card{.rate_hz = 1000};

  static constexpr std::array fields = {
      text<&P::port>("port", "Port", "Serial port by its lasting name, /dev/serial/by-id/...; empty: the only one that there is."),
      choice<&P::bits_per_s>("bits_per_s", "Bits per second", kRates, "Of the port; 230400 or more for frames at 1 kHz."),
      choice<&P::dialect>("dialect", "Dialect", kDialects,
                          "JAW1 in lines or in frames (binary), or a reader with a protocol of its own (foreign)."),
      real<&P::rate>("rate", "Rate", "Hz", "Hz", 0, 2000, "Asked of the sensor; 0: as it is set. A foreign reader is polled so often."),
      file<&P::calibration>("calibration", "Calibration",
                            "Format swage-calibration/1; empty: the stored one of the sensor's serial number."),
      choice<&P::force>("force", "Force from", kForces,
                        "Travel: the further travel after contact, by the calibrated table. Gauge: a strain gauge on the handle. Jaws: "
                        "the instrument's own law, from the closure."),
      vector<&P::volts>("volts", "Volts", "1", "1", -20, 20,
                        "Open, just closed and squeezed, in V, of a sensor without a calibration."),
      real<&P::meets>("meets", "Jaws meet at", "1", "1", 0.05, 0.95,
                      "Closure at which the empty jaws of the scene meet: opening/2 over opening/2 + squeeze of the needleholder."),
      real<&P::held>("held", "Held width", "m", "mm", 0, 10e-3,
                     "Width of what is held: the jaws touch it earlier than they would meet."),
      real<&P::held_at>("held_at", "Held at", "m", "mm", 1e-3, 0.1, "From the pivot to where it is held."),
      real<&P::handle_ratio>("handle_ratio", "Tip force per handle force", "1", "1", 0.001, 10,
                             "Of the needleholder in the scene; a calibrated force at the tips is told as what makes it there."),
      real<&P::smoothing>("smoothing", "Smoothing", "s", "ms", 0, 0.1, "Time constant of the low pass; 5.3 ms is 30 Hz."),
      text<&P::poll>("poll", "Poll", "Bytes that ask a foreign reader for a message, \\r and \\x1b as in C; empty: it speaks unasked.")
          .group("Foreign reader"),
      text<&P::end>("end", "End", "Bytes that end its message.").group("Foreign reader"),
      choice<&P::format>("format", "Format", kFormats, "Of the number in its message.").group("Foreign reader"),
      integer<&P::length>("length", "Length", 0, 120, "Bytes of its message with the end, when it is no text.").group("Foreign reader"),
      integer<&P::at>("at", "At", 0, 119, "Byte at which the number begins; of text: which number, counted from 0.").group("Foreign reader"),
      real<&P::scale>("scale", "Scale", "1", "1", -1e6, 1e6, "Volts per unit of the number.").group("Foreign reader"),
      real<&P::offset>("offset", "Offset", "1", "1", -1e3, 1e3, "Volts of the number 0.").group("Foreign reader"),
  };

  void build(const P& params, DeviceBuilder& builder) override;
  void open() override;
  void close() override { link_.close(); }
  void exchange(const swage_command& command, swage_sample& sample) override;

  static constexpr std::array told{DeviceSignal{"sensor.volts", "V", "What the displacement sensor measures, before any calibration."}};
  void tell(std::span<double> out) override { out[0] = measured_ && link_.plugged() ? volts_ : kNotKnown; }

  std::string_view calibration() const override { return in_use_; }

  const sensor::SensorLink& link() const { return link_; }

 private:
  bool choose_port(sensor::LinkSettings& settings);
  bool hear_it();
  void calibrate();
  void use(const sensor::Calibration& calibration);
  void take(const sensor::Measurement& measurement);
  bool is_the_one();
  void watch_rest(double now);

  sensor::LinkSettings settings_;
  sensor::SensorLink link_;
  sensor::Calibration calibration_;
  std::string in_use_;  // calibration in use as JSON; "" without one, when `volts` are the three poses
  sensor::Displacement displacement_;
  sensor::Handle handle_;
  bool given_ = false, force_known_ = false, tip_known_ = false;
  std::string serial_;  // serial number of the sensor at the start of the lesson
  uint32_t connection_ = 0;
  sensor::Poses poses_;
  double gauge_zero_ = 0;                          // N
  double rest_until_ = 0, still_since_ = 0;        // s; end of the period in which a resting handle is checked; begin of the present rest
  double still_low_ = 0, still_high_ = 0;          // m
  bool warned_ = false, filled_ = false, measured_ = false, gauge_ = false;
  double volts_ = 0, length_ = 0, force_ = 0, raw_force_ = 0, last_s_ = 0;  // V, m, N, N, s
};

}  // namespace swage::jaw_sensor
