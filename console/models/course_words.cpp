// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/course_words.hpp"

#include <swage/abi/lesson_card.h>

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "console/models/metric_bars.hpp"
#include "console/models/metric_titles.hpp"
#include "console/models/words.hpp"
#include "judge/learning.hpp"

namespace swage::console {
namespace {

constexpr uint32_t kAttempts = 30;   // about as many as a resident makes of a lesson
constexpr uint32_t kADay = 10;       // attempts a day where the rule counts all
constexpr uint32_t kRuns = 10'000;   // simulated trainees: accuracy 0.5 of 100, in a tenth of a second
constexpr size_t kFewExperts = 5;    // fewer are a poor sample of experts (ux-assessment 12.4)

class CourseWords {
  Q_DECLARE_TR_FUNCTIONS(course_words)
};

/// Two digits in the unit that is shown; away from the experts' values, so that as many of them keep the limit as before.
double rounded(double value, const judge::Limit& limit, bool up) {
  const double factor = display_factor(metric_unit(QString::fromStdString(limit.metric), QString::fromStdString(limit.unit)));
  const double shown = value * factor;
  if (!std::isfinite(shown) || shown == 0) return value;
  const double step = std::pow(10.0, std::floor(std::log10(std::abs(shown))) - 1), steps = shown / step;
  return (up ? std::ceil(steps - 1e-9) : std::floor(steps + 1e-9)) * step / factor;
}

// "Passed when 2 Test attempts in a row meet everything that is asked, and the first of a later day does so too."
QString streak_words(const judge::PassRule& rule) {
  const QString row = rule.in_a_row == 1 ? CourseWords::tr("one Test attempt meets everything that is asked")
                                         : CourseWords::tr("%1 Test attempts in a row meet everything that is asked").arg(rule.in_a_row);
  if (rule.later_day == 0) return CourseWords::tr("Passed when %1.").arg(row);
  const QString later = rule.later_day == 1 ? CourseWords::tr("the first of a later day does so too")
                                            : CourseWords::tr("the first %1 of a later day do so too").arg(rule.later_day);
  return CourseWords::tr("Passed when %1, and %2.").arg(row, later);
}

}  // namespace

QString rule_words(const judge::PassRule& rule) {
  if (const std::string problem = judge::problem_of(rule); !problem.empty()) return CourseWords::tr("▲ %1").arg(QString::fromStdString(problem));
  QString words;
  if (rule.kind == judge::PassRule::Kind::kLcCusum)
    words = CourseWords::tr("Passed when a learning-curve test of the Test attempts signals that the trainee fails rather %1 % of them than %2 %.")
                .arg(100 * rule.adequate, 0, 'g', 3)
                .arg(100 * rule.inadequate, 0, 'g', 3);
  else
    words = streak_words(rule);
  if (rule.a_day > 0) words += QLatin1Char(' ') + CourseWords::tr("At most %1 attempts a day count.").arg(rule.a_day);
  if (rule.warm_up > 0) words += QLatin1Char(' ') + CourseWords::tr("The first %1 of a day are warm-up.").arg(rule.warm_up);
  return words;
}

QStringList rule_odds(const judge::PassRule& rule) {
  QStringList out;
  if (!judge::problem_of(rule).empty()) return out;
  for (const int tenths : {5, 7, 9}) {
    const judge::RuleOdds odds = judge::simulate(rule, 0.1 * tenths, kAttempts, rule.a_day ? rule.a_day : kADay, kRuns);
    QString line = CourseWords::tr("succeeds %1 times in 10: passes in %L2 of 100 cases").arg(tenths).arg(100 * odds.passed, 0, 'f', odds.passed < 0.02 ? 1 : 0);
    if (std::isfinite(odds.typical) && odds.typical < 1.5)
      line += CourseWords::tr(", typically with the first attempt");
    else if (std::isfinite(odds.typical))
      line += CourseWords::tr(", typically after %1 attempts").arg(odds.typical, 0, 'f', 0);
    out += line;
  }
  const uint32_t a_day = rule.a_day ? rule.a_day : kADay;
  QString assumed = CourseWords::tr("assumed: %1 attempts on every day").arg(a_day);
  if (rule.kind == judge::PassRule::Kind::kStreak && rule.later_day > 0)
    assumed += CourseWords::tr("; the rule asks for a later day, so nobody passes before attempt %1").arg(a_day + rule.later_day);
  out += assumed;
  return out;
}

QString together_words(const std::vector<judge::Limit>& limits, const std::vector<const record::AttemptRow*>& experts) {
  if (limits.empty()) return {};
  if (experts.empty()) return CourseWords::tr("No attempts of experts to try these limits on.");
  std::vector<std::vector<std::pair<std::string, double>>> values;
  for (const record::AttemptRow* a : experts) {
    auto& own = values.emplace_back();
    if (!has_score(*a)) continue;  // not passed: it meets nothing, as in a course
    for (const judge::Limit& l : limits) own.emplace_back(l.metric, metric_value(*a, QString::fromStdString(l.metric)));
  }
  const judge::MetTogether met = judge::meet_together(limits, values);
  QString words = limits.size() == 1 ? CourseWords::tr("%1 of %2 expert attempts pass and meet the limit.").arg(met.all).arg(met.attempts)
                                     : CourseWords::tr("%1 of %2 expert attempts pass and meet all %3 limits together.").arg(met.all).arg(met.attempts).arg(limits.size());
  if (met.all < met.attempts && limits.size() > 1) {
    const auto worst = static_cast<size_t>(std::min_element(met.each.begin(), met.each.end()) - met.each.begin());
    words += QLatin1Char(' ') + CourseWords::tr("The hardest alone is %1: %2.").arg(metric_title(QString::fromStdString(limits[worst].metric))).arg(met.each[worst]);
  }
  return words;
}

bool suggest_limit(judge::Limit& limit, const std::vector<const record::AttemptRow*>& experts, int32_t better) {
  std::vector<std::vector<double>> values;
  std::vector<std::string> who;
  for (const record::AttemptRow* a : experts) {
    if (!has_score(*a)) continue;  // not passed: no measure for those who are to pass
    const double v = metric_value(*a, QString::fromStdString(limit.metric));
    if (!std::isfinite(v)) continue;
    const auto at = static_cast<size_t>(std::find(who.begin(), who.end(), a->person_id) - who.begin());
    if (at == who.size()) who.push_back(a->person_id), values.emplace_back();
    values[at].push_back(v);
  }
  const judge::Band band = judge::expert_band(values);
  if (band.attempts == 0 || (better != SWAGE_BETTER_LOWER && better != SWAGE_BETTER_HIGHER)) return false;
  if (better == SWAGE_BETTER_LOWER) limit.most = rounded(band.p90, limit, true);
  if (better == SWAGE_BETTER_HIGHER) limit.least = rounded(band.p10, limit, false);
  limit.source = "experts, 10 % to 90 %, people " + std::to_string(band.people) + ", attempts " + std::to_string(band.attempts) +
                 (band.people < kFewExperts ? ", fewer than 5 people" : "");
  return true;
}

}  // namespace swage::console
