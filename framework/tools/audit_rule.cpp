// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "tools/audit.hpp"
#include "tools/print.hpp"
#include "tools/sentences.hpp"

namespace swage::tools {
namespace {

// Relative difference up to which processor times count as equal: the noise of a busy machine. With a smaller value noise decides which
// level is chosen; with a larger one a saving is missed.
constexpr double kSameCost = 0.1;

// Absolute difference up to which values count as equal, by unit: less than a trainee could notice. Other units have that of a pure
// number. A larger value accepts levels with a visible difference, a smaller one reports noise.
double noticeable(const std::string& unit) {
  constexpr double kLength = 20e-6, kTime = 0.1, kForce = 0.02;  // m, s, N
  if (unit == "m") return kLength;
  if (unit == "m2") return kLength * kLength;
  if (unit == "s") return kTime;
  if (unit == "N*s") return kForce * kTime;
  return 0.02;  // rad, N, shares and counts
}

// A metric of deducted points is part of the score, of 100, and is compared on the same scale.
AuditDifference beside(const AuditRule& rule, const AuditMetric& a, const AuditMetric& b) {
  const double larger = std::max(std::abs(a.value), std::abs(b.value));
  const double least = a.id.starts_with("points.") ? 100 * rule.tolerance : noticeable(a.unit);
  return {a.id, a.unit, a.value, b.value, std::max(least, rule.tolerance * larger)};
}

const AuditMetric* find(const AuditRun& run, const std::string& id) {
  for (const AuditMetric& m : run.metric)
    if (m.id == id && !std::isnan(m.value)) return &m;
  return nullptr;
}

std::string ending(const AuditRun& run) {
  return run.outcome + (run.reason.empty() ? "" : " (" + run.reason + ")");
}

void compare(const AuditRule& rule, AuditLevel& level, const AuditRun& reference) {
  const AuditRun& run = level.run;
  level.worst = std::numeric_limits<double>::infinity();
  level.enough = false;
  if (!run.problem.empty()) return static_cast<void>(level.why = run.problem);
  level.difference.push_back({"score", "", run.score, reference.score, 100 * rule.tolerance});
  for (const AuditMetric& b : reference.metric) {
    if (std::isnan(b.value)) continue;
    if (const AuditMetric* a = find(run, b.id))
      level.difference.push_back(beside(rule, *a, b));
    else
      level.untold.push_back(b.id);
  }
  if (run.outcome != reference.outcome || run.reason != reference.reason)
    return static_cast<void>(level.why = say::kOtherEnd(ending(run), reference.level, ending(reference)));
  const auto worst = std::max_element(
      level.difference.begin(), level.difference.end(),
      [](const AuditDifference& a, const AuditDifference& b) { return a.size() < b.size(); });
  level.worst = worst->size();
  level.enough = level.worst <= 1;
  if (level.worst > 0)
    level.why = say::kInstead(worst->id, format("%.4g", worst->value), format("%.4g", worst->reference)) +
                (worst->unit.empty() || worst->unit == "1" ? "" : " " + worst->unit);
}

/// The simplest of the levels that are enough and whose cost is within kSameCost of the cheapest of them.
std::size_t choose(const AuditLadder& ladder) {
  double least_s = ladder.level[ladder.reference].run.cpu_s;
  for (const AuditLevel& level : ladder.level)
    if (level.enough) least_s = std::min(least_s, level.run.cpu_s);
  const auto good = [&](const AuditLevel& level) {
    return level.enough && (1 - kSameCost) * level.run.cpu_s <= least_s;
  };
  const auto simplest = std::find_if(ladder.level.begin(), ladder.level.end(), good);
  return simplest == ladder.level.end() ? ladder.reference
                                        : static_cast<std::size_t>(simplest - ladder.level.begin());
}

}  // namespace

double AuditDifference::size() const { return std::abs(value - reference) / allowed; }

void judge(const AuditRule& rule, AuditLadder& ladder) {
  ladder.reference = ladder.level.size() - 1;
  while (ladder.reference > 0 && !ladder.level[ladder.reference].run.problem.empty()) --ladder.reference;
  const AuditRun reference = ladder.level[ladder.reference].run;
  for (AuditLevel& level : ladder.level) compare(rule, level, reference);

  ladder.chosen = choose(ladder);
  const double saves = 1 - ladder.level[ladder.chosen].run.cpu_s / reference.cpu_s;
  ladder.saves = saves > kSameCost ? saves : 0;
}

}  // namespace swage::tools
