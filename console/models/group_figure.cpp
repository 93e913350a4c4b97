// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/group_figure.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "console/models/metric_bars.hpp"
#include "console/models/metric_titles.hpp"
#include "console/models/said.hpp"
#include "console/models/words.hpp"

namespace swage::console {
namespace {

QString unit_of(const record::AttemptRow& a, const QString& metric) {
  if (metric == QLatin1String("time")) return QStringLiteral("s");
  for (const record::MetricValue& m : a.metrics)
    if (QString::fromStdString(m.id) == metric) return metric_unit(metric, QString::fromStdString(m.unit));
  return QStringLiteral("1");
}

// title or name of each id, in order of these texts
struct Names {
  std::map<std::string, QString> by_id;
  QStringList words;
  void add(const std::string& id, const QString& name) { by_id.emplace(id, name.isEmpty() ? QString::fromStdString(id) : name); }
  std::map<std::string, int> order() {
    std::vector<std::pair<QString, std::string>> all;
    for (const auto& [id, name] : by_id) all.emplace_back(name, id);
    std::sort(all.begin(), all.end());
    std::map<std::string, int> out;
    for (const auto& [name, id] : all) out[id] = static_cast<int>(words.size()), words += name;
    return out;
  }
};

}  // namespace

GroupFigure group_figure(const std::vector<record::AttemptRow>& attempts, const QString& metric) {
  GroupFigure out;
  Names lessons, people;
  std::vector<const record::AttemptRow*> used;
  for (const record::AttemptRow& a : attempts) {
    if (!counts(a) || !std::isfinite(metric_value(a, metric))) continue;
    used.push_back(&a);
    lessons.add(a.lesson_id, said(a.lesson_title));
    people.add(a.person_id, person_text(QString::fromStdString(a.person_name)));
  }
  out.metric = metric_title(metric);
  out.attempts = static_cast<int>(used.size());
  if (used.empty()) return out;
  const QString unit = unit_of(*used.front(), metric);
  const double factor = display_factor(unit);
  out.unit = display_unit(unit);
  const std::map<std::string, int> row = lessons.order(), place = people.order();
  out.lessons = lessons.words;
  out.people = people.words;
  out.cell.resize(out.lessons.size());
  for (QVector<GroupCell>& cells : out.cell) cells.resize(out.people.size());
  out.low = out.high = 0;
  for (auto it = used.rbegin(); it != used.rend(); ++it) {
    const double value = factor * metric_value(**it, metric);
    out.cell[row.at((*it)->lesson_id)][place.at((*it)->person_id)].dots += {value, (*it)->outcome == "passed"};
    out.low = std::min(out.low, value);
    out.high = std::max(out.high, value);
  }
  if (out.high <= out.low) out.high = out.low + 1;
  for (QVector<GroupCell>& cells : out.cell)
    for (GroupCell& cell : cells) {
      double sum = 0;
      for (const GroupDot& dot : cell.dots) sum += dot.value;
      cell.mean = cell.dots.isEmpty() ? std::nan("") : sum / static_cast<double>(cell.dots.size());
    }
  return out;
}

}  // namespace swage::console
