// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/variant_dialog.hpp"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QScrollArea>
#include <QVBoxLayout>

#include "console/widgets/parts.hpp"

namespace swage::console {

VariantDialog::VariantDialog(const LessonEntry& base, const QVector<LiveParam>& params, Check check,
                             const QString& folder, QWidget* parent)
    : QDialog(parent), base_(base.path), folder_(folder), check_(std::move(check)) {
  setObjectName(QStringLiteral("variant"));
  setWindowTitle(tr("New lesson"));
  auto* column = new QVBoxLayout(this);
  column->addWidget(make_words(base));
  column->addWidget(make_values(params), 1);
  column->addWidget(make_buttons());
  resize(560, 760);
  update_state();
  title_->setFocus();
  title_->selectAll();
}

QWidget* VariantDialog::make_words(const LessonEntry& base) {
  Card card = make_card(tr("Based on %1").arg(base.title), this);
  auto* form = new QFormLayout;
  title_ = new QLineEdit(tr("%1, adapted").arg(base.title), card.frame);
  title_->setObjectName(QStringLiteral("variant_title"));
  summary_ = new QLineEdit(base.summary, card.frame);
  summary_->setObjectName(QStringLiteral("variant_summary"));
  summary_->setCursorPosition(0);
  goal_ = new QPlainTextEdit(base.goal, card.frame);
  goal_->setObjectName(QStringLiteral("variant_goal"));
  goal_->setTabChangesFocus(true);
  goal_->setFixedHeight(64);
  form->addRow(tr("&Title"), title_);
  form->addRow(tr("Tas&k"), summary_);
  form->addRow(tr("&Learning goal"), goal_);
  card.body->addLayout(form);
  connect(title_, &QLineEdit::textChanged, this, &VariantDialog::update_state);
  return card.frame;
}

QWidget* VariantDialog::make_values(const QVector<LiveParam>& params) {
  Card card = make_card(tr("Values"), this);
  find_ = new QLineEdit(card.frame);
  find_->setObjectName(QStringLiteral("variant_find"));
  find_->setPlaceholderText(tr("Find: needle, stiffness, force …"));
  find_->setAccessibleName(tr("Find a value"));
  find_->setClearButtonEnabled(true);
  card.body->addWidget(find_);
  auto* scroll = new QScrollArea(card.frame);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  form_ = new LiveForm(scroll, LiveForm::Of::kVariant);
  form_->set_params(params);
  form_->set_running(true);
  scroll->setWidget(form_);
  scroll->viewport()->setAutoFillBackground(false);
  form_->setAutoFillBackground(false);
  card.body->addWidget(scroll, 1);
  connect(find_, &QLineEdit::textChanged, form_, &LiveForm::find);
  connect(form_, &LiveForm::changed, this, &VariantDialog::update_state);
  return card.frame;
}

QWidget* VariantDialog::make_buttons() {
  auto* bar = new QWidget(this);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  problem_ = new QLabel(bar);
  problem_->setObjectName(QStringLiteral("variant_problem"));
  problem_->setWordWrap(true);
  auto* cancel = make_button(tr("Cancel"), QStringLiteral("Esc"), QStringLiteral("variant_cancel"), bar);
  save_ = make_button(tr("Save"), QStringLiteral("Ctrl+S"), QStringLiteral("variant_save"), bar);
  save_->setProperty("primary", true);
  save_->setDefault(true);
  save_->setShortcut(QKeySequence::Save);
  row->addWidget(problem_, 1);
  row->addWidget(cancel);
  row->addWidget(save_);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(save_, &QPushButton::clicked, this, &VariantDialog::save);
  return bar;
}

void VariantDialog::update_state() {
  if (!save_) return;
  const auto changes = form_->changes().size();
  save_->setEnabled(changes > 0 && !title_->text().trimmed().isEmpty());  // a copy that changes nothing is no lesson
  problem_->setText(title_->text().trimmed().isEmpty() ? tr("A lesson has a title.")
                    : changes == 0                     ? tr("No value is changed yet.")
                    : changes == 1                     ? tr("One value is changed.")
                                                       : tr("%1 values are changed.").arg(changes));
}

void VariantDialog::save() {
  const auto set = form_->changes();
  QString problem = check_(set);
  if (problem.isEmpty()) {
    const Saved saved =
        save_variant({base_, title_->text(), summary_->text(), goal_->toPlainText(), set}, folder_);
    problem = saved.problem;
    saved_ = saved.path;
  }
  if (problem.isEmpty()) return accept();
  problem_->setText(problem);
}

}  // namespace swage::console
