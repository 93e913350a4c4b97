// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/result_panel.hpp"

#include <QAccessible>
#include <cmath>

#include "console/models/metric_titles.hpp"
#include "console/models/words.hpp"
#include "console/widgets/parts.hpp"

namespace swage::console {

QString reason_text(const std::string& reason, const judge::Script& script) {
  for (const judge::Name& e : script.events) {
    if (e.id == reason && !e.doc.empty()) return QString::fromStdString(e.doc);
  }
  return human_id(QString::fromStdString(reason));
}

ResultPanel::ResultPanel(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("result"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  Card card = make_card(tr("Result"), this);
  outcome_ = new QLabel(card.frame);
  outcome_->setObjectName(QStringLiteral("outcome"));
  outcome_->setProperty("big", true);
  reason_ = new QLabel(card.frame);
  reason_->setWordWrap(true);
  metrics_ = new QGridLayout;
  metrics_->setColumnStretch(0, 1);
  metrics_->setVerticalSpacing(5);
  kept_ = make_muted({}, card.frame);
  problems_ = make_muted({}, card.frame);
  card.body->addWidget(outcome_);
  card.body->addWidget(reason_);
  card.body->addSpacing(4);
  card.body->addLayout(metrics_);
  card.body->addWidget(kept_);
  card.body->addWidget(problems_);
  auto* row = new QHBoxLayout;
  auto* again = make_button(tr("Again"), QStringLiteral("F5"), QStringLiteral("again"), card.frame);
  auto* progress = make_button(tr("Progress"), {}, QStringLiteral("to_progress"), card.frame);
  row->addWidget(again);
  row->addWidget(progress);
  card.body->addLayout(row);
  card.body->addStretch(1);
  column->addWidget(card.frame);
  connect(again, &QPushButton::clicked, this, &ResultPanel::again);
  connect(progress, &QPushButton::clicked, this, &ResultPanel::progress);
}

void ResultPanel::set_theme(const UiTheme& theme) {
  theme_ = theme;
  paint_outcome();
}

void ResultPanel::paint_outcome() {
  const bool met = state_ == judge::Outcome::kPassed;
  const bool neutral = state_ == judge::Outcome::kAborted || state_ == judge::Outcome::kVoid;
  const QColor colour = met ? theme_["good"] : neutral ? theme_["muted"] : theme_["warn"];
  outcome_->setStyleSheet(QStringLiteral("color: %1").arg(colour.name()));
}

void ResultPanel::show_result(const session::Result& r, const snapshot::SceneCard& card, bool kept) {
  state_ = r.outcome;
  // a sign beside the word: no verdict by colour alone
  const QString sign = r.outcome == judge::Outcome::kPassed   ? QStringLiteral("✓ ")
                       : r.outcome == judge::Outcome::kFailed ? QStringLiteral("✗ ")
                                                              : QString();
  outcome_->setText(sign + verdict_text(QString::fromLatin1(judge::text(r.outcome))));
  reason_->setText(r.outcome == judge::Outcome::kAborted ? tr("Stopped before the lesson was over.")
                                                         : reason_text(r.reason, card.script));
  paint_outcome();

  while (QLayoutItem* item = metrics_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  int row = 0;
  const auto add = [&](const QString& name, const QString& value, const QString& doc) {
    auto* label = make_muted(name, this);
    auto* number = new QLabel(value, this);
    label->setToolTip(doc);
    number->setToolTip(doc);
    number->setAccessibleName(name);
    metrics_->addWidget(label, row, 0);
    metrics_->addWidget(number, row++, 1, Qt::AlignRight);
  };
  if (r.outcome == judge::Outcome::kPassed)
    add(tr("Score"), QStringLiteral("%1 / 100").arg(r.score, 0, 'f', 0), {});
  add(tr("Time"), clock_text(r.simulated_s), {});
  for (const session::Result::Metric& m : r.metrics) {
    if (!std::isfinite(m.value)) continue;  // not reported: there was none
    const QString id = QString::fromStdString(m.id);
    add(metric_title(id), quantity_text(m.value, metric_unit(id, QString::fromStdString(m.unit))),
        QString::fromStdString(m.doc));
  }
  kept_->setText(kept ? tr("Recorded.") : tr("Not recorded."));
  QStringList notes;
  for (const base::Problem& p : r.problems) {
    if (p.severity != base::Severity::kNote) notes += QString::fromStdString(p.where + ": " + p.message);
  }
  problems_->setText(notes.join(QLatin1Char('\n')));
  problems_->setVisible(!notes.isEmpty());
  outcome_->setAccessibleName(tr("Result"));
  outcome_->setAccessibleDescription(outcome_->text() + QStringLiteral(". ") + reason_->text());
  QAccessibleEvent announce(outcome_, QAccessible::Alert);
  QAccessible::updateAccessibility(&announce);
}

}  // namespace swage::console
