// SPDX-License-Identifier: Apache-2.0
#include "sensor/bench.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "sensor/calibration_file.hpp"
#include "sensor/sentences.hpp"

namespace swage::sensor {

namespace {

constexpr int kFewest = 5;        // measurements of a mean: fewer would not show that the sensor moved meanwhile
// s beyond the time of a mean for which a sensor may say nothing: a busy machine delivers a second late what was measured in time.
// Longer, and a person waits for a sensor that is unplugged; shorter, and a busy machine reads as one.
constexpr double kPatience = 3;

}  // namespace

std::string Bench::open(const std::string& port, int bits_per_s) {
  LinkSettings settings;
  settings.port = port;
  settings.bits_per_s = bits_per_s;
  if (port.empty()) {
    const std::vector<std::string> all = serial_adapters();
    if (all.size() != 1) return say::kWhichPort(all.size());
    settings.port = all[0];
  }
  volts_.reset();
  measuring_ = false;
  port_ = settings.port;
  return link_.open(settings);
}

void Bench::listen(double now_s) {
  Measurement m;
  while (link_.next(now_s, m)) {
    const bool good = (m.status & kNoMeasurement) == 0;
    if (m.kind == Reading::kGrip && measuring_ && good) sum_gauge_ += m.value, ++n_gauge_;
    if (m.kind != Reading::kJaw) continue;
    volts_ = good ? std::optional(m.value) : std::nullopt;
    if (!measuring_) continue;
    if (first_s_ < 0) first_s_ = m.time_s;
    last_s_ = m.time_s;
    beyond_ |= !good;
    if (!good) continue;
    low_ = n_ == 0 ? m.value : std::min(low_, m.value);
    high_ = n_ == 0 ? m.value : std::max(high_, m.value);
    sum_ += m.value, ++n_;
  }
  const bool long_enough = first_s_ >= 0 && last_s_ - first_s_ >= seconds_ && (n_ >= kFewest || beyond_);
  if (long_enough || now_s >= until_s_) measuring_ = false;
}

void Bench::begin(double now_s, double seconds) {
  listen(now_s);  // drops measurements from before
  measuring_ = true;
  beyond_ = false;
  seconds_ = seconds;
  until_s_ = now_s + seconds + kPatience;
  first_s_ = last_s_ = -1;
  sum_ = sum_gauge_ = 0, n_ = n_gauge_ = 0;
}

std::string Bench::mean(double& volts) const {
  // 20 mV, 20 um: a hand or a bench that still moves gives no valid mean
  constexpr double kStill = 20e-3;
  if (beyond_) return say::kBeyondRange();
  if (n_ < kFewest) return say::kFewMeasurements(n_);
  if (high_ - low_ > kStill) return say::kMoved(std::lround(1e3 * (high_ - low_)));
  volts = sum_ / n_;
  return "";
}

Draft::Draft() {
  limits.nominal = 1e-3;
  for (int i = 0; i < kRows; ++i) rows_.push_back({kStep * i, {}});
}

std::string Draft::refit() {
  std::vector<BenchPoint> points;
  for (const Row& row : rows_)
    if (row.volts) points.push_back({*row.volts, row.length_m});
  Displacement found;
  std::string wrong = fit_displacement(points, limits, found);
  if (!wrong.empty()) {
    std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.length_m < b.length_m; });
    found = {};
    found.points = points;
  }
  fit_ = found;
  return wrong;
}

std::string Draft::begin_from(const std::string& path) {
  stored_.reset();
  if (path.empty()) return say::kNoFileName(serial);
  if (access(path.c_str(), F_OK) != 0) return "";
  Calibration c;
  std::string wrong = load_calibration(path, c);
  if (wrong.empty()) stored_ = c;
  return wrong;
}

bool Draft::any_length() const {
  return std::any_of(rows_.begin(), rows_.end(), [](const Row& row) { return row.volts.has_value(); });
}

std::optional<double> Draft::closed_length() const {
  if (pose_volts[1]) return in_use().length(*pose_volts[1]);
  // a new fit gives other lengths for the same pose
  if (stored_ && stored_->poses.known() && !any_length()) return stored_->poses.closed;
  return std::nullopt;
}

std::string Draft::forces(Calibration& out) const {
  std::vector<MonotoneCurve::Point> handle, tip;
  const std::optional<double> closed = closed_length();
  for (const ForceRow& row : force_rows) {
    if (!row.handle_N || !row.volts) continue;
    if (!closed) return say::kClosedFirst();
    handle.push_back({std::abs(*closed - in_use().length(*row.volts)), *row.handle_N});
  }
  if (handle.empty()) return "";
  if (std::string wrong = check_table_size(handle.size()); !wrong.empty()) return wrong;
  std::sort(handle.begin(), handle.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  MonotoneCurve force;
  if (std::string wrong = force.set(handle); !wrong.empty()) return wrong;
  for (const ForceRow& row : force_rows)
    if (row.handle_N && row.volts && row.tip_N) tip.push_back({*row.handle_N - force.value(0), *row.tip_N});
  MonotoneCurve tips;
  if (!tip.empty()) {
    if (std::string wrong = check_table_size(tip.size()); !wrong.empty()) return wrong;
    if (std::string wrong = set_tip(tip, tips); !wrong.empty()) return wrong;
  }
  out.force = force;
  out.tip = tips;
  out.check = {};  // it belonged to the former tables
  return "";
}

std::optional<TipCheck> Draft::tip_check(double volts, const std::string& today) const {
  Calibration c = stored_.value_or(Calibration{});
  const std::optional<double> closed = closed_length();
  if (!closed || !forces(c).empty() || c.tip.empty()) return std::nullopt;
  const double travel = std::abs(*closed - in_use().length(volts));
  return TipCheck{kCheckForce, c.tip.value(c.force.value(travel) - c.force.value(0)), today};
}

bool Draft::may_zero() const {
  const bool any_pose = std::any_of(pose_volts.begin(), pose_volts.end(), [](const auto& v) { return v.has_value(); });
  return stored_ && stored_->poses.known() && !any_length() && !any_pose;
}

std::string Draft::finish(const std::string& today, Calibration& out) const {
  if (by.empty()) return say::kWhoCalibrates();
  if (!in_use().valid()) return say::kNoFit();
  Calibration c = stored_.value_or(Calibration{});
  c.serial = serial;
  if (!name.empty()) c.name = name;
  c.by = by;
  const Poses before = c.poses;
  if (fit_.valid()) {
    c.date = today;
    c.expires = days_after(today, valid_days);
    c.displacement = fit_;
    c.poses = {};  // they were in lengths of the former fit
  }
  if (pose_volts[0] && pose_volts[1] && pose_volts[2]) {
    const Displacement& d = in_use();
    c.poses = {d.length(*pose_volts[0]), d.length(*pose_volts[1]), d.length(*pose_volts[2])};
    if (std::string wrong = check_poses(c.poses, fit_.valid() ? Poses{} : before); !wrong.empty()) return wrong;
    if (std::string wrong = check_geometry(c.geometry, c.poses); !wrong.empty()) return wrong;
    c.poses_date = today, c.zero_date.clear();
  } else if (zero_volts && may_zero()) {
    if (std::string wrong = set_zero(c.displacement.length(*zero_volts), c.poses); !wrong.empty()) return wrong;
    c.zero_date = today;
    c.gauge_zero = zero_gauge_N.value_or(c.gauge_zero);
  }
  if (std::string wrong = forces(c); !wrong.empty()) return wrong;
  if (check_volts)
    if (const std::optional<TipCheck> check = tip_check(*check_volts, today)) c.check = *check;
  out = c;
  return "";
}

}  // namespace swage::sensor
