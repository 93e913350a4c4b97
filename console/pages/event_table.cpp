// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/event_table.hpp"

#include <QHeaderView>
#include <QPainter>
#include <QStyledItemDelegate>
#include <algorithm>

#include "console/models/event_log.hpp"

namespace swage::console {
namespace {

constexpr int kTime_px = 60, kLeastWithTime_px = 180;  // beside the time the heading of the event needs 110
constexpr int kLine_px = 22, kTwoLines_px = 36;
constexpr double kSmall = 0.86;   // size of the meaning, of the usual size
constexpr double kMuted = 0.72;   // opacity of the meaning's text

/// Draws an event and below it, smaller, its meaning, each in as many lines as it needs.
class TwoTexts : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const QSize usual = QStyledItemDelegate::sizeHint(option, index);
    const int wide = option.rect.width() - 2 * kBeside_px;
    if (wide < kLeastWide_px) return {usual.width(), meaning(index).isEmpty() ? kLine_px : kTwoLines_px};  // not laid out yet
    const int high = height(option.font, index.data().toString(), wide) + height(small(option.font), meaning(index), wide);
    return {usual.width(), std::max(kLine_px, high + 2 * kAbove_px)};
  }

  void paint(QPainter* p, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    p->save();
    QRect box = option.rect.adjusted(kBeside_px, kAbove_px, -kBeside_px, -kAbove_px);
    const QString what = index.data().toString();
    p->setFont(option.font);
    p->setPen(option.palette.color(QPalette::Text));
    p->drawText(box, kWrapped, what);
    box.setTop(box.top() + height(option.font, what, box.width()));
    p->setFont(small(option.font));
    p->setOpacity(kMuted);
    p->drawText(box, kWrapped, meaning(index));
    p->restore();
  }

 private:
  static constexpr int kBeside_px = 3, kAbove_px = 2, kLeastWide_px = 40;
  static constexpr int kWrapped = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;

  static QString meaning(const QModelIndex& index) { return index.siblingAtColumn(EventLog::kMeans).data().toString(); }
  static QFont small(QFont font) {
    font.setPointSizeF(font.pointSizeF() * kSmall);
    return font;
  }
  static int height(const QFont& font, const QString& words, int wide) {
    return words.isEmpty() ? 0 : QFontMetrics(font).boundingRect(QRect(0, 0, wide, 1 << 14), kWrapped, words).height();
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
    resizeRowsToContents();  // the lines of a sentence follow the width
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
  table->setItemDelegateForColumn(EventLog::kWhat, new TwoTexts(table));
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
