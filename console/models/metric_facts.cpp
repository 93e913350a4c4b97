// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/metric_facts.hpp"

#include <QObject>
#include <QStringList>
#include <algorithm>

namespace swage::console {
namespace {

// what is known of the metrics that the stock lessons use; of others no direction is claimed
int32_t guess(const QString& id) {
  static const QStringList lower = {"time", "tries",  "drops",   "error",     "over_",   "peak",
                                    "tilt", "path",   "regrasp", "different", "balance", "slip",
                                    "snap", "tremor", "bend",    "tear"};
  static const QStringList higher = {"score", "in_zone", "success", "progress", "smooth"};
  const auto names = [&](const QStringList& words) {
    return std::any_of(words.begin(), words.end(), [&](const QString& w) { return id.contains(w); });
  };
  return names(higher) ? SWAGE_BETTER_HIGHER : names(lower) ? SWAGE_BETTER_LOWER : SWAGE_BETTER_NONE;
}

}  // namespace

MetricFacts metric_facts(const snapshot::SceneCard* card, const std::string& id) {
  const size_t n = card ? std::min(card->metrics.size(), card->script.metrics.size()) : 0;
  for (size_t i = 0; i < n; ++i) {
    const snapshot::CardMetric& m = card->metrics[i];
    if (card->script.metrics[i].id == id && m.evidence != SWAGE_EVIDENCE_NONE)
      return {m.better, QString::fromStdString(m.formula)};
  }
  return {guess(QString::fromStdString(id)), {}};
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
