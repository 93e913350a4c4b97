// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/instructor_window.hpp"

#include <QCloseEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>

#include "console/models/event_log.hpp"

namespace swage::console {

QTableView* make_event_table(QAbstractItemModel* events, QWidget* parent) {
  auto* table = new QTableView(parent);
  table->setAccessibleName(QObject::tr("Events"));
  table->setProperty("card", true);
  table->setModel(events);
  table->setShowGrid(false);
  table->setTabKeyNavigation(false);
  table->setSelectionMode(QAbstractItemView::NoSelection);
  table->verticalHeader()->hide();
  table->verticalHeader()->setDefaultSectionSize(24);
  table->horizontalHeader()->setStretchLastSection(true);
  table->horizontalHeader()->resizeSection(EventLog::kTime, 64);
  table->horizontalHeader()->resizeSection(EventLog::kWhat, 150);
  table->horizontalHeader()->setHighlightSections(false);
  QObject::connect(events, &QAbstractItemModel::rowsInserted, table, &QTableView::scrollToBottom);
  return table;
}

InstructorWindow::InstructorWindow(QAbstractItemModel* events, QWidget* parent)
    : QWidget(parent, Qt::Window), now_(new NowPanel(this)), legend_(new CueLegend(this)) {
  setWindowTitle(tr("Swage: instructor"));
  setObjectName(QStringLiteral("instructor_window"));
  auto* row = new QHBoxLayout(this);
  row->addWidget(now_, 1);
  auto* column = new QVBoxLayout;
  column->addWidget(make_event_table(events, this), 2);
  column->addWidget(legend_, 1);
  row->addLayout(column, 1);
  resize(720, 520);
}

void InstructorWindow::closeEvent(QCloseEvent* event) {
  Q_EMIT closed();
  event->accept();
}

}  // namespace swage::console
