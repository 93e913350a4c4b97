// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/event_table.hpp"

#include <QHeaderView>
#include <QPainter>
#include <QStyledItemDelegate>

#include "console/models/event_log.hpp"

namespace swage::console {
namespace {

constexpr int kTime_px = 60, kLeastWithTime_px = 180;  // beside the time the heading of the event needs 110
constexpr int kLine_px = 22, kTwoLines_px = 36;
constexpr double kSmall = 0.86;   // size of the meaning, of the usual size
constexpr double kMuted = 0.72;   // opacity of the meaning's text

/// Draws an event with its meaning on a second line.
class TwoLines : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    return {QStyledItemDelegate::sizeHint(option, index).width(), meaning(index).isEmpty() ? kLine_px : kTwoLines_px};
  }

  void paint(QPainter* p, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const QString means = meaning(index);
    if (means.isEmpty()) return QStyledItemDelegate::paint(p, option, index);
    p->save();
    const QRect line = option.rect.adjusted(3, 2, -3, -option.rect.height() / 2 + 1), below = option.rect.adjusted(3, line.height() + 1, -3, -1);
    p->setPen(option.palette.color(QPalette::Text));
    draw(p, option.font, line, index.data().toString());
    QFont small = option.font;
    small.setPointSizeF(small.pointSizeF() * kSmall);
    p->setOpacity(kMuted);
    draw(p, small, below, means);
    p->restore();
  }

 private:
  static QString meaning(const QModelIndex& index) { return index.siblingAtColumn(EventLog::kMeans).data().toString(); }
  static void draw(QPainter* p, const QFont& font, const QRect& box, const QString& words) {
    p->setFont(font);
    p->drawText(box, Qt::AlignLeft | Qt::AlignVCenter, QFontMetrics(font).elidedText(words, Qt::ElideRight, box.width()));
  }
};

/// Without room for both, the time is hidden and only told by the tooltip.
class EventTable : public QTableView {
 public:
  using QTableView::QTableView;

 protected:
  void resizeEvent(QResizeEvent* event) override {
    setColumnHidden(EventLog::kTime, width() < kLeastWithTime_px);
    QTableView::resizeEvent(event);
  }
};

}  // namespace

QTableView* make_event_table(QAbstractItemModel* events, QWidget* parent) {
  auto* table = new EventTable(parent);
  table->setAccessibleName(QObject::tr("Events"));
  table->setProperty("card", true);
  table->setModel(events);
  table->setShowGrid(false);
  table->setTabKeyNavigation(false);
  table->setSelectionMode(QAbstractItemView::NoSelection);
  table->setItemDelegateForColumn(EventLog::kWhat, new TwoLines(table));
  table->hideColumn(EventLog::kMeans);
  table->verticalHeader()->hide();
  table->verticalHeader()->setMinimumSectionSize(kLine_px);
  table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table->horizontalHeader()->setStretchLastSection(true);
  table->horizontalHeader()->resizeSection(EventLog::kTime, kTime_px);
  table->horizontalHeader()->setHighlightSections(false);
  // the view learns of the row, and its height, only after this signal
  QObject::connect(events, &QAbstractItemModel::rowsInserted, table, &QTableView::scrollToBottom, Qt::QueuedConnection);
  return table;
}

}  // namespace swage::console
