// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/metric_bars.hpp"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <map>

#include "console/models/metric_titles.hpp"
#include "console/models/words.hpp"
#include "record/progress.hpp"

namespace swage::console {
namespace {

constexpr double kMargin = 0.05;  // margin on each side of the drawn range, as a share of it

class BarWords {
  Q_DECLARE_TR_FUNCTIONS(metric_bars)
};

bool judged(const record::AttemptRow& a) { return record::is_sound(a) && (a.outcome == "passed" || a.outcome == "failed"); }

/// `values`: of all this person's attempts, the newest first. The bar spans them and the band, so that its length says how far the
/// newest has come.
MetricBar make_bar(const QString& id, const QString& unit, const std::vector<double>& values, const judge::Band& band,
                   bool higher_is_better) {
  const double value = values.front();
  MetricBar bar;
  bar.id = id;
  bar.name = metric_title(id);
  bar.value = quantity_text(value, unit);
  bar.band = BarWords::tr("%1 to %2").arg(quantity_text(band.p10, unit), quantity_text(band.p90, unit));
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const double first = std::min(*least, band.p10), span = std::max(*most, band.p90) - first;
  const auto place = [&](double v) {
    const double at = span > 0 ? ((v - first) / span + kMargin) / (1 + 2 * kMargin) : 0.5;
    return higher_is_better ? 1 - at : at;
  };
  bar.latest = place(value);
  bar.low = std::min(place(band.p10), place(band.p90));
  bar.high = std::max(place(band.p10), place(band.p90));
  bar.inside = bar.latest <= bar.high + 1e-9;
  return bar;
}

}  // namespace

double metric_value(const record::AttemptRow& a, const QString& metric) {
  if (metric == QLatin1String("score")) return has_score(a) ? a.score : std::nan("");
  if (metric == QLatin1String("time")) return a.simulated_s;
  const std::string id = metric.toStdString();
  for (const record::MetricValue& m : a.metrics)
    if (m.id == id) return m.value;
  return std::nan("");
}

bool is_expert_group(const QString& name) {
  return name.compare(BarWords::tr("Experts"), Qt::CaseInsensitive) == 0 || name.compare(QLatin1String("Experts"), Qt::CaseInsensitive) == 0;
}

std::vector<const record::AttemptRow*> expert_attempts(const std::vector<record::AttemptRow>& all,
                                                       const std::vector<std::string>& expert_ids, const std::string& lesson_id) {
  std::vector<const record::AttemptRow*> people, hands;
  for (const record::AttemptRow& a : all) {
    if (a.lesson_id != lesson_id || !judged(a)) continue;
    const bool expert = std::find(expert_ids.begin(), expert_ids.end(), a.person_id) != expert_ids.end();
    if (expert && !is_hand(a)) people.push_back(&a);
    if (is_hand(a) && a.device.find("expert") != std::string::npos) hands.push_back(&a);
  }
  return people.empty() ? hands : people;
}

std::vector<record::AttemptRow> read_expert_attempts(record::Store& store, const std::vector<std::string>& expert_ids,
                                                     const std::string& lesson_id) {
  std::vector<record::AttemptRow> out;
  for (const std::string& id : expert_ids)
    for (record::AttemptRow& a : store.attempts(id, lesson_id)) out.push_back(std::move(a));
  if (!expert_attempts(out, expert_ids, lesson_id).empty()) return out;
  const std::vector<record::AttemptRow> heads = store.attempt_heads("", lesson_id);
  for (const record::AttemptRow* head : expert_attempts(heads, expert_ids, lesson_id)) {
    record::AttemptRow whole;
    if (store.attempt(head->id, whole)) out.push_back(std::move(whole));
  }
  return out;
}

Experts experts_of(const std::vector<record::AttemptRow>& all, const std::vector<std::string>& expert_ids,
                   const std::string& lesson_id, const QString& metric) {
  std::map<std::string, std::vector<double>> people;
  bool hands = false;
  for (const record::AttemptRow* a : expert_attempts(all, expert_ids, lesson_id)) {
    const double value = metric_value(*a, metric);
    hands |= is_hand(*a);
    if (std::isfinite(value)) people[a->person_id].push_back(value);
  }
  Experts out;
  for (auto& [id, values] : people) out.values.push_back(std::move(values));
  out.who = hands ? BarWords::tr("recorded expert hand") : out.values.size() == 1 ? BarWords::tr("1 expert") : BarWords::tr("%1 experts").arg(out.values.size());
  return out;
}

QVector<MetricBar> metric_bars(const QVector<record::AttemptRow>& attempts, const ExpertFinder& experts,
                               const std::function<int32_t(const QString&)>& better) {
  QVector<MetricBar> out;
  const auto newest = std::find_if(attempts.begin(), attempts.end(), [](const auto& a) { return counts(a); });
  if (newest == attempts.end()) return out;
  for (const QString& id : metric_ids({*newest})) {
    const int32_t direction = better(id);
    const double value = metric_value(*newest, id);
    if (metric_show(id) == SWAGE_SHOW_YES_NO) continue;  // yes-or-no metrics have no band
    if (!std::isfinite(value) || (direction != SWAGE_BETTER_LOWER && direction != SWAGE_BETTER_HIGHER)) continue;
    const Experts them = experts(newest->lesson_id, id);
    const judge::Band band = judge::expert_band(them.values);
    if (band.attempts == 0) continue;
    QString unit = id == QLatin1String("time") ? QStringLiteral("s") : QStringLiteral("1");
    for (const record::MetricValue& m : newest->metrics)
      if (QString::fromStdString(m.id) == id) unit = metric_unit(id, QString::fromStdString(m.unit));
    std::vector<double> values;
    for (auto a = newest; a != attempts.end(); ++a)
      if (const double v = counts(*a) ? metric_value(*a, id) : std::nan(""); std::isfinite(v)) values.push_back(v);
    out += make_bar(id, unit, values, band, direction == SWAGE_BETTER_HIGHER);
  }
  return out;
}

}  // namespace swage::console
