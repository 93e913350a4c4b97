// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/rating_panel.hpp"

#include <QGridLayout>
#include <QWheelEvent>
#include <algorithm>
#include <utility>

#include "console/widgets/parts.hpp"

namespace swage::console {
namespace {

/// Ignores the mouse wheel, which scrolls the panel instead of changing a rating.
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
    const QString id = QString::fromStdString(scale.id);
    QWidget* box = boxes_[id] = new QWidget(widget());
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 10);
    column->setSpacing(4);
    column->addWidget(make_heading(scale.title, box));
    const auto sentence = [&](const char* name) {
      QLabel* label = make_muted({}, box);
      label->setObjectName(QLatin1String(name) + id);
      column->addWidget(label);
      return label;
    };
    computed_[id] = sentence("computed_");
    given_[id] = sentence("given_");
    auto* grid = new QGridLayout;
    grid->setColumnStretch(0, 1);
    grid->setHorizontalSpacing(10);
    const auto head = [&](const QString& text, int at) {
      QLabel* label = make_muted(text, box);
      label->setWordWrap(false);
      grid->addWidget(label, 0, at);
    };
    head(tr("Computed"), 1);
    head(tr("Your rating"), 2);
    for (const RatedItem& item : scale.items) make_item(scale, item, grid);
    column->addLayout(grid);
    column->addWidget(make_muted(tr("Source: %1").arg(scale.source), box));
    column_->addWidget(box);
  }
  column_->addStretch(1);
}

// Scales with items decided by the attempt come first, then those with the instructor's points.
void RatingPanel::order(QVector<RatedScale> scales) {
  std::stable_sort(scales.begin(), scales.end(), [](const RatedScale& a, const RatedScale& b) {
    return std::pair(a.decided > 0, a.given > 0) > std::pair(b.decided > 0, b.given > 0);
  });
  for (int i = 0; i < scales.size(); ++i) {
    QWidget* box = boxes_.value(QString::fromStdString(scales[i].id));
    if (box == nullptr || column_->indexOf(box) == i) continue;
    column_->removeWidget(box);
    column_->insertWidget(i, box);
  }
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

void RatingPanel::set_scales(const QString& attempt, const QVector<RatedScale>& scales, bool editable) {
  if (lines_.isEmpty()) make(scales);
  // the order is kept while an attempt is being rated
  if (attempt != attempt_) order(scales);
  attempt_ = attempt;
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
