// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/metric_titles.hpp"

#include <QCoreApplication>
#include <QHash>

#include "console/models/said.hpp"
#include "console/models/words.hpp"

namespace swage::console {
namespace {

struct Label {
  std::string title;
  int32_t show = SWAGE_SHOW_QUANTITY;
};

struct Card {
  int32_t better = SWAGE_BETTER_NONE;
  QString formula;
};

QHash<QString, Card>& cards() {
  static QHash<QString, Card> all;
  return all;
}

QHash<QString, Label>& labels() {
  static QHash<QString, Label> all;
  return all;
}

void learn(const std::vector<host::MetricInfo>& metrics) {
  for (const host::MetricInfo& m : metrics) {
    const QString id = QString::fromStdString(m.id);
    if (!m.title.empty() && !labels().contains(id)) labels().insert(id, {m.title, m.show});
    if (m.evidence != SWAGE_EVIDENCE_NONE && !cards().contains(id)) cards().insert(id, {m.better, QString::fromStdString(m.formula)});
  }
}

}  // namespace

void learn_metric_labels(const std::vector<host::PluginInfo>& plugins) {
  learn(host::pull_metrics());
  for (const host::PluginInfo& plugin : plugins) learn(plugin.metrics);
}

QString metric_title(const QString& id) {
  const auto label = labels().constFind(id);
  // score and time are the host's own, on no card
  if (id == QLatin1String("score")) return QCoreApplication::translate("metric_titles", "Score");
  if (id == QLatin1String("time")) return QCoreApplication::translate("metric_titles", "Time");
  return label == labels().constEnd() ? said_id(id.toStdString()) : said(label->title);
}

QString shown_unit(int32_t show, const QString& unit) {
  if (show == SWAGE_SHOW_SHARE && unit == QLatin1String("1")) return QStringLiteral("%");
  return show == SWAGE_SHOW_YES_NO ? QStringLiteral("yes/no") : unit;
}

QString metric_unit(const QString& id, const QString& unit) { return shown_unit(metric_show(id), unit); }

int32_t metric_show(const QString& id) { return labels().value(id).show; }

int32_t metric_better(const QString& id) { return cards().value(id).better; }
QString metric_formula(const QString& id) { return cards().value(id).formula; }

}  // namespace swage::console
