// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/rule_panel.hpp"

#include "console/models/course_words.hpp"
#include "console/widgets/parts.hpp"

namespace swage::console {
namespace {

using Rule = judge::PassRule;

constexpr int kSimulate_ms = 200;  // after the last change, as each simulation takes a tenth of a second
constexpr int kCount = 10, kRate = 60;  // first fields of numbers and of rates: successive edits of one are undone together

}  // namespace

RulePanel::RulePanel(CourseEditing* editing, QWidget* parent) : QWidget(parent), editing_(editing) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  Card card = make_card(tr("Pass rule"), this);
  row_ = new QBoxLayout(QBoxLayout::LeftToRight);
  form_ = new QFormLayout;
  kind_ = new QComboBox;
  kind_->setObjectName(QStringLiteral("rule_kind"));
  kind_->setAccessibleName(tr("Kind of rule"));
  kind_->addItems({tr("in a row"), tr("learning-curve test (strict)")});
  connect(kind_, &QComboBox::activated, this, [this](int i) {
    editing_->edit_step(tr("Rule"), [&](record::CourseStep& s) { s.rule.kind = i == 0 ? Rule::Kind::kStreak : Rule::Kind::kLcCusum; });
  });
  form_->addRow(tr("Rule"), kind_);
  add_numbers();
  row_->addLayout(form_, 2);
  row_->addSpacing(16);
  row_->addLayout(make_says(card.frame), 3);
  card.body->addLayout(row_);
  column->addWidget(card.frame);
  simulate_timer_.setSingleShot(true);
  simulate_timer_.setInterval(kSimulate_ms);
  connect(&simulate_timer_, &QTimer::timeout, this, &RulePanel::simulate);
}

void RulePanel::add_numbers() {
  add_count(tr("Test attempts in a row"), "rule_in_a_row", 20, &Rule::in_a_row, tr("Test attempts in a row that meet everything that is asked"));
  add_count(tr("then, first of a later day"), "rule_later_day", 20, &Rule::later_day, tr("First attempts of a later day that must meet it, too; 0: none"));
  add_rate(tr("Failure rate, competent"), "rule_adequate", 0.99, &Rule::adequate, tr("Share of attempts that a competent person fails"));
  add_rate(tr("Failure rate, not yet"), "rule_inadequate", 0.99, &Rule::inadequate, tr("Share of attempts that a person fails who is not competent yet"));
  add_rate(tr("Signal at"), "rule_signal", 10, &Rule::signal, tr("Lower passes the unready, higher takes longer; 2.4 is usual"));
  add_count(tr("Attempts a day that count"), "rule_a_day", 100, &Rule::a_day, tr("0: all"));
  add_count(tr("Warm-up attempts a day"), "rule_warm_up", 20, &Rule::warm_up, tr("That do not count"));
}

void RulePanel::add_count(const QString& label, const char* name, int most, uint32_t Rule::*field, const QString& tip) {
  auto* box = new QSpinBox;
  box->setObjectName(QString::fromLatin1(name));
  box->setAccessibleName(label);
  box->setToolTip(tip);
  box->setRange(0, most);
  box->setFocusPolicy(Qt::StrongFocus);
  form_->addRow(label, box);
  counts_ += {box, field};
  const int id = kCount + static_cast<int>(counts_.size());
  connect(box, &QSpinBox::valueChanged, this, [this, field, id](int v) {
    editing_->edit_step(tr("Rule"), [&](record::CourseStep& s) { s.rule.*field = static_cast<uint32_t>(v); }, id);
  });
}

void RulePanel::add_rate(const QString& label, const char* name, double most, double Rule::*field, const QString& tip) {
  auto* box = new QDoubleSpinBox;
  box->setObjectName(QString::fromLatin1(name));
  box->setAccessibleName(label);
  box->setToolTip(tip);
  box->setRange(0, most);
  box->setDecimals(2);
  box->setSingleStep(most > 1 ? 0.1 : 0.01);
  box->setFocusPolicy(Qt::StrongFocus);
  form_->addRow(label, box);
  rates_ += {box, field};
  const int id = kRate + static_cast<int>(rates_.size());
  connect(box, &QDoubleSpinBox::valueChanged, this, [this, field, id](double v) {
    editing_->edit_step(tr("Rule"), [&](record::CourseStep& s) { s.rule.*field = v; }, id);
  });
}

QLayout* RulePanel::make_says(QWidget* parent) {
  auto* column = new QVBoxLayout;
  says_ = new QLabel(parent);
  says_->setObjectName(QStringLiteral("rule_says"));
  says_->setWordWrap(true);
  column->addWidget(says_);
  column->addSpacing(6);
  QLabel* does = make_heading(tr("What this rule does in 30 attempts"), parent);
  does->setWordWrap(true);
  column->addWidget(does);
  odds_ = new QLabel(parent);
  odds_->setObjectName(QStringLiteral("rule_odds"));
  odds_->setWordWrap(true);
  odds_->setTextFormat(Qt::PlainText);
  column->addWidget(odds_);
  column->addStretch(1);
  return column;
}

void RulePanel::set_narrow(bool narrow) { row_->setDirection(narrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight); }

void RulePanel::refresh() {
  const record::CourseStep* s = editing_->step();
  if (!s) return;
  const auto quiet = editing_->quiet();
  const bool streak = s->rule.kind == Rule::Kind::kStreak;
  kind_->setCurrentIndex(streak ? 0 : 1);
  for (const auto& [box, field] : counts_) {
    box->setValue(static_cast<int>(s->rule.*field));
    const bool of_streak = field == &Rule::in_a_row || field == &Rule::later_day;
    box->setVisible(!of_streak || streak);
    form_->labelForField(box)->setVisible(!of_streak || streak);
  }
  for (const auto& [box, field] : rates_) {
    box->setValue(s->rule.*field);
    box->setVisible(!streak);
    form_->labelForField(box)->setVisible(!streak);
  }
  says_->setText(rule_words(s->rule));
  simulate_timer_.start();
}

void RulePanel::simulate() {
  const record::CourseStep* s = editing_->step();
  if (!s) return;
  const QStringList odds = rule_odds(s->rule);
  odds_->setText(odds.isEmpty() ? QString() : QStringLiteral("• ") + odds.join(QStringLiteral("\n• ")));
}

}  // namespace swage::console
