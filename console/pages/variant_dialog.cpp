// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/variant_dialog.hpp"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QScrollArea>
#include <QVBoxLayout>

#include "console/models/said.hpp"
#include "console/widgets/parts.hpp"

namespace swage::console {

VariantDialog::VariantDialog(const LessonEntry& lesson, const QVector<LiveParam>& params, Check check, QWidget* parent)
    : VariantDialog(lesson, params, std::move(check), {}, parent) {}

VariantDialog::VariantDialog(const LessonEntry& lesson, const QVector<LiveParam>& params, Check check,
                             const QString& folder, QWidget* parent)
    : QDialog(parent), lesson_(lesson), folder_(folder), check_(std::move(check)) {
  setObjectName(QStringLiteral("variant"));
  setWindowTitle(folder.isEmpty() ? tr("Edit lesson") : tr("New lesson"));
  auto* column = new QVBoxLayout(this);
  column->addWidget(make_words(lesson));
  column->addWidget(make_values(params), 1);
  column->addWidget(make_buttons());
  resize(560, 760);
  update_state();
  title_->setFocus();
  title_->selectAll();
}

QWidget* VariantDialog::make_words(const LessonEntry& base) {
  const bool edits = folder_.isEmpty();
  Card card = make_card(edits ? tr("Lesson of your own") : tr("Based on %1").arg(said(base.title)), this);
  auto* form = new QFormLayout;
  title_ = new QLineEdit(edits ? base.title : tr("%1, adapted").arg(said(base.title)), card.frame);
  title_->setObjectName(QStringLiteral("variant_title"));
  summary_ = new QLineEdit(edits ? base.summary : said(base.summary), card.frame);
  summary_->setObjectName(QStringLiteral("variant_summary"));
  summary_->setCursorPosition(0);
  goal_ = new QPlainTextEdit(edits ? base.goal : said(base.goal), card.frame);
  goal_->setObjectName(QStringLiteral("variant_goal"));
  goal_->setTabChangesFocus(true);
  goal_->setFixedHeight(64);
  form->addRow(tr("&Title"), title_);
  form->addRow(tr("Tas&k"), summary_);
  form->addRow(tr("&Learning goal"), goal_);
  card.body->addLayout(form);
  for (const QLineEdit* line : {title_, summary_})
    connect(line, &QLineEdit::textChanged, this, &VariantDialog::update_state);
  connect(goal_, &QPlainTextEdit::textChanged, this, &VariantDialog::update_state);
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
  none_ = make_muted({}, card.frame);
  none_->setObjectName(QStringLiteral("variant_none"));
  none_->hide();
  card.body->addWidget(none_);
  card.body->addWidget(scroll, 1);
  connect(find_, &QLineEdit::textChanged, this, [this](const QString& text) {
    const bool any = form_->find(text);
    none_->setText(tr("No value is called \"%1\".").arg(text));
    none_->setVisible(!any && !text.isEmpty());
  });
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

void VariantDialog::preset(const QVector<LiveForm::Change>& values) {
  preset_ = form_->preset(values);
  update_state();
}

void VariantDialog::update_state() {
  if (!save_) return;
  const auto changes = form_->changes().size();
  const bool edits = folder_.isEmpty(), named = !title_->text().trimmed().isEmpty();
  const bool words = edits && (title_->text() != lesson_.title || summary_->text() != lesson_.summary ||
                               goal_->toPlainText() != lesson_.goal);
  save_->setEnabled((changes > 0 || words) && named);  // a copy that changes nothing is no lesson
  QString text = !named         ? tr("A lesson has a title.")
                 : changes == 1 ? tr("One value is changed.")
                 : changes > 1  ? tr("%1 values are changed.").arg(changes)
                 : words        ? tr("The words are changed.")
                                : tr("No value is changed yet.");
  if (preset_ > 0 && named) text += QLatin1Char(' ') + tr("The last attempt's are kept.");
  problem_->setText(text);
}

QString VariantDialog::write(const QVector<std::pair<std::string, std::string>>& set) {
  const Variant variant{lesson_.path, title_->text(), summary_->text(), goal_->toPlainText(), set};
  if (folder_.isEmpty()) {
    saved_ = lesson_.path;
    return update_variant(lesson_.path, variant);
  }
  const Saved saved = save_variant(variant, folder_);
  saved_ = saved.path;
  return saved.problem;
}

void VariantDialog::save() {
  const auto set = form_->changes();
  QString problem = check_(set);
  if (problem.isEmpty()) problem = write(set);
  if (problem.isEmpty()) return accept();
  problem_->setText(problem);
}

}  // namespace swage::console
