// SPDX-License-Identifier: Apache-2.0
#include "sensor/calibration.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "sensor/sentences.hpp"

namespace swage::sensor {

namespace {

std::string digits(const char* format, double value) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string mm(double m) { return digits("%.3g mm", 1e3 * m); }

// least squares over points [first, last); stores the residuals in the points
Displacement line_through(std::vector<BenchPoint>& p, std::size_t first, std::size_t last) {
  const auto n = static_cast<double>(last - first);
  double v = 0, l = 0, vv = 0, vl = 0;
  for (std::size_t i = first; i < last; ++i) v += p[i].volts / n, l += p[i].length_m / n;
  for (std::size_t i = first; i < last; ++i) {
    vv += (p[i].volts - v) * (p[i].volts - v);
    vl += (p[i].volts - v) * (p[i].length_m - l);
  }
  Displacement out;
  if (vv <= 0) return out;
  out.slope = vl / vv;
  out.offset = l - out.slope * v;
  for (std::size_t i = 0; i < p.size(); ++i) {
    p[i].used = i >= first && i < last;
    p[i].residual_m = out.length(p[i].volts) - p[i].length_m;
    if (!p[i].used) continue;
    out.worst = std::max(out.worst, std::abs(p[i].residual_m));
    out.rms += p[i].residual_m * p[i].residual_m / n;
  }
  out.rms = std::sqrt(out.rms);
  return out;
}

std::string check_bench(std::vector<BenchPoint>& points, const FitLimits& limits) {
  if (points.size() < limits.fewest)
    return say::kFewPoints(limits.fewest, points.size());
  for (const BenchPoint& p : points)
    if (!std::isfinite(p.volts) || !std::isfinite(p.length_m)) return say::kNoPoint();
  std::sort(points.begin(), points.end(), [](const auto& x, const auto& y) { return x.length_m < y.length_m; });
  for (std::size_t i = 1; i < points.size(); ++i)
    if (points[i].length_m == points[i - 1].length_m) return say::kSameLength(mm(points[i].length_m));
  return "";
}

}  // namespace

std::string fit_displacement(std::vector<BenchPoint> points, const FitLimits& limits, Displacement& out) {
  if (std::string wrong = check_bench(points, limits); !wrong.empty()) return wrong;
  const std::size_t all = points.size();
  double nearest = 1e300;
  for (std::size_t n = all; n >= limits.fewest; --n) {
    // of equally long runs the first is kept unless a later one is better
    Displacement best;
    best.worst = 1e300;
    std::size_t at = 0;
    for (std::size_t first = 0; first + n <= all; ++first) {
      const Displacement fit = line_through(points, first, first + n);
      if (fit.valid() && fit.worst < best.worst) best = fit, at = first;
    }
    nearest = std::min(nearest, best.worst);
    if (best.worst > limits.worst) continue;
    if (limits.nominal > 0 && std::abs(std::abs(best.slope) - limits.nominal) > limits.most_off * limits.nominal)
      return say::kOtherSlope(digits("%.3g", 1e3 * best.slope), digits("%.3g", 1e3 * limits.nominal));
    out = line_through(points, at, at + n);
    out.points = points;
    return "";
  }
  return say::kNoLine(limits.fewest, mm(nearest), mm(limits.worst));
}

std::string MonotoneCurve::set(std::vector<Point> points) {
  points_.clear();
  slope_.clear();
  if (points.size() < 2 || points.size() > 64)
    return say::kForceCount(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(points[i].x) || !std::isfinite(points[i].y)) return say::kForceNoNumber();
    if (i > 0 && points[i].x <= points[i - 1].x) return say::kTravelFalls(mm(points[i].x));
    if (i > 0 && points[i].y < points[i - 1].y) return say::kForceFalls(mm(points[i].x));
  }
  points_ = std::move(points);
  const std::size_t n = points_.size();
  std::vector<double> h(n - 1), d(n - 1);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    h[i] = points_[i + 1].x - points_[i].x;
    d[i] = (points_[i + 1].y - points_[i].y) / h[i];
  }
  slope_.assign(n, 0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    if (d[i - 1] * d[i] <= 0) continue;
    const double w1 = 2 * h[i] + h[i - 1], w2 = h[i] + 2 * h[i - 1];
    slope_[i] = (w1 + w2) / (w1 / d[i - 1] + w2 / d[i]);
  }
  // at an end: slope of the parabola through three points, limited so that the curve stays monotone
  const auto end = [](double h0, double h1, double d0, double d1) {
    const double s = ((2 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
    if (s * d0 <= 0) return 0.0;
    return std::abs(s) > 3 * std::abs(d0) ? 3 * d0 : s;
  };
  slope_[0] = n == 2 ? d[0] : end(h[0], h[1], d[0], d[1]);
  slope_[n - 1] = n == 2 ? d[0] : end(h[n - 2], h[n - 3], d[n - 2], d[n - 3]);
  return "";
}

std::size_t MonotoneCurve::piece(double x) const {
  const auto after = std::upper_bound(points_.begin() + 1, points_.end() - 1, x,
                                      [](double value, const Point& p) { return value < p.x; });
  return static_cast<std::size_t>(after - points_.begin()) - 1;
}

double MonotoneCurve::value(double x) const {
  if (points_.empty()) return 0;
  if (!(x > points_.front().x)) return points_.front().y;
  if (x >= points_.back().x) return points_.back().y;
  const std::size_t i = piece(x);
  const double h = points_[i + 1].x - points_[i].x, t = (x - points_[i].x) / h;
  const double t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * points_[i].y + (t3 - 2 * t2 + t) * h * slope_[i] + (3 * t2 - 2 * t3) * points_[i + 1].y +
         (t3 - t2) * h * slope_[i + 1];
}

double MonotoneCurve::slope(double x) const {
  if (points_.empty() || x < points_.front().x || x > points_.back().x) return 0;
  const std::size_t i = piece(x);
  const double h = points_[i + 1].x - points_[i].x, t = (x - points_[i].x) / h;
  const double t2 = t * t;
  return 6 * (t - t2) * (points_[i + 1].y - points_[i].y) / h + (3 * t2 - 4 * t + 1) * slope_[i] + (3 * t2 - 2 * t) * slope_[i + 1];
}

std::string check_poses(const Poses& p, const Poses& stored) {
  if (!std::isfinite(p.open) || !std::isfinite(p.closed) || !std::isfinite(p.squeezed)) return say::kPoseNoNumber();
  // 20 um, ten times the sensor's resolution, is less than any movement of a hand
  constexpr double kLeast = 20e-6;
  const double way = p.open - p.closed, squeeze = p.closed - p.squeezed;
  if (std::abs(way) < kLeast) return say::kSamePoses(mm(kLeast));
  if (way * squeeze <= 0 || std::abs(squeeze) < kLeast)
    return say::kSqueezedBack(mm(p.open), mm(p.closed), mm(p.squeezed));
  if (!stored.known()) return "";
  const auto off = [](double now, double then) { return std::abs(now - then) > 0.2 * std::abs(then); };
  if (off(way, stored.open - stored.closed) || off(squeeze, stored.closed - stored.squeezed))
    return say::kOtherHolder(mm(stored.open - stored.closed), mm(stored.closed - stored.squeezed), mm(way), mm(squeeze));
  return "";
}

double closed_share(const Poses& p, double length) { return (p.open - length) / (p.open - p.closed); }

std::string set_zero(double length, Poses& p) {
  if (!p.known()) return say::kNoPoses();
  const double off = length - p.open;
  if (!(std::abs(closed_share(p, length)) <= kMostZeroShare))
    return say::kRestsElsewhere(mm(std::abs(off)), mm(std::abs(p.open - p.closed)));
  p.open += off, p.closed += off, p.squeezed += off;
  return "";
}

std::string rest_trouble(const Poses& p, double length, double gauge) {
  const double share = closed_share(p, length);
  if (share > kMostZeroShare) return "";
  if (std::abs(share) > kZeroShare) {
    const std::string off = digits("%.2f", 1e3 * std::abs(length - p.open)), part = digits("%.0f", 1e2 * std::abs(share));
    return (share > 0 ? say::kReadsLess(off, part) : say::kReadsMore(off, part)) + say::kSetZero();
  }
  return std::abs(gauge) > kZeroForce ? say::kGaugeReads(digits("%.2f", gauge)) + say::kSetZero() : "";
}

std::string check_geometry(const Geometry& g, const Poses& p) {
  if (!g.known()) return "";
  const double open = g.gap + p.open - p.closed, squeezed = g.gap + p.squeezed - p.closed;
  for (const double d : {g.gap, open, squeezed})
    if (!(d > std::abs(g.a - g.b) && d < g.a + g.b))
      return say::kNoTriangle(mm(g.a), mm(g.b), mm(d));
  return p.open < p.closed ? say::kLongestOpen() : "";
}

std::string check_table_size(std::size_t points) {
  return points >= 5 && points <= 11 ? "" : say::kTipCount(points);
}

std::string set_tip(std::vector<MonotoneCurve::Point> points, MonotoneCurve& out) {
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  if (!points.empty() && points.front().x < 0) return say::kPressesNothing();
  if (points.empty() || points.front().x > 0) points.insert(points.begin(), {0, 0});
  for (std::size_t i = 1; i < points.size(); ++i)
    if (points[i].x <= points[i - 1].x || points[i].y < points[i - 1].y) return say::kTipFalls(digits("%.3g", points[i].x));
  return out.set(std::move(points));
}

std::string check_tip(const TipCheck& c) {
  if (std::abs(c.measured - c.wanted) <= kCheckShare * c.wanted) return "";
  return say::kTipOff(digits("%.2f", c.wanted), digits("%.2f", c.measured), digits("%.0f", 1e2 * std::abs(c.measured / c.wanted - 1)),
                      digits("%.0f", 1e2 * kCheckShare));
}

std::string calibration_trouble(const Calibration& c, const std::string& serial, const std::string& today) {
  if (!c.serial.empty() && !serial.empty() && c.serial != serial) return say::kOtherSensor(c.serial, serial);
  if (!c.expires.empty() && today > c.expires) return say::kExpired(c.date, c.expires);
  if (c.check.known()) return check_tip(c.check);
  return "";
}

double Handle::angle(double length) const {
  const double from_closed = length - poses_.closed;
  if (!geometry_.known()) return from_closed;
  const auto between = [&](double d) {
    const double a = geometry_.a, b = geometry_.b;
    return std::acos(std::clamp((a * a + b * b - d * d) / (2 * a * b), -1.0, 1.0));
  };
  return between(geometry_.gap + from_closed) - between(geometry_.gap);
}

void Handle::set(const Calibration& c, double meets, const Held& held) {
  poses_ = c.poses;
  geometry_ = c.geometry;
  force_ = c.force;
  tip_ = c.tip;
  meets_ = meets;
  open_angle_ = angle(poses_.open);
  contact_ = poses_.closed;
  if (!geometry_.known() || held.width <= 0) return;
  const double a = geometry_.a, b = geometry_.b, g = geometry_.gap;
  const double phi = std::acos(std::clamp((a * a + b * b - g * g) / (2 * a * b), -1.0, 1.0)) + held.width / held.reach;
  contact_ += std::sqrt(a * a + b * b - 2 * a * b * std::cos(phi)) - g;
}

Handle::Grip Handle::at(double length) const {
  Grip out;
  const double share = angle(length) / open_angle_;  // 1 open, 0 just closed, below that squeezed
  const double squeeze = (poses_.closed - length) / (poses_.closed - poses_.squeezed);
  out.closure = std::clamp(share >= 0 ? meets_ * (1 - share) : meets_ + (1 - meets_) * squeeze, 0.0, 1.0);
  const double travel = (contact_ - length) * (poses_.open > poses_.closed ? 1 : -1);
  if (!force_.empty() && travel > 0) out.force = std::max(0.0, force_.value(travel) - force_.value(0));
  out.tip = tip(out.force);
  return out;
}

}  // namespace swage::sensor
