// SPDX-License-Identifier: Apache-2.0
#include "jaw_sensor.hpp"

#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "sensor/calibration_file.hpp"
#include "sentences.hpp"

namespace swage::jaw_sensor {

using sensor::Calibration;
using sensor::Measurement;
using sensor::now_s;
using sensor::Reading;

namespace {

// s, timeout for the first message: boards that restart when their port is opened need two
constexpr double kPatience = 4;
// a handle that rests for kRestStill within the first kRestLooked seconds is checked: is it open in the calibrated place?
constexpr double kRestLooked = 5, kRestStill = 0.5;  // s
constexpr double kStill = 20e-6;                     // m, ten times the sensor's resolution

}  // namespace

void JawSensor::build(const P& p, DeviceBuilder& builder) {
  settings_.port = p.port;
  settings_.bits_per_s = sensor::SerialPort::rates()[static_cast<std::size_t>(p.bits_per_s)];
  settings_.binary = p.dialect == Dialect::kBinary;
  settings_.foreign = p.dialect == Dialect::kForeign;
  settings_.rate_hz = p.rate;
  settings_.table = {p.format, sensor::unescaped(p.poll), sensor::unescaped(p.end), p.length, p.at, p.scale, p.offset};
  if (settings_.foreign)
    if (const std::string wrong = sensor::check_table(settings_.table); !wrong.empty()) builder.error("format", wrong);
  if (const std::string wrong = sensor::check_poses({p.volts[0], p.volts[1], p.volts[2]}, {}); !wrong.empty())
    builder.error("volts", say::kPoseOrder());
  given_ = !p.calibration.empty();
  if (!given_) return;
  if (const std::string wrong = sensor::load_calibration(p.calibration, calibration_); !wrong.empty())
    builder.error("calibration", wrong);
}

bool JawSensor::choose_port(sensor::LinkSettings& settings) {
  if (!settings.port.empty()) return true;
  const std::vector<std::string> all = sensor::serial_adapters();
  if (all.size() == 1) {
    settings.port = all[0];
    return true;
  }
  std::string list;
  for (const std::string& one : all) list += " " + one;
  refuse(all.empty() ? say::kNoAdapter() : say::kManyAdapters(list));
  return false;
}

// waits until the sensor has reported its serial number, or at least a measurement
bool JawSensor::hear_it() {
  Measurement m;
  bool heard = false;
  for (const double until = now_s() + kPatience; now_s() < until;) {
    while (link_.next(now_s(), m)) heard = true;
    const bool named = !link_.info("serial").empty();
    if (heard && (named || settings_.foreign)) return true;
    if (!link_.plugged()) break;
    const timespec pause{0, 2'000'000};
    nanosleep(&pause, nullptr);
  }
  if (heard) return true;
  refuse(link_.bad() > 0 ? say::kOtherDialect(settings_.port, settings_.bits_per_s) : say::kSilent(settings_.port, settings_.bits_per_s));
  return false;
}

void JawSensor::open() {
  filled_ = measured_ = warned_ = gauge_ = false;
  in_use_.clear();
  sensor::LinkSettings settings = settings_;
  if (!choose_port(settings)) return;
  if (const std::string why = link_.open(settings); !why.empty()) return refuse(why);
  if (!hear_it()) return link_.close();
  serial_ = link_.info("serial");
  connection_ = link_.connections();
  calibrate();
  still_since_ = now_s();
  rest_until_ = in_use_.empty() ? 0 : still_since_ + kRestLooked;
  still_low_ = 1, still_high_ = -1;
}

// once, at the start of a session, if the calibration knows the open pose
void JawSensor::watch_rest(double now) {
  if (now > rest_until_ || !measured_) return;
  still_low_ = std::min(still_low_, length_), still_high_ = std::max(still_high_, length_);
  if (still_high_ - still_low_ > kStill) {
    still_low_ = still_high_ = length_;
    still_since_ = now;
  }
  if (now - still_since_ < kRestStill) return;
  rest_until_ = 0;
  if (const std::string trouble = sensor::rest_trouble(poses_, length_, gauge_ ? raw_force_ - gauge_zero_ : 0); !trouble.empty()) warn(trouble);
}

void JawSensor::calibrate() {
  const std::string path = sensor::calibration_path(serial_);
  if (!given_ && !path.empty() && access(path.c_str(), R_OK) == 0)
    if (const std::string wrong = sensor::load_calibration(path, calibration_); !wrong.empty()) warn(wrong);
  Calibration use_this = calibration_;
  if (use_this.displacement.valid() && !use_this.poses.known())
    warn(say::kNoPoses());
  if (!use_this.displacement.valid() || !use_this.poses.known()) {
    if (!use_this.displacement.valid())
      note(say::kNotCalibrated(serial_.empty() ? say::kNoSerial() : serial_));
    use_this = {};
    use_this.displacement.slope = 1;
    const auto& v = params().volts;
    use_this.poses = {v[0], v[1], v[2]};
    return use(use_this);
  }
  if (const std::string trouble = sensor::calibration_trouble(use_this, serial_, sensor::today()); !trouble.empty()) warn(trouble);
  char worst[32];
  std::snprintf(worst, sizeof worst, "%.0f", 1e6 * use_this.displacement.worst);
  note(say::kCalibrated(use_this.serial, use_this.date, use_this.by, worst, use_this.poses_date,
                        use_this.force.empty() ? say::kNoForces() : say::kByTravel(), use_this.tip.empty() ? "" : say::kByTips(),
                        use_this.poses_date == sensor::today() ? "" : say::kMeasureAnew()));
  in_use_ = sensor::calibration_text(use_this);
  use(use_this);
}

void JawSensor::use(const Calibration& calibration) {
  displacement_ = calibration.displacement;
  force_known_ = params().force == Force::kTravel && !calibration.force.empty();
  tip_known_ = !calibration.tip.empty();
  poses_ = calibration.poses;
  gauge_zero_ = calibration.gauge_zero;
  handle_.set(calibration, params().meets, {params().held, params().held_at});
}

// Another sensor would be read with the wrong calibration: its measurements are ignored.
bool JawSensor::is_the_one() {
  if (connection_ != link_.connections()) {
    connection_ = link_.connections();
    filled_ = false;
    warned_ = false;
  }
  if (serial_.empty() || settings_.foreign) return true;
  const std::string& now = link_.info("serial");
  if (now == serial_) return true;
  if (!now.empty() && !warned_) {
    warned_ = true;
    warn(say::kOtherSensor(now, serial_));
  }
  return false;
}

void JawSensor::take(const Measurement& m) {
  if (m.kind == Reading::kGrip) {
    gauge_ = (m.status & sensor::kNoMeasurement) == 0;
    if (gauge_) raw_force_ = m.value, force_ = std::max(0.0, m.value - gauge_zero_);
    return;
  }
  // no sensor of this kind gives more than 20 V
  measured_ = (m.status & sensor::kNoMeasurement) == 0 && std::abs(m.value) <= 20;
  if (!measured_) {
    filled_ = false;
    return;
  }
  volts_ = m.value;
  const double length = displacement_.length(m.value), dt = m.time_s - last_s_;
  const double share = filled_ && params().smoothing > 0 ? 1 - std::exp(-std::max(0.0, dt) / params().smoothing) : 1;
  length_ = filled_ ? length_ + share * (length - length_) : length;
  last_s_ = m.time_s;
  filled_ = true;
}

void JawSensor::exchange(const swage_command&, swage_sample& sample) {
  Measurement m;
  bool came = false;
  double when = 0;
  while (link_.next(now_s(), m)) {
    if (!is_the_one()) continue;
    take(m);
    came |= m.kind == Reading::kJaw;
    when = m.time_s;
  }
  if (!came) return;
  sample.sequence += 1;
  sample.time_s = std::max(sample.time_s, when);
  sample.valid = 0;
  watch_rest(now_s());
  if (!measured_) return;
  const sensor::Handle::Grip grip = handle_.at(length_);
  sample.closure = grip.closure;
  sample.valid |= SWAGE_VALID_CLOSURE;
  const bool gauge = params().force == Force::kGauge && gauge_;
  if (!gauge && !force_known_) return;
  const double handle = gauge ? force_ : grip.force;
  sample.grip_force = tip_known_ ? handle_.tip(handle) / params().handle_ratio : handle;
  sample.valid |= SWAGE_VALID_GRIP;
}

}  // namespace swage::jaw_sensor

SWAGE_EXPORT(swage::jaw_sensor::JawSensor)
