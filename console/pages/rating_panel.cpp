// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/rating_panel.hpp"

#include <QGridLayout>
#include <QWheelEvent>

#include "console/widgets/parts.hpp"

namespace swage::console {
namespace {

/// A turn of the wheel over it scrolls the panel and rates nothing.
class PointsBox : public QComboBox {
 public:
  using QComboBox::QComboBox;

 protected:
  void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

}  // namespace

RatingPanel::RatingPanel(QWidget* parent) : QScrollArea(parent) {
  setObjectName(QStringLiteral("review_ratings"));
  setAccessibleName(tr("Rating scales of surgeons"));
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* box = new QWidget(this);
  column_ = new QVBoxLayout(box);
  column_->setContentsMargins(6, 6, 6, 6);
  column_->setSpacing(4);
  setWidget(box);
}

void RatingPanel::make(const QVector<RatedScale>& scales) {
  for (const RatedScale& scale : scales) {
    QWidget* box = widget();
    column_->addWidget(make_heading(scale.title, box));
    const QString id = QString::fromStdString(scale.id);
    QLabel* computed = computed_[id] = make_muted({}, box);
    computed->setObjectName(QStringLiteral("computed_%1").arg(id));
    column_->addWidget(computed);
    QLabel* given = given_[id] = make_muted({}, box);
    given->setObjectName(QStringLiteral("given_%1").arg(id));
    column_->addWidget(given);
    column_->addWidget(make_muted(tr("Source: %1").arg(scale.source), box));
    auto* grid = new QGridLayout;
    grid->setColumnStretch(0, 1);
    grid->setHorizontalSpacing(10);
    grid->addWidget(make_muted(tr("Computed"), box), 0, 1);
    grid->addWidget(make_muted(tr("Your rating"), box), 0, 2);
    for (const RatedItem& item : scale.items) make_item(scale, item, grid);
    column_->addLayout(grid);
    column_->addSpacing(10);
  }
  column_->addStretch(1);
}

void RatingPanel::make_item(const RatedScale& scale, const RatedItem& item, QGridLayout* grid) {
  const QString id = QString::fromStdString(item.id);
  const int row = grid->rowCount();
  auto* title = new QLabel(item.title, widget());
  title->setToolTip(item.doc);
  title->setWordWrap(true);
  Line line;
  line.computed = new QLabel(widget());
  line.computed->setToolTip(item.doc);
  line.given = new PointsBox(widget());
  line.given->setObjectName(QStringLiteral("rate_%1").arg(id));
  line.given->setAccessibleName(tr("Your rating: %1").arg(item.title));
  line.given->addItem(QStringLiteral("–"));
  for (int points = static_cast<int>(scale.lowest); points <= static_cast<int>(scale.highest); ++points)
    line.given->addItem(QString::number(points), static_cast<double>(points));
  title->setBuddy(line.given);
  connect(line.given, &QComboBox::activated, this, [this, id, box = line.given] {
    const QVariant points = box->currentData();
    Q_EMIT rated(id, points.isValid() ? std::optional<double>(points.toDouble()) : std::nullopt);
  });
  grid->addWidget(title, row, 0);
  grid->addWidget(line.computed, row, 1);
  grid->addWidget(line.given, row, 2);
  lines_[id] = line;
}

void RatingPanel::set_scales(const QVector<RatedScale>& scales, bool editable) {
  if (lines_.isEmpty()) make(scales);
  for (const RatedScale& scale : scales) {
    const QString id = QString::fromStdString(scale.id);
    if (!computed_.contains(id)) continue;
    computed_[id]->setText(scale.computed_words());
    given_[id]->setText(scale.given_words());
    given_[id]->setVisible(scale.given > 0);
    for (const RatedItem& item : scale.items) {
      const Line& line = lines_[QString::fromStdString(item.id)];
      line.computed->setText(item.computed ? scale.points_words(*item.computed) : tr("not decided"));
      line.given->setCurrentIndex(item.given ? std::max(0, line.given->findData(*item.given)) : 0);
      line.given->setEnabled(editable);
      line.given->setToolTip(editable ? tr("Your own points; kept with the attempt, and taken back with Ctrl+Z")
                                      : tr("Ratings are kept with attempts of the store."));
    }
  }
}

}  // namespace swage::console
