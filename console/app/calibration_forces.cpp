// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The force part of the calibration: forces of the handle and of the tips, and the check on a gauge.
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>
#include <optional>

#include "console/app/calibration_dialog.hpp"
#include "console/models/said.hpp"
#include "console/widgets/parts.hpp"
#include "sensor/calibration_file.hpp"

namespace swage::console {
namespace {

enum ForceColumn { kHandleColumn, kTipColumn, kVoltsColumn, kForceColumns };

std::optional<double> typed(const QTableWidgetItem* item) {
  bool good = false;
  const double value = item != nullptr ? item->text().trimmed().replace(QLatin1Char(','), QLatin1Char('.')).toDouble(&good) : 0;
  return good && value >= 0 ? std::optional(value) : std::nullopt;
}

}  // namespace

QWidget* CalibrationDialog::make_forces() {
  Card card = make_card(tr("Forces of the handle and of the tips"), this);
  auto* how = new QLabel(tr("Measure \"just closed\" first. Then squeeze, type what the scale at the handle shows and, with a gauge between the tips, what "
                            "it shows; 5 to 11 rows."),
                         card.frame);
  how->setWordWrap(true);
  card.body->addWidget(how);
  force_table_ = new QTableWidget(static_cast<int>(sensor::Draft::kForceRows), kForceColumns, card.frame);
  force_table_->setObjectName(QStringLiteral("calibration_forces"));
  force_table_->setAccessibleName(tr("Forces and volts"));
  force_table_->setHorizontalHeaderLabels({tr("At the handle, N"), tr("At the tips, N"), tr("Volts")});
  force_table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  force_table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  force_table_->setCurrentCell(0, kHandleColumn);
  connect(force_table_, &QTableWidget::itemChanged, this, &CalibrationDialog::read_forces);
  card.body->addWidget(force_table_, 1);
  auto* row = new QHBoxLayout;
  measure_force_ = make_measuring(tr("Measure this force"), "calibration_measure_force", card.frame);
  connect(measure_force_, &QPushButton::clicked, this, [this] { measure(kForce + force_table_->currentRow(), force_table_); });
  check_ = make_measuring(tr("Check at %1 N").arg(QString::number(sensor::kCheckForce)), "calibration_check", card.frame);
  check_->setToolTip(tr("A real needle between the tips on the gauge: squeeze until it shows this force, hold still, press"));
  connect(check_, &QPushButton::clicked, this, [this] { measure(kCheck, check_); });
  tip_ = new QLabel(card.frame);
  tip_->setObjectName(QStringLiteral("calibration_tip"));
  row->addWidget(measure_force_);
  row->addWidget(check_);
  row->addWidget(tip_, 1);
  card.body->addLayout(row);
  forces_ = new QLabel(card.frame);
  forces_->setObjectName(QStringLiteral("calibration_forces_verdict"));
  forces_->setWordWrap(true);
  card.body->addWidget(forces_);
  return card.frame;
}

void CalibrationDialog::read_forces() {
  if (filling_) return;
  for (std::size_t i = 0; i < sensor::Draft::kForceRows; ++i) {
    draft_.force_rows[i].handle_N = typed(force_table_->item(static_cast<int>(i), kHandleColumn));
    draft_.force_rows[i].tip_N = typed(force_table_->item(static_cast<int>(i), kTipColumn));
  }
  show_points();
}

void CalibrationDialog::show_forces() {
  filling_ = true;
  for (int i = 0; i < static_cast<int>(sensor::Draft::kForceRows); ++i) {
    const auto& row = draft_.force_rows[static_cast<size_t>(i)];
    for (int c = 0; c < kForceColumns; ++c)
      if (force_table_->item(i, c) == nullptr) force_table_->setItem(i, c, new QTableWidgetItem);
    force_table_->item(i, kVoltsColumn)->setText(row.volts ? QString::number(*row.volts, 'f', 4) : QString());
    force_table_->item(i, kVoltsColumn)->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
  }
  filling_ = false;
  sensor::Calibration c;
  const std::string wrong = draft_.forces(c);
  if (!wrong.empty()) return forces_->setText(QStringLiteral("▲ ") + said_message(wrong));
  if (c.force.empty()) return forces_->setText(tr("Without new rows the forces of before stay; without any, force is shown and not scored."));
  const auto& last = c.force.points().back();
  forces_->setText(c.tip.empty() ? tr("%1 N at the handle after %2 mm of travel; the tips are not measured.").arg(last.y, 0, 'f', 2).arg(1e3 * last.x, 0, 'f', 2)
                                 : tr("%1 N at the handle after %2 mm of travel, %3 N at the tips.")
                                       .arg(last.y, 0, 'f', 2)
                                       .arg(1e3 * last.x, 0, 'f', 2)
                                       .arg(c.tip.points().back().y, 0, 'f', 2));
}

void CalibrationDialog::show_tip() {
  const auto now = bench_.volts() ? draft_.tip_check(*bench_.volts(), sensor::today()) : std::nullopt;
  check_->setEnabled(now.has_value() && bench_.plugged() && measuring_ < 0);
  if (!now) return tip_->setText(tr("Force at the tips: not calibrated"));
  const auto checked = draft_.check_volts ? draft_.tip_check(*draft_.check_volts, sensor::today()) : std::nullopt;
  if (!checked) return tip_->setText(tr("Force at the tips now: %1 N").arg(now->measured, 0, 'f', 2));
  const bool good = sensor::check_tip(*checked).empty();
  tip_->setText(tr("%1 Now %2 N; checked: %3 N for %4 N")
                    .arg(good ? QStringLiteral("●") : QStringLiteral("▲"))
                    .arg(now->measured, 0, 'f', 2)
                    .arg(checked->measured, 0, 'f', 2)
                    .arg(checked->wanted, 0, 'f', 2));
}

}  // namespace swage::console
