// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/review_side.hpp"

#include <QEvent>
#include <QTabBar>
#include <QVBoxLayout>

#include "console/pages/rating_panel.hpp"
#include "console/pages/review_tables.hpp"
#include "console/widgets/parts.hpp"
#include "console/widgets/plot_file.hpp"

namespace swage::console {

ReviewSide::ReviewSide(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  tabs_ = new QTabWidget(this);
  tabs_->setObjectName(QStringLiteral("review_tabs"));
  tabs_->setAccessibleName(tr("Metrics, events, traces"));
  tabs_->setDocumentMode(true);
  // no tab is hidden behind an arrow, and the page leaves room for every title
  tabs_->setUsesScrollButtons(false);
  tabs_->addTab(make_metrics(), tr("&Metrics"));
  tabs_->addTab(worst_ = new WorstTable(tabs_), tr("&Worst"));
  tabs_->setTabToolTip(1, tr("Worst moments"));
  tabs_->addTab(moments_ = new MomentsTable(tabs_), tr("&Events"));
  tabs_->addTab(traces_ = new TracesList(tabs_), tr("&Traces"));
  track_ = new TrackPlot(tabs_);
  offer_picture(track_, QStringLiteral("entry"));
  tabs_->addTab(track_, tr("E&ntry"));
  ratings_ = new RatingPanel(tabs_);
  tabs_->addTab(ratings_, tr("&Scales"));
  tabs_->setTabToolTip(tabs_->indexOf(ratings_), tr("Rating scales of surgeons: as computed from metrics, and your own rating"));
  column->addWidget(tabs_, 1);
  legend_ = new CueLegend(this);
  column->addWidget(legend_);
  connect(moments_, &MomentsTable::chosen, this, &ReviewSide::chosen);
  connect(worst_, &WorstTable::chosen, this, &ReviewSide::chosen);
  connect(worst_, &WorstTable::loop, this, &ReviewSide::loop);
  connect(traces_, &TracesList::shown, this, &ReviewSide::traces_shown);
  connect(ratings_, &RatingPanel::rated, this, &ReviewSide::rated);
}

// how wide the titles are is known once fonts and style are
bool ReviewSide::event(QEvent* event) {
  const bool done = QWidget::event(event);
  if (event->type() == QEvent::Show || event->type() == QEvent::StyleChange || event->type() == QEvent::FontChange)
    tabs_->setMinimumWidth(tabs_->tabBar()->sizeHint().width());
  return done;
}

// The table, and below it what the lesson asks of the chosen metric: a tooltip is not reached by keys.
QWidget* ReviewSide::make_metrics() {
  auto* box = new QWidget(tabs_);
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  column->addWidget(metrics_ = new MetricsTable(box), 1);
  asked_ = new ElidedLabel(box);
  asked_->setObjectName(QStringLiteral("review_asked"));
  asked_->setProperty("muted", true);
  column->addWidget(asked_);
  connect(metrics_, &MetricsTable::asked, asked_, &QLabel::setText);
  return box;
}

void ReviewSide::set_themes(const UiTheme& ui, const CueTheme& cues) {
  metrics_->set_theme(ui);
  track_->set_theme(ui);
  legend_->set_themes(ui, cues);
}

QList<QWidget*> ReviewSide::tables() const { return {metrics_, moments_, worst_}; }

void ReviewSide::fill_metrics(const Review& review, const Review* other) { metrics_->fill(review, other); }

void ReviewSide::show_scales(const Review& review, bool can_rate) {
  ratings_->set_scales(QString::fromStdString(review.attempt.id), review.scales, can_rate);
}

void ReviewSide::fill(const Review& review, const record::Recording& recording, const QVector<WorstMoment>& worst, bool can_rate) {
  show_scales(review, can_rate);
  moments_->fill(review.moments);
  const std::optional<EntryTrack> track = entry_track(recording);
  track_->set_track(track);
  tabs_->setTabVisible(tabs_->indexOf(track_), track.has_value());
  worst_->fill(worst);
  tabs_->setTabVisible(tabs_->indexOf(worst_), !worst.isEmpty());
  tabs_->setMinimumWidth(tabs_->tabBar()->sizeHint().width());
  traces_->fill(review.traces);
}

void ReviewSide::next_worst() {
  if (worst_->rowCount() == 0) return;
  tabs_->setCurrentWidget(worst_);
  worst_->next();
}

}  // namespace swage::console
