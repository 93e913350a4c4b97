// SPDX-License-Identifier: Apache-2.0
#include "judge/pass_rule.hpp"

#include <algorithm>
#include <cmath>

#include "base/rng.hpp"

namespace swage::judge {
namespace {

// Selects the attempts of a day that count: those after the warm-up, up to the limit per day.
class Day {
 public:
  explicit Day(const PassRule& rule) : rule_(rule) {}
  /// Number of this attempt among the counting ones of its day, from 1; 0 for one that does not count.
  uint32_t place(int32_t day) {
    if (first_ || day != day_) done_ = 0;
    first_ = false;
    day_ = day;
    if (++done_ <= rule_.warm_up) return 0;
    const uint32_t place = done_ - rule_.warm_up;
    return rule_.a_day == 0 || place <= rule_.a_day ? place : 0;
  }

 private:
  const PassRule& rule_;
  bool first_ = true;
  int32_t day_ = 0;
  uint32_t done_ = 0;
};

class Streak {
 public:
  explicit Streak(const PassRule& rule) : rule_(rule) {}
  bool add(const Scored& a, uint32_t place, Standing& out) {
    out.in_a_row = a.met ? out.in_a_row + 1 : 0;
    if (out.is_earned && a.day > earned_day_ && place <= rule_.later_day) {
      if (place == 1) broken_ = false, out.confirmed = 0;
      broken_ |= !a.met;
      out.confirmed = broken_ ? 0 : out.confirmed + 1;
      return out.confirmed == rule_.later_day;
    }
    if (!out.is_earned && out.in_a_row >= rule_.in_a_row) {
      out.is_earned = true;
      earned_day_ = a.day;
      return rule_.later_day == 0;
    }
    return false;
  }

 private:
  const PassRule& rule_;
  int32_t earned_day_ = 0;
  bool broken_ = false;
};

}  // namespace

Met meets(std::span<const Limit> limits, Metrics metrics) {
  Met out;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const auto found = std::find_if(metrics.begin(), metrics.end(), [&](const auto& m) { return m.first == limits[i].metric; });
    // the comparison is false for NaN
    if (found != metrics.end() && found->second >= limits[i].least && found->second <= limits[i].most) continue;
    out.broken.push_back(i);
    out.all = false;
    if (limits[i].is_gate) out.gates = false;
  }
  return out;
}

MetTogether meet_together(std::span<const Limit> limits, std::span<const std::vector<std::pair<std::string, double>>> attempts) {
  MetTogether out;
  out.attempts = attempts.size();
  out.each.assign(limits.size(), attempts.size());
  for (const auto& metrics : attempts) {
    const Met met = meets(limits, metrics);
    out.all += met.all;
    for (const std::size_t i : met.broken) --out.each[i];
  }
  return out;
}

std::string problem_of(const PassRule& rule) {
  if (rule.kind == PassRule::Kind::kStreak) {
    if (rule.in_a_row == 0) return "at least 1 attempt in a row must be asked for.";
    if (rule.a_day > 0 && rule.later_day > rule.a_day)
      return "a later day asks for " + std::to_string(rule.later_day) + " attempts and only " + std::to_string(rule.a_day) + " of a day count.";
    return "";
  }
  if (!(rule.adequate > 0 && rule.adequate < rule.inadequate && rule.inadequate < 1))
    return "the adequate failure rate must be above 0 and below the inadequate one, which must be below 1.";
  if (!(rule.signal > 0 && std::isfinite(rule.signal))) return "the signal must lie above 0.";
  return "";
}

CusumWeights lc_cusum_weights(double adequate, double inadequate) {
  return {std::log((1 - adequate) / (1 - inadequate)), std::log(adequate / inadequate)};
}

Standing standing(const PassRule& rule, std::span<const Scored> attempts) {
  Standing out;
  Day day(rule);
  Streak streak(rule);
  const CusumWeights w = lc_cusum_weights(rule.adequate, rule.inadequate);
  double relapse = 0;  // CUSUM of the opposite likelihood ratio: evidence for failing
  for (std::size_t i = 0; i < attempts.size(); ++i) {
    const Scored& a = attempts[i];
    const uint32_t place = day.place(a.day);
    if (place == 0) continue;
    ++out.counted;
    if (out.passed) {
      relapse = std::max(0.0, relapse - (a.met ? w.success : w.failure));
      out.relapsed |= relapse >= rule.signal;
      continue;
    }
    if (rule.kind == PassRule::Kind::kStreak) {
      out.passed = streak.add(a, place, out);
    } else {
      out.sum = std::max(0.0, out.sum + (a.met ? w.success : w.failure));
      out.sums.push_back(out.sum);
      out.passed = out.sum >= rule.signal;
    }
    if (out.passed) out.at = i;
  }
  return out;
}

RuleOdds simulate(const PassRule& rule, double succeeds, uint32_t attempts, uint32_t a_day, uint32_t runs, uint64_t seed) {
  base::Xoshiro256 random(seed);
  std::vector<Scored> tries(attempts);
  std::vector<std::size_t> took;
  for (uint32_t run = 0; run < runs; ++run) {
    for (uint32_t i = 0; i < attempts; ++i)
      tries[i] = {static_cast<int32_t>(a_day > 0 ? i / a_day : 0), random.uniform() < succeeds};
    const Standing s = standing(rule, tries);
    if (s.passed) took.push_back(s.at + 1);
  }
  RuleOdds out;
  out.passed = runs > 0 ? static_cast<double>(took.size()) / runs : 0;
  out.typical = std::numeric_limits<double>::quiet_NaN();
  if (took.empty()) return out;
  const auto middle = took.begin() + static_cast<std::ptrdiff_t>(took.size() / 2);
  std::nth_element(took.begin(), middle, took.end());
  out.typical = static_cast<double>(*middle);
  return out;
}

}  // namespace swage::judge
