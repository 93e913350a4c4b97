// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/attempt_chooser.hpp"

#include <QDialogButtonBox>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "console/models/attempts_model.hpp"
#include "console/models/words.hpp"
#include "console/widgets/parts.hpp"

namespace swage::console {
namespace {

/// "Ben Okoye, 28 Nov 2026 13:49: Passed, 94 points, 00:12", and that a recorded hand held the instrument.
QString entry_text(const record::AttemptRow& a) {
  QStringList words = {AttemptChooser::tr("%1, %2: %3").arg(person_text(QString::fromStdString(a.person_name)), when_text(QString::fromStdString(a.started_utc)),
                                                       verdict_text(QString::fromStdString(a.is_void ? "void" : a.outcome)))};
  if (has_score(a)) words += AttemptChooser::tr("%1 points").arg(QString::number(a.score, 'f', 0));
  words += clock_text(a.simulated_s);
  const QString hand = hand_name(a);
  if (is_hand(a)) words += hand.isEmpty() ? AttemptChooser::tr("recorded hand") : AttemptChooser::tr("recorded hand: %1").arg(hand);
  return words.join(QStringLiteral(", "));
}

}  // namespace

AttemptChooser::AttemptChooser(const std::vector<record::AttemptRow>& attempts, const std::string& but, QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("compare_dialog"));
  setWindowTitle(tr("Compare with"));
  resize(560, 480);
  auto* column = new QVBoxLayout(this);
  QLineEdit* words = make_search(tr("Search name, date and result"), QStringLiteral("compare_search"), this);
  column->addWidget(words);
  list_ = new QListWidget(this);
  list_->setObjectName(QStringLiteral("compare_list"));
  list_->setAccessibleName(tr("Attempts at the same lesson"));
  for (const record::AttemptRow& a : attempts) {
    if (a.id == but) continue;
    auto* entry = new QListWidgetItem(entry_text(a), list_);
    entry->setData(Qt::UserRole, QString::fromStdString(a.id));
  }
  list_->setCurrentRow(0);
  list_->setWordWrap(true);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* which = make_muted(tr("Attempts at this lesson, of everybody: those at another lesson have nothing to be compared."), this);
  which->setVisible(list_->count() > 0);
  column->addWidget(which);
  column->addWidget(list_, 1);
  if (list_->count() == 0) {
    words->hide();
    list_->hide();
    auto* none = make_muted(tr("There is no other attempt at this lesson in the store, of anybody."), this);
    none->setObjectName(QStringLiteral("compare_none"));
    column->addWidget(none, 1, Qt::AlignTop);
  }
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  auto* ok = buttons->addButton(tr("Compare"), QDialogButtonBox::AcceptRole);
  ok->setObjectName(QStringLiteral("compare_ok"));
  ok->setEnabled(list_->count() > 0);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(list_, &QListWidget::itemActivated, this, &QDialog::accept);
  connect(words, &QLineEdit::textChanged, this, [this](const QString& text) { search(text); });
}

QString AttemptChooser::chosen() const { return list_->currentItem() ? list_->currentItem()->data(Qt::UserRole).toString() : QString(); }

void AttemptChooser::search(const QString& text) {
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

}  // namespace swage::console
