// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The right side of the Review page: metrics, events, notes, choice of traces; and exports.
#include <QHeaderView>
#include <QInputDialog>
#include <QMenu>
#include <QSaveFile>
#include <QVBoxLayout>
#include <cmath>
#include <utility>

#include "console/pages/comparison.hpp"
#include "console/pages/rating_panel.hpp"
#include "console/pages/review_page.hpp"
#include "console/report/attempt_report.hpp"
#include "console/widgets/parts.hpp"
#include "console/widgets/plot_file.hpp"
#include "console/widgets/save_file.hpp"

namespace swage::console {
namespace {

constexpr int kOtherColumn = 3;  // of the metrics: those of the compared attempt
constexpr int kMostTraces = 6;  // with more each trace would be too low

QTableWidget* make_table(const QStringList& heads, int stretch, const char* name, const QString& accessible,
                         QWidget* parent) {
  auto* table = new QTableWidget(0, static_cast<int>(heads.size()), parent);
  table->setObjectName(QString::fromLatin1(name));
  table->setAccessibleName(accessible);
  table->setHorizontalHeaderLabels(heads);
  table->setShowGrid(false);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setSelectionMode(QAbstractItemView::SingleSelection);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setTabKeyNavigation(false);
  table->verticalHeader()->hide();
  table->verticalHeader()->setDefaultSectionSize(24);
  table->horizontalHeader()->setHighlightSections(false);
  table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table->horizontalHeader()->setSectionResizeMode(stretch, QHeaderView::Stretch);
  return table;
}

QTableWidgetItem* item(const QString& text, const QString& tip = {}) {
  auto* out = new QTableWidgetItem(text);
  out->setToolTip(tip.isEmpty() ? text : tip);
  return out;
}

QString write_file(const QString& name, const std::string& text) {
  QSaveFile file(name);
  const bool ok =
      file.open(QIODevice::WriteOnly) &&
      file.write(text.data(), static_cast<qint64>(text.size())) == static_cast<qint64>(text.size()) &&
      file.commit();
  return ok ? QString() : QObject::tr("%1 cannot be written: %2.").arg(name, file.errorString());
}

}  // namespace

QWidget* ReviewPage::make_side() {
  auto* box = new QWidget(this);
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  auto* tabs = tabs_ = new QTabWidget(box);
  tabs->setObjectName(QStringLiteral("review_tabs"));
  tabs->setAccessibleName(tr("Metrics, events, traces"));
  tabs->setDocumentMode(true);
  // on a small screen tab titles are elided, so that no tab is hidden behind an arrow
  tabs->setUsesScrollButtons(false);
  tabs->setElideMode(Qt::ElideRight);
  make_tables(tabs);
  tabs->addTab(metrics_, tr("&Metrics"));
  tabs->addTab(worst_, tr("&Worst"));
  tabs->setTabToolTip(1, tr("Worst moments"));
  tabs->addTab(moments_, tr("&Events"));
  tabs->addTab(traces_, tr("&Traces"));
  track_ = new TrackPlot(tabs);
  offer_picture(track_, QStringLiteral("entry"));
  tabs->addTab(track_, tr("E&ntry"));
  ratings_ = new RatingPanel(tabs);
  tabs->addTab(ratings_, tr("&Scales"));
  tabs->setTabToolTip(tabs->indexOf(ratings_), tr("Rating scales of surgeons: as computed from metrics, and your own rating"));
  connect(ratings_, &RatingPanel::rated, this, &ReviewPage::rate);
  column->addWidget(tabs, 1);
  legend_ = new CueLegend(box);
  column->addWidget(legend_);
  return box;
}

void ReviewPage::make_tables(QWidget* tabs) {
  metrics_ =
      make_table({tr("Metric"), tr("Value"), tr("Better"), tr("Other attempt")}, 0, "review_metrics", tr("Metrics"), tabs);
  moments_ = make_table({tr("Time"), tr("What happened"), tr("Meaning")}, 2, "review_moments",
                        tr("What happened"), tabs);
  traces_ = new QListWidget(tabs);
  traces_->setObjectName(QStringLiteral("review_traces"));
  traces_->setAccessibleName(tr("Which traces are shown"));
  metrics_->setColumnHidden(kOtherColumn, true);
  // a sentence that does not fit takes a second line
  moments_->setWordWrap(true);
  moments_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  worst_ = make_table({tr("Time"), tr("What")}, 1, "review_worst", tr("Worst moments"), tabs);
  worst_->setToolTip(tr("A click goes there, Enter or a double click plays it again and again; W: the next"));
  const auto to_moment = [this](int row) {
    if (row >= 0) go(moments_->item(row, 0)->data(Qt::UserRole).toDouble());
  };
  connect(moments_, &QTableWidget::cellClicked, this, to_moment);
  connect(moments_, &QTableWidget::cellActivated, this, to_moment);
  connect(worst_, &QTableWidget::cellClicked, this, &ReviewPage::to_worst);
  connect(worst_, &QTableWidget::cellActivated, this, &ReviewPage::loop_worst);
  connect(traces_, &QListWidget::itemChanged, this, &ReviewPage::show_traces);
}

// Measurements first, then deductions under a heading of their own, as both may have the same name.
void ReviewPage::fill_metrics() {
  metrics_->clearSpans();
  metrics_->setRowCount(0);
  metrics_->setColumnHidden(kOtherColumn, !comparing());
  const auto add = [this](const MetricLine& m) {
    const int row = metrics_->rowCount();
    metrics_->insertRow(row);
    metrics_->setItem(row, 0, item(m.name, m.doc));
    metrics_->setItem(row, 1, item(m.value, m.doc));
    metrics_->item(row, 1)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    if (comparing()) {
      const MetricLine* same = comparison()->review().metric(m.id);
      metrics_->setItem(row, kOtherColumn, item(same ? same->value : QStringLiteral("–"), m.doc));
      metrics_->item(row, kOtherColumn)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    }
    if (m.points) return;
    // the arrow alone, as text would leave too little room for the names on a small screen
    metrics_->setItem(row, 2, item(better_words(m.better).left(1), better_words(m.better, false)));
    metrics_->item(row, 2)->setTextAlignment(Qt::AlignHCenter | Qt::AlignVCenter);
    metrics_->item(row, 2)->setData(Qt::AccessibleTextRole, better_words(m.better, false));
  };
  for (const MetricLine& m : review_.metrics)
    if (!m.points) add(m);
  bool headed = false;
  for (const MetricLine& m : review_.metrics) {
    if (!m.points) continue;
    if (!std::exchange(headed, true)) {
      const int row = metrics_->rowCount();
      metrics_->insertRow(row);
      auto* head = item(tr("Points lost, of 100"), tr("What each fault has cost of the score"));
      QFont bold = metrics_->font();
      bold.setBold(true);
      head->setFont(bold);
      metrics_->setItem(row, 0, head);
      metrics_->setSpan(row, 0, 1, metrics_->columnCount());
    }
    add(m);
  }
}

void ReviewPage::fill_side() {
  fill_metrics();
  ratings_->set_scales(QString::fromStdString(review_.attempt.id), review_.scales, from_store_ && desk_ && desk_->school());
  moments_->setRowCount(0);
  for (const Moment& m : review_.moments) {
    if (m.technical) continue;
    const int row = moments_->rowCount();
    moments_->insertRow(row);
    moments_->setItem(row, 0, item(tr("%L1 s").arg(m.time_s, 0, 'f', 2)));
    moments_->item(row, 0)->setData(Qt::UserRole, m.time_s);
    moments_->setItem(row, 1, item(m.what));
    moments_->setItem(row, 2, item(m.means));
  }
  const std::optional<EntryTrack> track = entry_track(recording_);
  track_->set_track(track);
  tabs_->setTabVisible(tabs_->indexOf(track_), track.has_value());
  fill_worst();
  fill_traces();
}

void ReviewPage::fill_traces() {
  const QSignalBlocker quiet(traces_);
  traces_->clear();
  int shown = 0;
  for (int i = 0; i < review_.traces.size(); ++i) {
    const Trace& t = review_.traces[i];
    auto* entry = new QListWidgetItem(t.flat ? tr("%1 (never changes)").arg(t.name) : t.name, traces_);
    entry->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    const bool on = t.wanted && shown < 4;
    shown += on;
    entry->setCheckState(on ? Qt::Checked : Qt::Unchecked);
    entry->setToolTip(t.tip);
  }
  show_traces();
}

void ReviewPage::show_traces() {
  QVector<int> shown;
  for (int i = 0; i < traces_->count() && shown.size() < kMostTraces; ++i) {
    if (traces_->item(i)->checkState() == Qt::Checked) shown += i;
  }
  timeline_->set_shown(shown);
}

// The report has a button; exports for other programs are in a menu, so that the title has room.
void ReviewPage::add_exports(QHBoxLayout* row, QWidget* box) {
  report_ = make_button(tr("Report (PDF)"), {}, QStringLiteral("save_report"), box);
  report_->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_R));
  report_->setToolTip(QStringLiteral("%1 (%2)").arg(tr("Pages to print: result, metrics, ratings, worst moments, traces, notes"),
                                                     report_->shortcut().toString(QKeySequence::NativeText)));
  connect(report_, &QPushButton::clicked, this,
          [this] { save(tr("Save pages about the attempt"), QStringLiteral("_report.pdf"), &ReviewPage::write_report); });
  row->addWidget(report_);
  export_ = make_button(tr("Export"), {}, QStringLiteral("review_export"), box);
  export_->setToolTip(tr("The attempt as a file for other programs, or for another station"));
  auto* menu = new QMenu(export_);
  menu->setToolTipsVisible(true);
  export_->setMenu(menu);
  row->addWidget(export_);
  const struct {
    QString text, name, title, ending, tip;
    QKeySequence key;
    QString (ReviewPage::*write)(const QString&);
  } exports[] = {{tr("Save attempt"), QStringLiteral("save_swage"), tr("Save the whole attempt"), QStringLiteral(".swage"),
                  tr("Everything in one file: swage replay and another station's Swage can read it"),
                  QKeySequence(Qt::CTRL | Qt::Key_E), &ReviewPage::write_swage},
                 {tr("Export signals (CSV)"), QStringLiteral("save_signals"), tr("Save the signals"), QStringLiteral("_signals.csv"),
                  tr("A thousand lines a second, SI units"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_E), &ReviewPage::write_signals},
                 {tr("Export summary (CSV)"), QStringLiteral("save_summary"), tr("Save metrics and events"),
                  QStringLiteral("_summary.csv"), tr("Facts, metrics, ratings and events"),
                  QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S), &ReviewPage::write_summary}};
  for (const auto& e : exports) {
    QAction* action = menu->addAction(e.text);
    action->setObjectName(e.name);
    action->setToolTip(e.tip);
    action->setShortcut(e.key);
    connect(action, &QAction::triggered, this, [this, e] { save(e.title, e.ending, e.write); });
    exports_ += action;
  }
}

void ReviewPage::set_exports_enabled(bool on) {
  for (QAction* action : exports_) action->setEnabled(on);
  export_->setEnabled(on);
  report_->setEnabled(on);
}

QString ReviewPage::write_swage(const QString& file) {
  std::string error;
  const bool ok = store_ && store_->export_attempt(review_.attempt.id, file.toStdString(), error);
  return ok ? QString() : tr("%1 cannot be written: %2").arg(file, QString::fromStdString(error));
}

std::vector<record::Exported> ReviewPage::exported() const {
  std::vector<record::Exported> out;
  std::string unread;
  if (!exported_ || !exported_(file_, {{}, {}, review_.attempt.id}, out, unread)) out.clear();
  return out;
}

// writes numbers only; what they were measured with is written beside them
QString ReviewPage::write_signals(const QString& file) {
  QString problem = write_file(file, signals_csv(recording_));
  for (const record::Exported& about : exported())
    if (problem.isEmpty()) problem = write_file(file + QStringLiteral(".about.json"), record::about_json(about) + "\n");
  return problem;
}

QString ReviewPage::write_summary(const QString& file) {
  std::string text = summary_csv(review_);
  for (const record::Exported& about : exported()) text += made_with_csv(about);
  return write_file(file, text);
}

QString ReviewPage::write_report(const QString& file) {
  std::vector<record::Note> notes;
  if (from_store_ && desk_ && desk_->school()) notes = desk_->school()->notes(review_.attempt.id);
  return write_attempt_report({review_, recording_, worst_moments_, entry_track(recording_), notes, exported()}, file);
}

void ReviewPage::save(const QString& title, const QString& ending,
                      QString (ReviewPage::*write)(const QString&)) {
  const QString name = QString::fromStdString(review_.attempt.lesson_id + "_" + review_.attempt.started_utc)
                           .replace(QLatin1Char(':'), QLatin1Char('-')) +
                       ending;
  const QString file = ask_save(this, title, name, QStringLiteral("(*.%1)").arg(ending.section(QLatin1Char('.'), -1)));
  if (file.isEmpty()) return;
  const QString problem = (this->*write)(file);
  note_->setText(problem.isEmpty() ? tr("Saved to: %1").arg(file) : problem);
  note_->show();
}

// the attempt's own events, and notes added later
void ReviewPage::read_moments() {
  const record::AttemptRow row = review_.attempt;
  std::vector<record::EventRow> events = store_->events(row.id);
  record::School* school = desk_ ? desk_->school() : nullptr;
  if (school)
    for (const record::Note& n : school->notes(row.id)) events.push_back({n.step, n.time_s, "note", n.text, 0});
  std::vector<std::pair<std::string, double>> given;
  if (school && from_store_) given = desk_->given(row.id);
  review_ = make_review(row, recording_, events, player_ ? &player_->card() : nullptr, given);
}

void ReviewPage::set_desk(SchoolDesk* desk) {
  desk_ = desk;
  connect(desk_, &SchoolDesk::changed, this, [this] {
    if (!store_ || review_.attempt.id.empty() || !isVisible()) return;
    read_moments();
    timeline_->set_review(&review_, &recording_);
    timeline_->set_cursor(wanted_s_);
    fill_side();
  });
}

bool ReviewPage::add_note(const QString& text) {
  if (!desk_ || !desk_->school() || review_.attempt.id.empty() || text.trimmed().isEmpty()) return false;
  record::Note note;
  note.attempt_id = review_.attempt.id;
  note.time_s = wanted_s_;
  note.step = static_cast<uint64_t>(std::llround(wanted_s_ / review_.dt_s));
  note.text = text.trimmed().toStdString();
  return desk_->add_note(note);
}

void ReviewPage::rate(const QString& item_id, std::optional<double> points) {
  if (!desk_ || review_.attempt.id.empty() || desk_->rate(review_.attempt.id, item_id.toStdString(), points)) return;
  note_->setText(tr("▲ The rating was not kept: %1").arg(desk_->problem()));
  note_->show();
  ratings_->set_scales(QString::fromStdString(review_.attempt.id), review_.scales, true);
}

void ReviewPage::ask_note() {
  if (!note_button_->isVisible()) return;
  const QString text = QInputDialog::getText(this, tr("Note"), tr("At %L1 s:").arg(wanted_s_, 0, 'f', 2));
  if (text.trimmed().isEmpty() || add_note(text)) return;
  note_->setText(tr("▲ The note was not kept: %1").arg(desk_->problem()));
  note_->show();
}

}  // namespace swage::console
