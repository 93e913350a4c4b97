// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/instructor_window.hpp"

#include <QCloseEvent>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "console/pages/event_table.hpp"
#include "console/widgets/parts.hpp"
#include "console/widgets/trace_plot.hpp"

namespace swage::console {
namespace {

constexpr int kPlot_px = 110;  // of a plot, whose three numbers overlap below 90

}  // namespace

InstructorWindow::InstructorWindow(QAbstractItemModel* events, QWidget* parent)
    : QWidget(parent, Qt::Window), now_(new NowPanel(this)), legend_(new CueLegend(this)) {
  setWindowTitle(tr("Swage: instructor"));
  setObjectName(QStringLiteral("instructor_window"));
  auto* all = new QVBoxLayout(this);
  subject_ = new ElidedLabel(this);
  subject_->setObjectName(QStringLiteral("instructor_subject"));
  all->addWidget(subject_);
  auto* row = new QHBoxLayout;
  all->addLayout(row, 1);
  // the list of what is asked, shown after the attempt, scrolls: it must not stretch the window
  QScrollArea* scroll = make_scroll(this);
  scroll->setWidget(now_);
  for (auto* plot : now_->findChildren<TracePlot*>()) plot->setMinimumHeight(kPlot_px);
  row->addWidget(scroll, 1);
  auto* column = new QVBoxLayout;
  column->addWidget(make_event_table(events, this), 2);
  column->addWidget(legend_, 1);
  row->addLayout(column, 1);
  resize(920, 680);
}

void InstructorWindow::closeEvent(QCloseEvent* event) {
  Q_EMIT closed();
  event->accept();
}

}  // namespace swage::console
