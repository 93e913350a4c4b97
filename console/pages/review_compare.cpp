// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Functions of the Review page beyond playback: worst moments, and comparison with another attempt.
#include <QDialog>
#include <QDialogButtonBox>
#include <QListWidget>
#include <QVBoxLayout>

#include "console/models/attempts_model.hpp"
#include "console/models/words.hpp"
#include "console/pages/comparison.hpp"
#include "console/pages/review_page.hpp"
#include "console/widgets/parts.hpp"

namespace swage::console {
namespace {

/// "Ben Okoye, 28 Nov 2026 13:49: Passed, 94 points, 00:12", and that a recorded hand held the instrument.
QString entry_text(const record::AttemptRow& a) {
  QStringList words = {ReviewPage::tr("%1, %2: %3").arg(person_text(QString::fromStdString(a.person_name)), when_text(QString::fromStdString(a.started_utc)),
                                                       verdict_text(QString::fromStdString(a.is_void ? "void" : a.outcome)))};
  if (has_score(a)) words += ReviewPage::tr("%1 points").arg(QString::number(a.score, 'f', 0));
  words += clock_text(a.simulated_s);
  if (is_hand(a)) words += ReviewPage::tr("recorded hand");
  return words.join(QStringLiteral(", "));
}

/// Attempts of one lesson, with a search, to choose one for comparison.
class AttemptChooser : public QDialog {
 public:
  AttemptChooser(const std::vector<record::AttemptRow>& attempts, const std::string& but, QWidget* parent) : QDialog(parent) {
    setObjectName(QStringLiteral("compare_dialog"));
    setWindowTitle(ReviewPage::tr("Compare with"));
    resize(560, 480);
    auto* column = new QVBoxLayout(this);
    QLineEdit* words = make_search(ReviewPage::tr("Search name, date and result"), QStringLiteral("compare_search"), this);
    column->addWidget(words);
    list_ = new QListWidget(this);
    list_->setObjectName(QStringLiteral("compare_list"));
    list_->setAccessibleName(ReviewPage::tr("Attempts at the same lesson"));
    for (const record::AttemptRow& a : attempts) {
      if (a.id == but) continue;
      auto* entry = new QListWidgetItem(
          entry_text(a), list_);
      entry->setData(Qt::UserRole, QString::fromStdString(a.id));
    }
    list_->setCurrentRow(0);
    column->addWidget(list_, 1);
    if (list_->count() == 0) {
      words->hide();
      list_->hide();
      auto* none = make_muted(ReviewPage::tr("There is no other attempt at this lesson in the store, of anybody."), this);
      none->setObjectName(QStringLiteral("compare_none"));
      column->addWidget(none, 1, Qt::AlignTop);
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    auto* ok = buttons->addButton(ReviewPage::tr("Compare"), QDialogButtonBox::AcceptRole);
    ok->setObjectName(QStringLiteral("compare_ok"));
    ok->setEnabled(list_->count() > 0);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(list_, &QListWidget::itemActivated, this, &QDialog::accept);
    connect(words, &QLineEdit::textChanged, this, [this](const QString& text) { search(text); });
  }
  QString chosen() const { return list_->currentItem() ? list_->currentItem()->data(Qt::UserRole).toString() : QString(); }

 private:
  void search(const QString& text) {
    const QStringList words = text.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    QListWidgetItem* first = nullptr;
    for (int i = 0; i < list_->count(); ++i) {
      QListWidgetItem* entry = list_->item(i);
      const bool fits = std::all_of(words.begin(), words.end(),
                                    [&](const QString& w) { return entry->text().contains(w, Qt::CaseInsensitive); });
      entry->setHidden(!fits);
      if (fits && !first) first = entry;
    }
    list_->setCurrentItem(first);
  }
  QListWidget* list_;
};

}  // namespace

void ReviewPage::fill_worst() {
  const std::string lesson = review_.attempt.lesson_id;
  worst_moments_ = worst_moments(review_, recording_, [&](const std::string& metric) {
    return finder_ ? finder_(QString::fromStdString(lesson), metric).target : MetricTarget{};
  });
  worst_->setRowCount(static_cast<int>(worst_moments_.size()));
  for (int i = 0; i < worst_moments_.size(); ++i) {
    const WorstMoment& m = worst_moments_[i];
    const QString cells[] = {tr("%L1 s").arg(m.time_s, 0, 'f', 2), (m.weight >= kOverLimit ? QStringLiteral("▲ ") : QString()) + m.what};
    for (int c = 0; c < 2; ++c) {
      auto* cell = new QTableWidgetItem(cells[c]);
      cell->setToolTip(m.tip.isEmpty() ? cells[c] : m.tip);
      worst_->setItem(i, c, cell);
    }
  }
  tabs_->setTabVisible(tabs_->indexOf(worst_), !worst_moments_.isEmpty());
}

void ReviewPage::to_worst(int row) {
  if (row < 0 || row >= worst_moments_.size()) return;
  worst_->setCurrentCell(row, 0);
  go(worst_moments_[row].time_s);
}

void ReviewPage::to_next_worst() {
  if (worst_moments_.isEmpty()) return;
  tabs_->setCurrentWidget(worst_);
  to_worst(worst_->currentRow() < 0 || !worst_shown_ ? 0 : (worst_->currentRow() + 1) % static_cast<int>(worst_moments_.size()));
  worst_shown_ = true;
}

// for a debriefing: plays the worst moment in a loop
void ReviewPage::loop_worst(int row) {
  to_worst(row);
  loop_->setChecked(false);
  loop_->setChecked(true);
  if (!playing_) toggle_play();
}

void ReviewPage::ask_compare() {
  if (!from_store_ || !store_ || review_.attempt.id.empty()) return;
  AttemptChooser dialog(store_->attempts("", review_.attempt.lesson_id), review_.attempt.id, this);
  if (dialog.exec() == QDialog::Accepted && !dialog.chosen().isEmpty()) compare(dialog.chosen());
}

bool ReviewPage::compare(const QString& attempt_id) {
  record::AttemptRow row;
  record::Recording recording;
  std::string error;
  if (!store_ || review_.attempt.id.empty()) return false;
  const std::string id = attempt_id.toStdString();
  if (!store_->attempt(id, row) || !reader_ || !reader_(id, recording, error)) {
    note_->setText(tr("▲ The other attempt cannot be read: %1").arg(QString::fromStdString(error.empty() ? store_->trouble() : error)));
    note_->show();
    return false;
  }
  if (!other_) {
    other_ = new Comparison(this);
    other_->set_themes(ui_, cues_);
    pictures_->addWidget(other_, 1);
    connect(other_, &Comparison::aligned, this, &ReviewPage::show_comparison);
    connect(other_, &Comparison::ghost_changed, this, &ReviewPage::set_ghost);
    connect(other_, &Comparison::closed, this, &ReviewPage::end_comparison);
  }
  other_->set_attempt(review_, row, std::move(recording), store_->events(id), opener_);
  other_->show();
  timeline_->setFocus();
  show_comparison();
  fill_metrics();
  return true;
}

void ReviewPage::show_comparison() {
  if (!comparing()) return;
  timeline_->set_other(&other_->review(), &other_->recording(), other_->later_s());
  set_ghost();
  go(wanted_s_);
}

// Shows the other attempt's instruments in this one's picture, on the shifted clock.
void ReviewPage::set_ghost() {
  const bool wanted = player_ && comparing() && other_->ghost_wanted();
  view_->set_ghost(wanted ? &other_->player()->card() : nullptr, wanted ? other_->person() : QString());
  move_ghost();
}

void ReviewPage::move_ghost() {
  if (comparing() && other_->ghost_wanted()) view_->show_ghost(other_->X_WB());
}

void ReviewPage::end_comparison() {
  timeline_->set_other(nullptr, nullptr, 0);
  if (!comparing()) return;
  other_->hide();
  set_ghost();
  fill_metrics();
  timeline_->setFocus();
}

bool ReviewPage::comparing() const { return other_ && !other_->isHidden(); }

}  // namespace swage::console
