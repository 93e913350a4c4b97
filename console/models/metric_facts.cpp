// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/metric_facts.hpp"

#include <QObject>
#include <algorithm>

#include "console/models/metric_titles.hpp"

namespace swage::console {
MetricFacts metric_facts(const snapshot::SceneCard* card, const std::string& id) {
  const size_t n = card ? std::min(card->metrics.size(), card->script.metrics.size()) : 0;
  for (size_t i = 0; i < n; ++i) {
    const snapshot::CardMetric& m = card->metrics[i];
    if (card->script.metrics[i].id == id && m.evidence != SWAGE_EVIDENCE_NONE)
      return {m.better, QString::fromStdString(m.formula)};
  }
  // score and time are the host's own
  if (id == "score") return {SWAGE_BETTER_HIGHER, {}};
  if (id == "time") return {SWAGE_BETTER_LOWER, {}};
  const QString said = QString::fromStdString(id);
  return {metric_better(said), metric_formula(said)};
}

QString better_words(int32_t better, bool arrow) {
  switch (better) {
    case SWAGE_BETTER_LOWER:
      return (arrow ? QStringLiteral("↓ ") : QString()) + QObject::tr("lower is better");
    case SWAGE_BETTER_HIGHER:
      return (arrow ? QStringLiteral("↑ ") : QString()) + QObject::tr("higher is better");
    case SWAGE_BETTER_INSIDE:
      return (arrow ? QStringLiteral("↔ ") : QString()) + QObject::tr("best inside its band");
    default:
      return {};
  }
}

}  // namespace swage::console
