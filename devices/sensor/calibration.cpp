// SPDX-License-Identifier: Apache-2.0
#include "sensor/calibration.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace swage::sensor {

namespace {

std::string mm(double m) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g mm", 1e3 * m);
  return text;
}

// least squares over points [first, last); residuals into the points
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
    return "A fit needs " + std::to_string(limits.fewest) + " points or more, 13 over 6 mm are usual; there are " +
           std::to_string(points.size()) + ".";
  for (const BenchPoint& p : points)
    if (!std::isfinite(p.volts) || !std::isfinite(p.length_m)) return "A point is not a number.";
  std::sort(points.begin(), points.end(), [](const auto& x, const auto& y) { return x.length_m < y.length_m; });
  for (std::size_t i = 1; i < points.size(); ++i)
    if (points[i].length_m == points[i - 1].length_m) return "Two points have the same length, " + mm(points[i].length_m) + ".";
  return "";
}

}  // namespace

std::string fit_displacement(std::vector<BenchPoint> points, const FitLimits& limits, Displacement& out) {
  if (std::string wrong = check_bench(points, limits); !wrong.empty()) return wrong;
  const std::size_t all = points.size();
  double nearest = 1e300;
  for (std::size_t n = all; n >= limits.fewest; --n) {
    // the end of a bench is cut before its beginning only when that is better
    Displacement best;
    best.worst = 1e300;
    std::size_t at = 0;
    for (std::size_t first = 0; first + n <= all; ++first) {
      const Displacement fit = line_through(points, first, first + n);
      if (fit.valid() && fit.worst < best.worst) best = fit, at = first;
    }
    nearest = std::min(nearest, best.worst);
    if (best.worst > limits.worst) continue;
    if (limits.nominal > 0 && std::abs(std::abs(best.slope) - limits.nominal) > limits.most_off * limits.nominal) {
      char text[160];
      std::snprintf(text, sizeof text, "The fit gives %.3g mm/V; this sensor has %.3g mm/V. Is its range set right?",
                    1e3 * best.slope, 1e3 * limits.nominal);
      return text;
    }
    out = line_through(points, at, at + n);
    out.points = points;
    return "";
  }
  return "No " + std::to_string(limits.fewest) + " points in a row lie on a line: the worst is " + mm(nearest) +
         " off, allowed are " + mm(limits.worst) + ". Measure again, or look for a loose swivel.";
}

std::string MonotoneCurve::set(std::vector<Point> points) {
  points_.clear();
  slope_.clear();
  if (points.size() < 2 || points.size() > 64)
    return "A force table has 2 to 64 points, 5 to 11 are usual; there are " + std::to_string(points.size()) + ".";
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(points[i].x) || !std::isfinite(points[i].y)) return "A point of the force table is not a number.";
    if (i > 0 && points[i].x <= points[i - 1].x) return "The travel of a force table goes up from point to point; at " + mm(points[i].x) + " it does not.";
    if (i > 0 && points[i].y < points[i - 1].y) return "The force of a force table never goes down; at " + mm(points[i].x) + " it does.";
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
  // at an end: the parabola through three points, kept from turning round
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
  if (!std::isfinite(p.open) || !std::isfinite(p.closed) || !std::isfinite(p.squeezed)) return "A pose is not a number.";
  // 20 um, ten times the sensor's resolution, is no movement of a hand
  constexpr double kLeast = 20e-6;
  const double way = p.open - p.closed, squeeze = p.closed - p.squeezed;
  if (std::abs(way) < kLeast) return "Open and just closed are the same to " + mm(kLeast) + ". Is the sensor held in its swivels?";
  if (way * squeeze <= 0 || std::abs(squeeze) < kLeast)
    return "Squeezed must go on from just closed, away from open: open " + mm(p.open) + ", closed " + mm(p.closed) + ", squeezed " +
           mm(p.squeezed) + ".";
  if (!stored.known()) return "";
  const auto off = [](double now, double then) { return std::abs(now - then) > 0.2 * std::abs(then); };
  if (off(way, stored.open - stored.closed) || off(squeeze, stored.closed - stored.squeezed))
    return "The ways differ by more than a fifth from those of before (" + mm(stored.open - stored.closed) + " and " +
           mm(stored.closed - stored.squeezed) + "; now " + mm(way) + " and " + mm(squeeze) + "). Is it the same needleholder?";
  return "";
}

double closed_share(const Poses& p, double length) { return (p.open - length) / (p.open - p.closed); }

std::string set_zero(double length, Poses& p) {
  if (!p.known()) return "There are no poses yet whose zero could be set. First: swage calibrate poses.";
  const double off = length - p.open;
  if (!(std::abs(closed_share(p, length)) <= kMostZeroShare))
    return "The handle rests " + mm(std::abs(off)) + " from where it was open, more than a fifth of its way (" + mm(std::abs(p.open - p.closed)) +
           "). Is it let go? Otherwise measure all three poses.";
  p.open += off, p.closed += off, p.squeezed += off;
  return "";
}

std::string rest_trouble(const Poses& p, double length, double gauge) {
  const double share = closed_share(p, length);
  if (share > kMostZeroShare) return "";
  char text[320];
  if (std::abs(share) > kZeroShare)
    std::snprintf(text, sizeof text, "The handle reads %.2f mm %s than open (%.0f %% of its way).", 1e3 * std::abs(length - p.open),
                  share > 0 ? "less" : "more", 1e2 * std::abs(share));
  else if (std::abs(gauge) > kZeroForce)
    std::snprintf(text, sizeof text, "The gauge on the handle reads %.2f N while the handle is open.", gauge);
  else
    return "";
  return text + std::string(" If nobody holds it, set its zero: swage calibrate zero, or Setup, Jaw sensors, Calibrate, Poses.");
}

std::string check_geometry(const Geometry& g, const Poses& p) {
  if (!g.known()) return "";
  const double open = g.gap + p.open - p.closed, squeezed = g.gap + p.squeezed - p.closed;
  for (const double d : {g.gap, open, squeezed})
    if (!(d > std::abs(g.a - g.b) && d < g.a + g.b))
      return "Swivels at " + mm(g.a) + " and " + mm(g.b) + " from the pivot cannot be " + mm(d) + " apart.";
  return p.open < p.closed ? "With this geometry the sensor is longest when the handle is open; here it is shortest." : "";
}

std::string check_table_size(std::size_t points) {
  return points >= 5 && points <= 11 ? "" : "A table of forces has 5 to 11 points; there are " + std::to_string(points) + ".";
}

std::string set_tip(std::vector<MonotoneCurve::Point> points, MonotoneCurve& out) {
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  if (!points.empty() && points.front().x < 0) return "A force at the handle below what closes it presses nothing; leave that point out.";
  if (points.empty() || points.front().x > 0) points.insert(points.begin(), {0, 0});
  for (std::size_t i = 1; i < points.size(); ++i) {
    char text[128];
    std::snprintf(text, sizeof text, "The force at the tips goes up with that at the handle; at %.3g N it does not.", points[i].x);
    if (points[i].x <= points[i - 1].x || points[i].y < points[i - 1].y) return text;
  }
  return out.set(std::move(points));
}

std::string check_tip(const TipCheck& c) {
  if (std::abs(c.measured - c.wanted) <= kCheckShare * c.wanted) return "";
  char text[192];
  std::snprintf(text, sizeof text, "%.2f N at the tips are measured as %.2f N, %.0f %% off; allowed are %.0f %%. Measure the forces anew.", c.wanted,
                c.measured, 1e2 * std::abs(c.measured / c.wanted - 1), 1e2 * kCheckShare);
  return text;
}

std::string calibration_trouble(const Calibration& c, const std::string& serial, const std::string& today) {
  if (!c.serial.empty() && !serial.empty() && c.serial != serial)
    return "The calibration is that of the sensor " + c.serial + ", and this one is " + serial + ".";
  if (!c.expires.empty() && today > c.expires)
    return "The calibration of " + c.date + " expired on " + c.expires + ". Make a new one: swage calibrate displacement.";
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
