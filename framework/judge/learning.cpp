// SPDX-License-Identifier: Apache-2.0
#include "judge/learning.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace swage::judge {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
// A curve that has not come half-way after twice the attempts cannot be distinguished from a line, whose level is undetermined.
constexpr double kSlowest = 2.0;  // c over the number of attempts
constexpr double kQuickest = 0.2, kFlattest = 0.05, kSteepest = 4.0;
constexpr int kGrid = 48;  // start values of c; with fewer the fit sometimes ends in a local minimum

struct Points {
  std::vector<double> n, y;
};

double shape(Law law, double n, double c) {
  return law == Law::kExponential ? std::exp(-(n - 1) / c) : std::pow(n, -c);
}

struct Line {
  double a = 0, b = 0, rss = kInfinity;
};

// For a given c both laws are linear in a and b. `g`: room for the shape at each point.
Line fit_line(Law law, const Points& p, double c, std::vector<double>& g) {
  const double count = static_cast<double>(p.y.size());
  double g1 = 0, y1 = 0, gg = 0, gy = 0;
  for (std::size_t i = 0; i < p.y.size(); ++i) {
    g[i] = shape(law, p.n[i], c);
    g1 += g[i] / count;
    y1 += p.y[i] / count;
  }
  for (std::size_t i = 0; i < p.y.size(); ++i) {
    gg += (g[i] - g1) * (g[i] - g1);
    gy += (g[i] - g1) * (p.y[i] - y1);
  }
  Line out;
  out.b = gg > 1e-24 * count ? gy / gg : 0;
  out.a = y1 - out.b * g1;
  out.rss = 0;
  for (std::size_t i = 0; i < p.y.size(); ++i) {
    const double e = p.y[i] - out.a - out.b * g[i];
    out.rss += e * e;
  }
  return out;
}

// Residual sum of squares of the best b for a given level a.
double rss_at_level(Law law, const Points& p, double a, double c, std::vector<double>& g) {
  double gg = 0, gy = 0, rss = 0;
  for (std::size_t i = 0; i < p.y.size(); ++i) {
    g[i] = shape(law, p.n[i], c);
    gg += g[i] * g[i];
    gy += g[i] * (p.y[i] - a);
  }
  const double b = gg > 0 ? gy / gg : 0;
  for (std::size_t i = 0; i < p.y.size(); ++i) {
    const double e = p.y[i] - a - b * g[i];
    rss += e * e;
  }
  return rss;
}

// Values of c, uniform in log c, with sums over the points from which the residual follows at any level.
class Grid {
 public:
  Grid(Law law, const Points& p, double low, double high) : low_(low), step_(std::log(high / low) / (kGrid - 1)), count_(static_cast<double>(p.y.size())) {
    for (const double y : p.y) mean_ += y / count_;
    for (const double y : p.y) y1_ += y - mean_, yy_ += (y - mean_) * (y - mean_);
    for (int k = 0; k < kGrid; ++k) {
      Sums& at = sums_[static_cast<std::size_t>(k)];
      for (std::size_t i = 0; i < p.y.size(); ++i) {
        const double g = shape(law, p.n[i], c(k));
        at.g1 += g, at.gg += g * g, at.gy += g * (p.y[i] - mean_);
      }
    }
  }
  double c(int k) const { return low_ * std::exp(step_ * k); }
  // The logarithms of c on either side.
  double before(int k) const { return std::log(low_) + step_ * std::max(k - 1, 0); }
  double after(int k) const { return std::log(low_) + step_ * std::min(k + 1, kGrid - 1); }
  // To some 16 digits of the sum of squares about the level: enough to choose, too little for the fit of an exact curve.
  double rss_at_level(int k, double level) const {
    const Sums& at = sums_[static_cast<std::size_t>(k)];
    const double a = level - mean_;
    const double gy = at.gy - a * at.g1, b = at.gg > 0 ? gy / at.gg : 0;
    return yy_ - 2 * a * y1_ + count_ * a * a - b * gy;
  }

 private:
  struct Sums {
    double g1 = 0, gg = 0, gy = 0;
  };
  double low_, step_, count_, mean_ = 0, y1_ = 0, yy_ = 0;  // sums of values: less their mean
  std::array<Sums, kGrid> sums_{};
};

// The c with the least sum of squares: the best of the grid by `coarse(k)`, then golden section about it by `rss(c)`.
template <class Coarse, class Rss>
double best_c(const Grid& grid, const Coarse& coarse, const Rss& rss) {
  int best = 0;
  double least = kInfinity;
  for (int k = 0; k < kGrid; ++k)
    if (const double r = coarse(k); r < least) least = r, best = k;
  double from = grid.before(best), to = grid.after(best);
  const double golden = 1 / std::numbers::phi;
  double left = to - golden * (to - from), right = from + golden * (to - from);
  double at_left = rss(std::exp(left)), at_right = rss(std::exp(right));
  for (int i = 0; i < 60; ++i) {
    if (at_left < at_right) {
      to = right, right = left, at_right = at_left;
      left = to - golden * (to - from), at_left = rss(std::exp(left));
    } else {
      from = left, left = right, at_left = at_right;
      right = from + golden * (to - from), at_right = rss(std::exp(right));
    }
  }
  return std::exp(0.5 * (from + to));
}

// Student's distribution for whole degrees of freedom: closed forms of Abramowitz and Stegun 26.7.3 and 26.7.4.
double within_t(double t, int dof) {
  const double theta = std::atan(t / std::sqrt(dof)), s = std::sin(theta), c = std::cos(theta);
  double term = dof % 2 == 1 ? c : 1.0, sum = dof == 1 ? 0 : term;
  for (int k = dof % 2 == 1 ? 3 : 2; k <= dof - 2; k += 2) {
    term *= c * c * (k - 1) / k;
    sum += term;
  }
  return dof % 2 == 1 ? 2 / std::numbers::pi * (theta + s * sum) : s * sum;
}

double t_quantile(double within, int dof) {
  double low = 0, high = 1000;
  for (int i = 0; i < 80; ++i) (within_t(0.5 * (low + high), dof) < within ? low : high) = 0.5 * (low + high);
  return 0.5 * (low + high);
}

// Profile likelihood: the levels a for which the best curve is not significantly worse than the optimum. It needs no
// derivatives and follows the curvature of the laws, for which the interval a +- 2 sigma is too short.
double level_bound(Law law, const Points& p, const Grid& grid, double a, double allowed, double range, double side) {
  std::vector<double> g(p.y.size());
  const auto worse = [&](double level) {
    const auto rss = [&](double c) { return rss_at_level(law, p, level, c, g); };
    return rss(best_c(grid, [&](int k) { return grid.rss_at_level(k, level); }, rss)) > allowed;
  };
  constexpr double kFar = 64;  // in ranges of the values: the bound counts as infinite beyond
  double inside = 0, outside = range / 64;
  while (!worse(a + side * outside)) {
    inside = outside;
    outside *= 2;
    if (outside > kFar * range) return side * kInfinity;
  }
  for (int i = 0; i < 30; ++i) (worse(a + side * 0.5 * (inside + outside)) ? outside : inside) = 0.5 * (inside + outside);
  return a + side * 0.5 * (inside + outside);
}

Points points_of(std::span<const double> values, std::span<const double> numbers) {
  Points p;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double n = i < numbers.size() ? numbers[i] : static_cast<double>(i + 1);
    if (!std::isfinite(values[i]) || !(n >= 1)) continue;
    p.n.push_back(n);
    p.y.push_back(values[i]);
  }
  return p;
}

}  // namespace

double Curve::at(double n) const { return a + b * shape(law, n, c); }

Curve fit_curve(Law law, std::span<const double> values, std::span<const double> numbers) {
  Curve out;
  out.law = law;
  const Points p = points_of(values, numbers);
  const std::size_t count = p.y.size();
  if (count < kFewestForCurve) {
    out.why_not = "A curve needs " + std::to_string(kFewestForCurve) + " attempts: " + std::to_string(kFewestForCurve - count) + " more.";
    return out;
  }
  const bool exponential = law == Law::kExponential;
  const double last = *std::max_element(p.n.begin(), p.n.end());
  const double low = exponential ? kQuickest : kFlattest, high = exponential ? kSlowest * last : kSteepest;
  const Grid grid(law, p, low, high);
  std::vector<double> g(count);
  const auto rss = [&](double c) { return fit_line(law, p, c, g).rss; };
  out.c = best_c(grid, [&](int k) { return rss(grid.c(k)); }, rss);
  const Line line = fit_line(law, p, out.c, g);
  const double n = static_cast<double>(count), dof = n - 3;
  out.fitted = true;
  out.a = line.a;
  out.b = line.b;
  out.spread = std::sqrt(line.rss / dof);
  constexpr double k = 4;  // number of parameters: a, b, c and the spread
  out.aicc = n * std::log(line.rss / n) + 2 * k + 2 * k * (k + 1) / (n - k - 1);
  out.half_way = exponential ? out.c * std::numbers::ln2 : std::exp2(1 / out.c) - 1;
  const auto [least, most] = std::minmax_element(p.y.begin(), p.y.end());
  const double t = t_quantile(0.95, static_cast<int>(dof)), range = *most - *least;
  if (!(range > 0)) {
    out.a = out.low = out.high = *least;
    out.b = out.spread = 0;
    return out;
  }
  // rounding errors of an exact curve must not count as a worse fit
  const double allowed = line.rss * (1 + t * t / dof) + 1e-24 * range * range * n;
  out.low = level_bound(law, p, grid, out.a, allowed, range, -1);
  out.high = level_bound(law, p, grid, out.a, allowed, range, +1);
  return out;
}

Curve fit_curve(std::span<const double> values, std::span<const double> numbers) {
  const Curve exponential = fit_curve(Law::kExponential, values, numbers), power = fit_curve(Law::kPower, values, numbers);
  return power.fitted && power.aicc < exponential.aicc ? power : exponential;
}

Recent recent(std::span<const double> values) {
  std::vector<double> last;
  for (const double v : values)
    if (std::isfinite(v)) last.push_back(v);
  constexpr std::size_t kLast = 5;
  if (last.size() > kLast) last.erase(last.begin(), last.end() - kLast);
  Recent out;
  out.n = last.size();
  out.median = quantile(last, 0.5);
  out.low = quantile(last, 0);
  out.high = quantile(last, 1);
  return out;
}

double quantile(std::vector<double> values, double share) {
  std::erase_if(values, [](double v) { return !std::isfinite(v); });
  if (values.empty()) return kNaN;
  std::sort(values.begin(), values.end());
  const double at = std::clamp(share, 0.0, 1.0) * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (at - static_cast<double>(below)) * (values[above] - values[below]);
}

Band expert_band(std::span<const std::vector<double>> experts) {
  constexpr double kAtypical = 1.96;  // standard deviations, as in a benchmark of experts (doi:10.1111/ans.14474)
  Band out;
  std::vector<double> all, means;
  std::vector<std::size_t> who;
  for (std::size_t i = 0; i < experts.size(); ++i) {
    double sum = 0, n = 0;
    for (const double v : experts[i]) {
      if (!std::isfinite(v)) continue;
      all.push_back(v);
      sum += v, ++n;
    }
    if (n == 0) continue;
    means.push_back(sum / n);
    who.push_back(i);
  }
  out.people = means.size();
  out.attempts = all.size();
  out.p10 = quantile(all, 0.1);
  out.median = quantile(all, 0.5);
  out.p90 = quantile(all, 0.9);
  if (means.size() < 3) return out;
  double mean = 0, square = 0;
  for (const double m : means) mean += m / static_cast<double>(means.size());
  for (const double m : means) square += (m - mean) * (m - mean);
  const double deviation = std::sqrt(square / static_cast<double>(means.size() - 1));
  for (std::size_t i = 0; i < means.size(); ++i)
    if (std::abs(means[i] - mean) > kAtypical * deviation) out.left_out.push_back(who[i]);
  return out;
}

}  // namespace swage::judge
