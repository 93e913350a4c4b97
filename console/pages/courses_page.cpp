// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/courses_page.hpp"

#include <QAbstractItemDelegate>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QSplitter>
#include <QVBoxLayout>

#include "console/widgets/parts.hpp"

namespace swage::console {
namespace {

constexpr int kSimulate_ms = 200;  // after the last change, as each simulation takes a tenth of a second
constexpr int kNarrow_px = 1150;
constexpr int kLeastRule_px = 300;  // of the rule, beside the lists on a narrow screen

/// Fields of a course; successive edits of one are undone together.
enum Field { kTitle = 1, kRule = 10, kLimit = 100 };

QListWidget* make_list(const char* name, const QString& accessible, QWidget* parent) {
  auto* list = new QListWidget(parent);
  list->setObjectName(QString::fromLatin1(name));
  list->setAccessibleName(accessible);
  list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list->setTextElideMode(Qt::ElideRight);
  return list;
}

}  // namespace

CoursesPage::CoursesPage(SchoolDesk* desk, StoreLink* link, LessonsModel* lessons, LessonMetrics metrics, QWidget* parent)
    : QWidget(parent), desk_(desk), link_(link), lessons_(lessons), metrics_(std::move(metrics)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 10, 12, 6);
  problem_ = make_muted({}, this);
  problem_->setObjectName(QStringLiteral("course_problem"));
  problem_->hide();
  column->addWidget(problem_);
  stack_ = new QStackedWidget(this);
  auto* splitter = new QSplitter(stack_);
  splitter->setObjectName(QStringLiteral("courses_splitter"));
  splitter->setChildrenCollapsible(false);
  splitter->addWidget(make_courses());
  splitter->addWidget(make_steps());
  splitter->addWidget(make_step());
  splitter->setStretchFactor(0, 2);
  splitter->setStretchFactor(1, 3);
  splitter->setStretchFactor(2, 5);
  splitter->setSizes({150, 300, 850});  // fixed, as the widgets' size hints change with the course
  step_stack_->setMinimumWidth(kLeastRule_px);
  stack_->addWidget(splitter);
  stack_->addWidget(make_empty());
  column->addWidget(stack_, 1);
  simulate_timer_.setSingleShot(true);
  simulate_timer_.setInterval(kSimulate_ms);
  connect(&simulate_timer_, &QTimer::timeout, this, &CoursesPage::simulate);
  connect(desk_, &SchoolDesk::changed, this, [this] {
    if (isVisible()) refresh();
  });
  connect(desk_, &SchoolDesk::failed, this, [this](const QString& why) {
    if (isVisible()) show_problem(why);  // a failure on another page is shown there
  });
}

void CoursesPage::show_problem(const QString& why) {
  problem_->setText(tr("▲ %1").arg(why));
  problem_->show();
}

// on a narrow screen what the rule says stands below its numbers, as beside them it would be a strip of a few letters
void CoursesPage::resizeEvent(QResizeEvent*) {
  rule_row_->setDirection(width() < kNarrow_px ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

void CoursesPage::hideEvent(QHideEvent*) { problem_->hide(); }

QWidget* CoursesPage::make_courses() {
  Card card = make_card(tr("Courses"), this);
  list_ = make_list("courses", tr("Courses"), card.frame);
  card.body->addWidget(list_, 1);
  connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
    if (!filling_) choose_course(row);
  });
  auto* add = make_button(tr("New course"), QStringLiteral("Ctrl+N"), QStringLiteral("new_course"), card.frame);
  add->setShortcut(QKeySequence(QStringLiteral("Ctrl+N")));
  connect(add, &QPushButton::clicked, this, [this] {
    record::Course fresh;
    fresh.title = tr("Course %1").arg(courses_.size() + 1).toStdString();
    course_ = {};
    if (!desk_->change_course({}, fresh, tr("New course"))) return;
    title_->setFocus();
    title_->selectAll();
  });
  auto* remove = make_button(tr("Remove"), {}, QStringLiteral("remove_course"), card.frame);
  remove->setToolTip(tr("Remove the course; Ctrl+Z brings it back"));
  give_key(remove, QStringLiteral("Ctrl+Shift+D"));
  connect(remove, &QPushButton::clicked, this, [this] {
    if (!course_.id.empty()) desk_->change_course(course_, {}, tr("Remove course"));
  });
  card.body->addWidget(add);
  card.body->addWidget(remove);
  return card.frame;
}

QWidget* CoursesPage::make_steps() {
  Card card = make_card({}, this);
  title_ = new QLineEdit(card.frame);
  title_->setObjectName(QStringLiteral("course_title"));
  title_->setAccessibleName(tr("Title of the course"));
  connect(title_, &QLineEdit::textEdited, this, [this](const QString& text) {
    edit(tr("Title"), [&](record::Course& c) { c.title = text.toStdString(); }, kTitle);
  });
  card.body->addWidget(title_);
  in_order_ = new QCheckBox(tr("One after the other"), card.frame);
  in_order_->setObjectName(QStringLiteral("in_order"));
  in_order_->setToolTip(tr("A lesson opens when the one before it is passed"));
  connect(in_order_, &QCheckBox::clicked, this, [this](bool on) { edit(tr("Order"), [&](record::Course& c) { c.in_order = on; }); });
  card.body->addWidget(in_order_);
  steps_ = make_list("steps", tr("Lessons of the course"), card.frame);
  card.body->addWidget(steps_, 1);
  connect(steps_, &QListWidget::currentRowChanged, this, [this] {
    if (!filling_) show_step();
  });
  lesson_ = new QComboBox(card.frame);
  lesson_->setObjectName(QStringLiteral("add_lesson_choice"));
  lesson_->setAccessibleName(tr("Lesson to add"));
  lesson_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  lesson_->setMinimumContentsLength(16);
  card.body->addWidget(lesson_);
  auto* row = new QHBoxLayout;
  const auto add = [&](const QString& text, const char* key, const char* name, const QString& tip, auto call) {
    auto* button = make_button(text, {}, QString::fromLatin1(name), card.frame);
    button->setAccessibleName(tip);
    button->setToolTip(tip);
    give_key(button, QString::fromLatin1(key));
    connect(button, &QPushButton::clicked, this, call);
    row->addWidget(button);
  };
  add(tr("Add"), "Ctrl+L", "add_lesson", tr("Add the lesson behind the chosen one"), [this] { add_lesson(); });
  add(QStringLiteral("↑"), "Ctrl+Up", "step_up", tr("Earlier"), [this] { move_step(-1); });
  add(QStringLiteral("↓"), "Ctrl+Down", "step_down", tr("Later"), [this] { move_step(+1); });
  add(tr("Remove"), "Ctrl+D", "remove_step", tr("Take the lesson out of the course"), [this] {
    const auto at = steps_->currentRow();
    if (at >= 0) edit(tr("Remove a lesson"), [&](record::Course& c) { c.steps.erase(c.steps.begin() + at); });
  });
  card.body->addLayout(row);
  return card.frame;
}

QWidget* CoursesPage::make_step() {
  step_stack_ = new QStackedWidget(this);
  QScrollArea* scroll = make_scroll(step_stack_);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);  // for a screen of 960 px
  auto* box = new QWidget(scroll);
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  step_title_ = new QLabel(box);
  step_title_->setProperty("big", true);
  step_title_->setWordWrap(true);
  column->addWidget(step_title_);
  step_fault_ = new QLabel(box);
  step_fault_->setObjectName(QStringLiteral("step_fault"));
  step_fault_->setWordWrap(true);
  step_fault_->hide();
  column->addWidget(step_fault_);
  open_ = new QCheckBox(tr("Open at any time, whatever the order"), box);
  open_->setObjectName(QStringLiteral("step_open"));
  connect(open_, &QCheckBox::clicked, this, [this](bool on) { edit_step(tr("Open"), [&](record::CourseStep& s) { s.is_open = on; }); });
  column->addWidget(open_);
  column->addWidget(make_rule());
  column->addWidget(make_limits(), 1);
  scroll->setWidget(box);
  step_stack_->addWidget(scroll);
  QLabel* none = make_muted(tr("Add a lesson to say when it is passed."), step_stack_);
  none->setAlignment(Qt::AlignCenter);
  step_stack_->addWidget(none);
  return step_stack_;
}

QSpinBox* CoursesPage::add_count(QFormLayout* form, const QString& label, const char* name, int most, uint32_t judge::PassRule::*field,
                                 const QString& tip) {
  auto* box = new QSpinBox;
  box->setObjectName(QString::fromLatin1(name));
  box->setAccessibleName(label);
  box->setToolTip(tip);
  box->setRange(0, most);
  box->setFocusPolicy(Qt::StrongFocus);
  form->addRow(label, box);
  counts_ += {box, field};
  const int id = kRule + static_cast<int>(counts_.size());
  connect(box, &QSpinBox::valueChanged, this, [this, field, id](int v) {
    edit_step(tr("Rule"), [&](record::CourseStep& s) { s.rule.*field = static_cast<uint32_t>(v); }, id);
  });
  return box;
}

QDoubleSpinBox* CoursesPage::add_rate(QFormLayout* form, const QString& label, const char* name, double most,
                                      double judge::PassRule::*field, const QString& tip) {
  auto* box = new QDoubleSpinBox;
  box->setObjectName(QString::fromLatin1(name));
  box->setAccessibleName(label);
  box->setToolTip(tip);
  box->setRange(0, most);
  box->setDecimals(2);
  box->setSingleStep(most > 1 ? 0.1 : 0.01);
  box->setFocusPolicy(Qt::StrongFocus);
  form->addRow(label, box);
  rates_ += {box, field};
  const int id = kRule + 50 + static_cast<int>(rates_.size());
  connect(box, &QDoubleSpinBox::valueChanged, this, [this, field, id](double v) {
    edit_step(tr("Rule"), [&](record::CourseStep& s) { s.rule.*field = v; }, id);
  });
  return box;
}

QWidget* CoursesPage::make_rule() {
  using Rule = judge::PassRule;
  Card card = make_card(tr("Pass rule"), this);
  auto* row = rule_row_ = new QBoxLayout(QBoxLayout::LeftToRight);
  auto* form = rule_form_ = new QFormLayout;
  kind_ = new QComboBox;
  kind_->setObjectName(QStringLiteral("rule_kind"));
  kind_->setAccessibleName(tr("Kind of rule"));
  kind_->addItems({tr("in a row"), tr("learning-curve test (strict)")});
  connect(kind_, &QComboBox::activated, this, [this](int i) {
    edit_step(tr("Rule"), [&](record::CourseStep& s) { s.rule.kind = i == 0 ? Rule::Kind::kStreak : Rule::Kind::kLcCusum; });
  });
  form->addRow(tr("Rule"), kind_);
  add_count(form, tr("Test attempts in a row"), "rule_in_a_row", 20, &Rule::in_a_row, tr("Test attempts in a row that meet everything that is asked"));
  add_count(form, tr("then, first of a later day"), "rule_later_day", 20, &Rule::later_day, tr("First attempts of a later day that must meet it, too; 0: none"));
  add_rate(form, tr("Failure rate, competent"), "rule_adequate", 0.99, &Rule::adequate, tr("Share of attempts that a competent person fails"));
  add_rate(form, tr("Failure rate, not yet"), "rule_inadequate", 0.99, &Rule::inadequate, tr("Share of attempts that a person fails who is not competent yet"));
  add_rate(form, tr("Signal at"), "rule_signal", 10, &Rule::signal, tr("Lower passes the unready, higher takes longer; 2.4 is usual"));
  add_count(form, tr("Attempts a day that count"), "rule_a_day", 100, &Rule::a_day, tr("0: all"));
  add_count(form, tr("Warm-up attempts a day"), "rule_warm_up", 20, &Rule::warm_up, tr("That do not count"));
  row->addLayout(form, 2);
  auto* says = new QVBoxLayout;
  rule_says_ = new QLabel(card.frame);
  rule_says_->setObjectName(QStringLiteral("rule_says"));
  rule_says_->setWordWrap(true);
  says->addWidget(rule_says_);
  says->addSpacing(6);
  QLabel* does = make_heading(tr("What this rule does in 30 attempts"), card.frame);
  does->setWordWrap(true);
  says->addWidget(does);
  odds_ = new QLabel(card.frame);
  odds_->setObjectName(QStringLiteral("rule_odds"));
  odds_->setWordWrap(true);
  odds_->setTextFormat(Qt::PlainText);
  says->addWidget(odds_);
  says->addStretch(1);
  row->addSpacing(16);
  row->addLayout(says, 3);
  card.body->addLayout(row);
  return card.frame;
}

QWidget* CoursesPage::make_limits() {
  Card card = make_card(tr("Limits, besides the lesson's own verdict"), this);
  limits_ = new QTableWidget(0, 5, card.frame);
  limits_->setObjectName(QStringLiteral("limits"));
  limits_->setAccessibleName(tr("Limits"));
  limits_->setHorizontalHeaderLabels({tr("Metric"), tr("At least"), tr("At most"), tr("Safety"), tr("Source")});
  limits_->verticalHeader()->hide();
  limits_->setShowGrid(false);
  limits_->setSelectionBehavior(QAbstractItemView::SelectRows);
  limits_->setTabKeyNavigation(false);
  limits_->setMinimumHeight(130);
  limits_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  limits_->horizontalHeader()->setHighlightSections(false);
  limits_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  limits_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  limits_->setToolTip(tr("F2 or a double click changes a value; empty asks for nothing"));
  connect(limits_, &QTableWidget::cellChanged, this, &CoursesPage::limit_edited);
  // queued, as the table still uses the row while its editor closes
  connect(limits_->itemDelegate(), &QAbstractItemDelegate::closeEditor, this, &CoursesPage::drop_wanted, Qt::QueuedConnection);
  card.body->addWidget(limits_, 1);
  together_ = make_muted({}, card.frame);
  together_->setObjectName(QStringLiteral("together"));
  card.body->addWidget(together_);
  auto* row = new QHBoxLayout;
  metric_ = new QComboBox(card.frame);
  metric_->setObjectName(QStringLiteral("limit_metric"));
  metric_->setAccessibleName(tr("Metric to limit"));
  metric_->setPlaceholderText(tr("The metrics of this lesson are not known here"));
  row->addWidget(metric_, 1);
  auto* add = make_button(tr("Add limit"), {}, QStringLiteral("add_limit"), card.frame);
  give_key(add, QStringLiteral("Ctrl+M"));
  connect(add, &QPushButton::clicked, this, &CoursesPage::add_limit);
  row->addWidget(add);
  auto* remove = make_button(tr("Remove limit"), {}, QStringLiteral("remove_limit"), card.frame);
  give_key(remove, QStringLiteral("Ctrl+Shift+M"));
  connect(remove, &QPushButton::clicked, this, [this] {
    const auto at = limits_->currentRow();
    if (step() && static_cast<size_t>(std::max(at, 0)) >= step()->limits.size()) return drop_wanted();
    if (at >= 0) edit_step(tr("Remove a limit"), [&](record::CourseStep& s) { s.limits.erase(s.limits.begin() + at); });
  });
  row->addWidget(remove);
  auto* from = make_button(tr("From experts"), {}, QStringLiteral("suggest_limits"), card.frame);
  from->setToolTip(tr("Each limit such that all but the worst tenth of the experts' attempts keep it"));
  give_key(from, QStringLiteral("Ctrl+E"));
  connect(from, &QPushButton::clicked, this, &CoursesPage::suggest);
  row->addWidget(from);
  card.body->addLayout(row);
  return card.frame;
}

QWidget* CoursesPage::make_empty() {
  auto* box = new QWidget(this);
  auto* column = new QVBoxLayout(box);
  empty_ = new QLabel(box);
  empty_->setObjectName(QStringLiteral("no_courses"));
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  auto* go = make_button(tr("New course"), QStringLiteral("Ctrl+N"), QStringLiteral("first_course"), box);
  go->setShortcut(QKeySequence(QStringLiteral("Ctrl+N")));
  connect(go, &QPushButton::clicked, this, [this] { findChild<QPushButton*>(QStringLiteral("new_course"))->click(); });
  column->addStretch(2);
  column->addWidget(empty_);
  column->addSpacing(10);
  column->addWidget(go, 0, Qt::AlignHCenter);
  column->addStretch(3);
  return box;
}

}  // namespace swage::console
