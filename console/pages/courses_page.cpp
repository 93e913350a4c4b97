// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/courses_page.hpp"

#include <QHBoxLayout>
#include <QSplitter>
#include <QStandardItemModel>
#include <QVBoxLayout>
#include <algorithm>

#include "console/models/said.hpp"
#include "console/widgets/parts.hpp"

namespace swage::console {
namespace {

constexpr int kNarrow_px = 1150;
constexpr int kLeastRule_px = 300;  // of the rule, beside the lists on a narrow screen
constexpr int kTitle = 1;           // field of the course; successive edits of one are undone together

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
    : QWidget(parent), desk_(desk), lessons_(lessons), editing_(desk, link, std::move(metrics)) {
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
  connect(&editing_, &CourseEditing::edited, problem_, &QWidget::hide);
  connect(limits_, &LimitsPanel::refused, this, &CoursesPage::show_problem);
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

void CoursesPage::resizeEvent(QResizeEvent*) {
  rule_->set_narrow(width() < kNarrow_px);
  limits_->set_narrow(width() < kNarrow_px);
}

void CoursesPage::hideEvent(QHideEvent*) { problem_->hide(); }

QWidget* CoursesPage::make_courses() {
  Card card = make_card(tr("Courses"), this);
  list_ = make_list("courses", tr("Courses"), card.frame);
  card.body->addWidget(list_, 1);
  connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
    if (!editing_.filling()) choose_course(row);
  });
  auto* add = make_button(tr("New course"), QStringLiteral("Ctrl+N"), QStringLiteral("new_course"), card.frame);
  add->setShortcut(QKeySequence(QStringLiteral("Ctrl+N")));
  connect(add, &QPushButton::clicked, this, &CoursesPage::new_course);
  auto* remove = make_button(tr("Remove"), {}, QStringLiteral("remove_course"), card.frame);
  remove->setToolTip(tr("Remove the course; Ctrl+Z brings it back"));
  give_key(remove, QStringLiteral("Ctrl+Shift+D"));
  connect(remove, &QPushButton::clicked, this, [this] {
    if (!course().id.empty()) desk_->change_course(course(), {}, tr("Remove course"));
  });
  card.body->addWidget(add);
  card.body->addWidget(remove);
  return card.frame;
}

void CoursesPage::new_course() {
  record::Course fresh;
  fresh.title = tr("Course %1").arg(courses_.size() + 1).toStdString();
  editing_.set_course({});
  if (!desk_->change_course({}, fresh, tr("New course"))) return;
  title_->setFocus();
  title_->selectAll();
}

QWidget* CoursesPage::make_steps() {
  Card card = make_card({}, this);
  title_ = new QLineEdit(card.frame);
  title_->setObjectName(QStringLiteral("course_title"));
  title_->setAccessibleName(tr("Title of the course"));
  connect(title_, &QLineEdit::textEdited, this, [this](const QString& text) {
    editing_.edit(tr("Title"), [&](record::Course& c) { c.title = text.toStdString(); }, kTitle);
  });
  card.body->addWidget(title_);
  in_order_ = new QCheckBox(tr("One after the other"), card.frame);
  in_order_->setObjectName(QStringLiteral("in_order"));
  in_order_->setToolTip(tr("A lesson opens when the one before it is passed: until then practice asks first, and a test needs an instructor's reason"));
  connect(in_order_, &QCheckBox::clicked, this, [this](bool on) { editing_.edit(tr("Order"), [&](record::Course& c) { c.in_order = on; }); });
  card.body->addWidget(in_order_);
  steps_ = make_list("steps", tr("Lessons of the course"), card.frame);
  card.body->addWidget(steps_, 1);
  connect(steps_, &QListWidget::currentRowChanged, this, [this] {
    editing_.set_step(steps_->currentRow());
    if (!editing_.filling()) show_step();
  });
  lesson_ = new QComboBox(card.frame);
  lesson_->setObjectName(QStringLiteral("add_lesson_choice"));
  lesson_->setAccessibleName(tr("Lesson to add"));
  lesson_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  lesson_->setMinimumContentsLength(16);
  card.body->addWidget(lesson_);
  card.body->addLayout(make_step_buttons(card.frame));
  return card.frame;
}

QLayout* CoursesPage::make_step_buttons(QWidget* parent) {
  auto* row = new QHBoxLayout;
  const auto add = [&](const QString& text, const char* key, const char* name, const QString& tip, auto call) {
    auto* button = make_button(text, {}, QString::fromLatin1(name), parent);
    button->setAccessibleName(tip);
    button->setToolTip(tip);
    give_key(button, QString::fromLatin1(key));
    connect(button, &QPushButton::clicked, this, call);
    row->addWidget(button);
  };
  add(tr("Add"), "Ctrl+L", "add_lesson", tr("Add the lesson behind the chosen one"), [this] { add_lesson(); });
  add(QStringLiteral("↑"), "Ctrl+Up", "step_up", tr("Earlier"), [this] { move_step(-1); });
  add(QStringLiteral("↓"), "Ctrl+Down", "step_down", tr("Later"), [this] { move_step(+1); });
  add(tr("Remove"), "Ctrl+D", "remove_step", tr("Take the lesson out of the course"), [this] { remove_step(); });
  return row;
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
  connect(open_, &QCheckBox::clicked, this, [this](bool on) { editing_.edit_step(tr("Open"), [&](record::CourseStep& s) { s.is_open = on; }); });
  column->addWidget(open_);
  column->addWidget(rule_ = new RulePanel(&editing_, box));
  column->addWidget(limits_ = new LimitsPanel(&editing_, box), 1);
  scroll->setWidget(box);
  step_stack_->addWidget(scroll);
  QLabel* none = make_muted(tr("Add a lesson to say when it is passed."), step_stack_);
  none->setAlignment(Qt::AlignCenter);
  step_stack_->addWidget(none);
  return step_stack_;
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

// keeps the selection; a focused text field is not overwritten
void CoursesPage::refresh() {
  record::School* school = desk_->school();
  if (!school) {
    empty_->setText(desk_->problem());
    return stack_->setCurrentIndex(1);
  }
  courses_ = school->courses();
  std::erase_if(courses_, [](const record::Course& c) { return !c.archived_utc.empty(); });
  editing_.forget_attempts();
  empty_->setText(tr("No course yet. A course is a row of lessons with a rule that says when each is passed."));
  stack_->setCurrentIndex(courses_.empty() ? 1 : 0);
  {
    const auto quiet = editing_.quiet();
    fill_courses();
    fill_lessons();
  }
  choose_course(list_->currentRow());
}

void CoursesPage::fill_courses() {
  std::vector<std::string> known;
  for (int i = 0; i < list_->count(); ++i) known.push_back(list_->item(i)->data(Qt::UserRole).toString().toStdString());
  list_->clear();
  int chosen = 0;
  for (const record::Course& c : courses_) {
    auto* item = new QListWidgetItem(QString::fromStdString(c.title), list_);
    item->setData(Qt::UserRole, QString::fromStdString(c.id));
    const bool fresh = course().id.empty() && std::find(known.begin(), known.end(), c.id) == known.end();
    if (c.id == course().id || fresh) chosen = list_->count() - 1;
  }
  list_->setCurrentRow(chosen);
}

// A lesson with a faulty file is listed with its error, and cannot be selected.
void CoursesPage::fill_lessons() {
  const QString chosen = lesson_->currentData().toString();
  lesson_->clear();
  auto* items = qobject_cast<QStandardItemModel*>(lesson_->model());
  int first = -1, again = -1;
  for (int i = 0; i < lessons_->rowCount(); ++i) {
    const LessonEntry& lesson = lessons_->at(i);
    const bool faulty = !lesson.problem.isEmpty();
    lesson_->addItem((faulty ? tr("▲ faulty: ") : QString()) + said(lesson.title), lesson.id);
    if (faulty) {
      lesson_->setItemData(i, lesson.problem, Qt::ToolTipRole);
      if (items) items->item(i)->setEnabled(false);
      continue;
    }
    if (first < 0) first = i;
    if (again < 0 && lesson.id == chosen) again = i;
  }
  lesson_->setCurrentIndex(again >= 0 ? again : first);
}

void CoursesPage::choose_course(int row) {
  editing_.set_course(row >= 0 && static_cast<size_t>(row) < courses_.size() ? courses_[static_cast<size_t>(row)] : record::Course{});
  show_course();
}

void CoursesPage::show_course() {
  {
    const auto quiet = editing_.quiet();
    fill_steps();
  }
  show_step();
}

void CoursesPage::fill_steps() {
  const QString title = QString::fromStdString(course().title);
  if (title_->text() != title) title_->setText(title);
  in_order_->setChecked(course().in_order);
  const int at = steps_->currentRow();
  steps_->clear();
  int number = 0;
  for (const record::CourseStep& s : course().steps) {
    const QString known = QString::fromStdString(s.lesson_id);
    const int row = lessons_->row_of(known);
    const QString fault = row < 0 ? tr("▲ not installed: ") : lessons_->at(row).problem.isEmpty() ? QString() : tr("▲ faulty: ");
    steps_->addItem(tr("%1  %3%2").arg(++number).arg(said(s.title.empty() ? s.lesson_id : s.title), fault));
  }
  steps_->setCurrentRow(std::clamp(at, course().steps.empty() ? -1 : 0, static_cast<int>(course().steps.size()) - 1));
  editing_.set_step(steps_->currentRow());
}

// Why a lesson of the course cannot be done at this station; "" where it can.
QString CoursesPage::fault_of(const record::CourseStep& s) const {
  const int row = lessons_->row_of(QString::fromStdString(s.lesson_id));
  if (row < 0) return tr("▲ This lesson is not installed here: nobody can do it at this station.");
  const QString& problem = lessons_->at(row).problem;
  return problem.isEmpty() ? QString() : tr("▲ The file of this lesson is faulty: nobody can do it. %1").arg(problem);
}

void CoursesPage::show_step() {
  const record::CourseStep* s = editing_.step();
  step_stack_->setCurrentIndex(s ? 0 : 1);
  if (!s) return;
  {
    const auto quiet = editing_.quiet();
    step_title_->setText(said(s->title.empty() ? s->lesson_id : s->title));
    step_fault_->setText(fault_of(*s));
    step_fault_->setVisible(!step_fault_->text().isEmpty());
    open_->setChecked(s->is_open);
  }
  rule_->refresh();
  limits_->refresh();
}

void CoursesPage::add_lesson() {
  const int row = lessons_->row_of(lesson_->currentData().toString()), at = steps_->currentRow() + 1;
  if (row < 0) return;
  if (!lessons_->at(row).problem.isEmpty()) {
    return show_problem(lessons_->at(row).problem);
  }
  record::CourseStep fresh;
  fresh.lesson_id = lessons_->at(row).id.toStdString();
  fresh.title = lessons_->at(row).title.toStdString();
  editing_.edit(tr("Add a lesson"), [&](record::Course& c) { c.steps.insert(c.steps.begin() + at, fresh); });
  steps_->setCurrentRow(at);
  if (title_->hasFocus()) steps_->setFocus();  // a focused text field would handle Ctrl+Z itself
  for (int next = lesson_->currentIndex() + 1; next < lesson_->count(); ++next) {
    if (!lessons_->at(next).problem.isEmpty()) continue;
    return lesson_->setCurrentIndex(next);  // the next lesson that can be added
  }
}

void CoursesPage::move_step(int by) {
  const int at = steps_->currentRow(), to = at + by;
  if (at < 0 || to < 0 || to >= steps_->count()) return;
  editing_.edit(tr("Order"), [&](record::Course& c) { std::swap(c.steps[static_cast<size_t>(at)], c.steps[static_cast<size_t>(to)]); });
  steps_->setCurrentRow(to);
}

void CoursesPage::remove_step() {
  const auto at = steps_->currentRow();
  if (at >= 0) editing_.edit(tr("Remove a lesson"), [&](record::Course& c) { c.steps.erase(c.steps.begin() + at); });
}

}  // namespace swage::console
