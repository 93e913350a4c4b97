// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/order_dialog.hpp"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "console/widgets/parts.hpp"

namespace swage::console {

namespace {

constexpr int kWidth_px = 460;  // a sentence of two lines

}  // namespace

OrderDialog::OrderDialog(const QString& why, const QString& first, bool test, QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("order_dialog"));
  setWindowTitle(test ? tr("This test is not open yet") : tr("Another lesson comes first"));
  setMinimumWidth(kWidth_px);
  auto* column = new QVBoxLayout(this);
  auto* words = new QLabel(why, this);
  words->setObjectName(QStringLiteral("order_why"));
  words->setWordWrap(true);
  column->addWidget(words);
  column->addWidget(make_muted(test ? tr("Its test opens then; practice is free. An instructor may open the test for this one attempt: the attempt keeps the "
                                         "reason, and its result tells it.")
                                    : tr("Practice is free and counts for no course. The lessons build on one another, so the order helps."),
                               this));
  if (test) {
    auto* form = new QFormLayout;
    reason_ = new QComboBox(this);
    reason_->setObjectName(QStringLiteral("order_reason"));
    reason_->setAccessibleName(tr("Reason of the instructor"));
    reason_->setEditable(true);
    reason_->setCompleter(nullptr);  // a reason of one's own that begins like a given one stays as typed
    reason_->addItems({QString(), tr("Passed at another place"), tr("Assessment on a fixed day"), tr("Tried beside an instructor")});
    form->addRow(tr("Reason of the instructor"), reason_);
    column->addLayout(form);
  }
  auto* row = new QHBoxLayout;
  row->addStretch(1);
  row->addWidget(add_button(tr("Cancel"), "order_cancel", Answer::kCancel));
  QPushButton* begin = add_button(test ? tr("Open for this attempt") : tr("Practise all the same"), "order_begin", Answer::kBegin);
  row->addWidget(begin);
  if (!first.isEmpty()) {
    QPushButton* go = add_button(tr("To “%1”").arg(first), "order_first", Answer::kToTheFirst);
    go->setDefault(true);
    row->addWidget(go);
  }
  column->addLayout(row);
  if (!reason_) return;
  begin->setEnabled(false);
  connect(reason_, &QComboBox::currentTextChanged, begin, [this, begin] { begin->setEnabled(!reason().isEmpty()); });
}

QPushButton* OrderDialog::add_button(const QString& words, const char* name, Answer answer) {
  auto* button = make_button(words, {}, QString::fromLatin1(name), this);
  connect(button, &QPushButton::clicked, this, [this, answer] {
    answer_ = answer;
    answer == Answer::kCancel ? reject() : accept();
  });
  return button;
}

QString OrderDialog::reason() const { return reason_ ? reason_->currentText().simplified() : QString(); }

}  // namespace swage::console
