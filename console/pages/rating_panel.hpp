// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The rating scales of surgeons for one attempt: each item with its computed points, and the instructor's own beside them.
#pragma once

#include <QComboBox>
#include <QHash>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>
#include <optional>

#include "console/models/ratings.hpp"

namespace swage::console {

class RatingPanel : public QScrollArea {
  Q_OBJECT
 public:
  explicit RatingPanel(QWidget* parent = nullptr);
  /// `editable`: the instructor's points can be stored, as for an attempt of the store.
  void set_scales(const QString& attempt, const QVector<RatedScale>& scales, bool editable);

 Q_SIGNALS:
  /// The instructor chose points for an item, or removed them.
  void rated(const QString& item_id, std::optional<double> points);

 private:
  /// The labels and the box of an item; they are kept for all attempts, which have the same scales.
  struct Line {
    QLabel* computed = nullptr;
    QComboBox* given = nullptr;
  };
  void make(const QVector<RatedScale>& scales);
  void order(QVector<RatedScale> scales);
  void make_item(const RatedScale& scale, const RatedItem& item, class QGridLayout* grid);

  QVBoxLayout* column_ = nullptr;
  QString attempt_;
  QHash<QString, QWidget*> boxes_;            // by scale
  QHash<QString, QLabel*> computed_, given_;  // by scale: its sentences
  QHash<QString, Line> lines_;                // by item
};

}  // namespace swage::console
