// SPDX-License-Identifier: Apache-2.0
//
// Pass rules of the lessons of a course: limits of metrics, and how many attempts must meet them. Pure functions.
// [any]
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace swage::judge {

/// Required range of a metric: at least, at most, or both, in its SI unit.
struct Limit {
  std::string metric, unit;
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool is_gate = false;  // safety: an attempt that violates it shows no score
  std::string source;    // source of the numbers: "experts, 10 % to 90 %, n = 12"
  bool operator==(const Limit&) const = default;
};

using Metrics = std::span<const std::pair<std::string, double>>;  // id, value

/// Limits met by an attempt. A missing metric, or one that is not a number, violates its limit.
struct Met {
  bool all = true, gates = true;
  std::vector<std::size_t> broken;  // indices of limits
};
Met meets(std::span<const Limit> limits, Metrics metrics);

/// Number of attempts that meet all limits together, and each alone: for independent limits the shares multiply.
struct MetTogether {
  std::size_t attempts = 0, all = 0;
  std::vector<std::size_t> each;  // per limit
};
MetTogether meet_together(std::span<const Limit> limits, std::span<const std::vector<std::pair<std::string, double>>> attempts);

/// kStreak: `in_a_row` attempts in Test meet all limits, and so do the first `later_day` of a later day.
/// kLcCusum: the learning-curve CUSUM of Biau et al. 2008 (doi:10.1002/bjs.6056) signals.
struct PassRule {
  enum class Kind : uint8_t { kStreak, kLcCusum };
  Kind kind = Kind::kStreak;
  uint32_t in_a_row = 2;
  uint32_t later_day = 2;  // 0: not required
  uint32_t a_day = 10;     // number of attempts per day that count; 0: all
  uint32_t warm_up = 0;    // number of first attempts of each day that do not count
  double adequate = 0.10;    // failure rate of a competent trainee, below `inadequate`
  double inadequate = 0.30;  // failure rate of one who is not competent
  double signal = 2.4;       // S at which competence is signalled. A lower one passes trainees too early, a higher one takes longer
  bool operator==(const PassRule&) const = default;
};
/// "" for a valid rule, else the fault, as a sentence.
std::string problem_of(const PassRule& rule);

/// One attempt that may count: in Test, not void, by a person's hand. In chronological order.
struct Scored {
  int32_t day = 0;  // any number that increases from day to day
  bool met = false;
};

struct Standing {
  bool passed = false;
  std::size_t at = 0;         // index of the attempt by which it was passed
  std::size_t counted = 0;    // attempts that counted
  uint32_t in_a_row = 0;      // at the end; kStreak
  bool is_earned = false;     // only the later day is missing; kStreak
  uint32_t confirmed = 0;     // of the first attempts of the last day; kStreak, once earned
  double sum = 0;             // S at the end; kLcCusum
  std::vector<double> sums;   // S after each counted attempt; kLcCusum
  bool relapsed = false;      // after passing, an ordinary CUSUM with the same rates and limit has signalled failure
};
Standing standing(const PassRule& rule, std::span<const Scored> attempts);

/// Summands of S: of a success, ln((1 - p1) / (1 - p0)), and of a failure, ln(p1 / p0), with p1 adequate and p0 inadequate.
struct CusumWeights {
  double success = 0, failure = 0;
};
CusumWeights lc_cusum_weights(double adequate, double inadequate);

/// Result of a rule for a trainee who always succeeds with the same probability.
struct RuleOdds {
  double passed = 0;        // share of trainees
  double typical = 0;       // median number of attempts of those who passed; NaN when nobody did
};
/// Applies the rule to random attempts, `a_day` a day. The same seed gives the same numbers everywhere. 40 000 runs: to 0.3 %.
RuleOdds simulate(const PassRule& rule, double succeeds, uint32_t attempts = 30, uint32_t a_day = 10, uint32_t runs = 40'000,
                  uint64_t seed = 1);

}  // namespace swage::judge
