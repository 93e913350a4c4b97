// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/instructor_window.hpp"

#include <QCloseEvent>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "console/pages/event_table.hpp"

namespace swage::console {

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
