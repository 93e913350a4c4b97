// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/people_page.hpp"

#include <QHBoxLayout>
#include <QRegularExpression>
#include <QHeaderView>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>
#include <iterator>

#include "console/models/people_courses.hpp"
#include "console/widgets/parts.hpp"

namespace swage::console {
namespace {

constexpr int kWatch_ms = 2000;  // interval at which changes by other programs are looked for; a query takes less than a millisecond

}  // namespace

PeoplePage::PeoplePage(StoreLink* link, SchoolDesk* desk, QWidget* parent)
    : QWidget(parent), link_(link), desk_(desk), people_(new PeopleModel(this)), sorted_(new QSortFilterProxyModel(this)),
      edits_(new PeopleEdits(people_, desk_, this)) {
  sorted_->setSourceModel(people_);
  sorted_->setSortRole(PeopleModel::kSortRole);
  sorted_->setFilterRole(PeopleModel::kGroupRole);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 10, 12, 6);
  stack_ = new QStackedWidget(this);
  auto* splitter = new QSplitter(Qt::Vertical, stack_);
  splitter->setObjectName(QStringLiteral("people_splitter"));
  splitter->setChildrenCollapsible(false);
  splitter->addWidget(make_people());
  person_ = new PersonPanel(splitter);
  files_ = new PeopleFiles({people_, person_, desk_, link_}, this);
  splitter->addWidget(person_);
  splitter->setStretchFactor(0, 2);
  splitter->setStretchFactor(1, 3);
  splitter->setSizes({300, 400});  // seven people and a chart on a screen of 800 lines
  stack_->addWidget(splitter);
  stack_->addWidget(make_empty());
  row->addWidget(stack_);
  watch_.setInterval(kWatch_ms);
  connect(&watch_, &QTimer::timeout, this, &PeoplePage::look);
  watch_.start();
  connect(desk_, &SchoolDesk::changed, this, &PeoplePage::refresh);
  connect(desk_, &SchoolDesk::failed, this, [this](const QString& why) {
    if (!isVisible()) return;  // a failure on another page is shown there
    problem_->setText(tr("▲ %1").arg(why));
    problem_->show();
  });
  person_->set_expert_finder([this](const std::string& lesson, const QString& metric) {
    std::vector<std::string> experts;
    for (int i = 0; i < people_->rowCount(); ++i)
      if (is_expert_group(people_->index(i, PeopleModel::kGroup).data().toString())) experts.push_back(people_->at(i).id);
    return experts_of(experts_at(lesson, experts), experts, lesson, metric);
  });
  person_->set_group_finder([this](const std::string& lesson) { return attempts_of(all_chosen(), lesson); });
  connect(person_, &PersonPanel::void_attempt, this, [this] { edits_->void_attempt(person_->chosen_row()); });
  connect(person_, &PersonPanel::give_attempt, this, [this] { edits_->give_attempt(person_->chosen_row()); });
  connect(edits_, &PeopleEdits::added, this, &PeoplePage::select_person);
  connect(files_, &PeopleFiles::told, this, [this](const QString& words) {
    problem_->setText(words);
    problem_->show();
  });
}

// The buttons stand below group and count where a line of both would break the count into a strip of single words, as on a small screen.
void PeoplePage::fold_head() {
  constexpr int kGaps_px = 90;  // heading's margins and spaces
  const int line = group_->sizeHint().width() + count_->fontMetrics().horizontalAdvance(count_->text()) +
                   count_->fontMetrics().horizontalAdvance(tr("People")) + kGaps_px + buttons_->sizeHint().width();
  head_->setDirection(line > width() ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

void PeoplePage::resizeEvent(QResizeEvent* event) {
  fold_head();
  QWidget::resizeEvent(event);
}

// looks for changes by other programs and stations, while the page is visible
void PeoplePage::look() {
  if (isVisible() && link_->changed()) refresh();
}

QWidget* PeoplePage::make_people() {
  Card card = make_card({}, this);
  head_ = new QBoxLayout(QBoxLayout::LeftToRight);
  auto* head = new QHBoxLayout;
  head->addWidget(make_heading(tr("People"), card.frame));
  group_ = new QComboBox(card.frame);
  group_->setObjectName(QStringLiteral("group_filter"));
  group_->setAccessibleName(tr("Group"));
  group_->setToolTip(tr("Whose people are listed"));
  group_->addItem(tr("All groups"), QString());
  group_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  connect(group_, &QComboBox::activated, this, [this] {
    const QString id = group_->currentData().toString();
    sorted_->setFilterRegularExpression(id.isEmpty() ? QString() : QStringLiteral("^%1$").arg(QRegularExpression::escape(id)));
    if (!table_->currentIndex().isValid()) table_->selectRow(0);
    show_count();
  });
  head->addWidget(group_);
  count_ = make_muted({}, card.frame);
  head->addWidget(count_, 1);
  head_->addLayout(head, 1);
  auto* buttons = new QHBoxLayout;
  add_buttons(buttons, card.frame);
  buttons_ = buttons;
  head_->addLayout(buttons_);
  card.body->addLayout(head_);
  problem_ = make_muted({}, card.frame);
  problem_->setObjectName(QStringLiteral("people_problem"));
  problem_->hide();
  card.body->addWidget(problem_);
  table_ = make_row_table(sorted_, tr("People"), QStringLiteral("people"), card.frame);
  table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  table_->setSortingEnabled(true);
  table_->sortByColumn(PeopleModel::kAttention, Qt::DescendingOrder);
  table_->horizontalHeader()->setSectionResizeMode(PeopleModel::kAttention, QHeaderView::Stretch);
  table_->setToolTip(tr("Enter shows this person's attempts"));
  card.body->addWidget(table_, 1);
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &PeoplePage::show_chosen);
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] { person_->show_group(); });
  connect(table_, &QTableView::activated, this, [this] { person_->focus_attempts(); });
  return card.frame;
}

void PeoplePage::add_buttons(QHBoxLayout* row, QWidget* parent) {
  const auto add = [&](const QString& words, const char* key, const char* name, const QString& tip, auto call) {
    auto* button = make_button(words, {}, QString::fromLatin1(name), parent);
    button->setToolTip(tip);
    if (key) give_key(button, QString::fromLatin1(key));
    connect(button, &QPushButton::clicked, this, call);
    row->addWidget(button);
    return button;
  };
  add(tr("Add…"), "Ctrl+N", "add_person", tr("Add a person"), [this] { edits_->add_person(); });
  add(tr("Paste a list…"), "Ctrl+L", "add_list", tr("Add a list of people, with a preview"), [this] { edits_->add_list(); });
  row->addSpacing(10);
  of_person_ += add(tr("Change…"), "F2", "change_person", tr("Name, group and hand of the chosen person"),
                    [this] { edits_->change_person(chosen()); });
  of_person_ += add(tr("Assign…"), "Ctrl+Shift+A", "assign_course", tr("Give the chosen people, or a group, a course"),
                    [this] { edits_->assign_course(all_chosen(), chosen()); });
  of_person_ += add(tr("Report…"), "Ctrl+R", "report_person", tr("Pages about the chosen person and lesson, to print; of several people the one chosen last"),
                    [this] { files_->report(chosen(), all_chosen().size()); });
  of_person_ += add(tr("Group…"), "Ctrl+G", "report_group",
                    tr("A page to print with a table of the chosen people, or of all who are listed where only one is chosen: lessons passed, "
                       "attempts, last score, who needs attention"),
                    [this] { report_group(); });
  of_person_ += add(tr("Export…"), "Ctrl+E", "export_person",
                    tr("The chosen person's attempts as a table, under the code and without the name"), [this] { files_->export_attempts(chosen()); });
  of_person_ += add(tr("Erase…"), "Shift+Del", "erase_person", tr("The chosen person and everything of theirs, for good"),
                    [this] { edits_->erase_person(chosen()); });
}

// the chosen people, or all who are listed where only one is chosen
void PeoplePage::report_group() {
  std::vector<std::string> people = all_chosen();
  const auto listed = static_cast<std::size_t>(sorted_->rowCount());
  if (people.size() < 2) {
    people.clear();
    for (int i = 0; i < sorted_->rowCount(); ++i) people.push_back(sorted_->index(i, 0).data(PeopleModel::kId).toString().toStdString());
  }
  const bool all = people.size() == listed;
  const QString group = group_->currentIndex() > 0 ? group_->currentText() : tr("Everybody");
  files_->report_group(people, all ? group : tr("%1 people").arg(people.size()));
}

QWidget* PeoplePage::make_empty() {
  auto* box = new QWidget(this);
  auto* column = new QVBoxLayout(box);
  empty_ = new QLabel(box);
  empty_->setObjectName(QStringLiteral("empty"));
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  auto* buttons = new QHBoxLayout;
  buttons->addStretch(1);
  const auto add = [&](const QString& words, const QString& key, const char* name, auto call) {
    auto* button = make_button(words, key, QString::fromLatin1(name), box);
    connect(button, &QPushButton::clicked, this, call);
    buttons->addWidget(button);
    return button;
  };
  add(tr("Run a lesson"), QStringLiteral("Ctrl+1"), "run_lesson", [this] { Q_EMIT run_lesson(); });
  add(tr("Add a person…"), QStringLiteral("Ctrl+N"), "first_person", [this] { edits_->add_person(); })
      ->setShortcut(QKeySequence(QStringLiteral("Ctrl+N")));
  add(tr("Paste a list…"), QStringLiteral("Ctrl+L"), "first_list", [this] { edits_->add_list(); })
      ->setShortcut(QKeySequence(QStringLiteral("Ctrl+L")));
  buttons->addStretch(1);
  column->addStretch(2);
  column->addWidget(empty_);
  column->addSpacing(10);
  column->addLayout(buttons);
  column->addStretch(3);
  return box;
}

void PeoplePage::show_empty(const QString& words) {
  empty_->setText(words);
  stack_->setCurrentIndex(1);
}

void PeoplePage::fill_groups() {
  record::School* school = desk_->school();
  if (!school) return;
  const QVariant before = group_->currentData();
  groups_.clear();
  group_->clear();
  group_->addItem(tr("All groups"), QString());
  for (const record::Group& g : school->groups()) {
    if (!g.archived_utc.empty()) continue;
    groups_.insert(QString::fromStdString(g.id), QString::fromStdString(g.name));
    group_->addItem(QString::fromStdString(g.name), QString::fromStdString(g.id));
  }
  group_->setCurrentIndex(std::max(0, group_->findData(before)));
  group_->setVisible(!groups_.isEmpty());
  edits_->set_groups(groups_);
}

QString PeoplePage::chosen() const {
  return table_->currentIndex().siblingAtColumn(0).data(PeopleModel::kId).toString();
}

void PeoplePage::choose(const QString& id) {
  const int row = people_->row_of(id);
  const QModelIndex at = row < 0 ? sorted_->index(0, 0) : sorted_->mapFromSource(people_->index(row, 0));
  table_->setCurrentIndex(at);
  table_->scrollTo(at);
}

// beside the chosen one: who were chosen together stay so when the table is filled anew
void PeoplePage::choose_too(const std::vector<std::string>& ids) {
  for (const std::string& id : ids)
    if (const int row = people_->row_of(QString::fromStdString(id)); row >= 0)
      table_->selectionModel()->select(sorted_->mapFromSource(people_->index(row, 0)), QItemSelectionModel::Select | QItemSelectionModel::Rows);
}

void PeoplePage::refresh() {
  const QString id = chosen();
  const std::vector<std::string> together = all_chosen();
  const std::shared_ptr<record::Store> store = link_->store();
  if (!store) return show_empty(link_->problem());
  const std::vector<record::Person> people = store->people();
  const std::vector<record::AttemptRow> heads = store->attempt_heads();
  lesson_read_.clear();
  if (!link_->reads()) return show_empty(link_->problem());
  fill_groups();
  people_->set_people(people, heads, groups_, desk_->school() ? courses_of(*desk_->school(), people) : QHash<QString, QString>());
  problem_->hide();
  show_count();
  if (people.empty())
    return show_empty(
        tr("No one here yet. Attempts appear here after the first lesson; without a name they are kept for "
           "Guest, and can be given a name later."));
  stack_->setCurrentIndex(0);
  filling_ = true;
  choose(id);
  if (together.size() > 1) choose_too(together);
  filling_ = false;
  show_chosen();
}

// of the listed people
void PeoplePage::show_count() {
  const int all = people_->rowCount(), listed = sorted_->rowCount();
  QString words = all == 1 ? tr("1 person") : tr("%1 people").arg(all);
  if (listed < all) words = tr("%1 of %2 people").arg(listed).arg(all);
  count_->setText(listed > 1 ? tr("%1, those who need attention first").arg(words) : words);
  fold_head();
}

void PeoplePage::select_person(const QString& name) {
  const qsizetype row = people_->names().indexOf(name);
  if (row >= 0) choose(QString::fromStdString(people_->at(static_cast<int>(row)).id));
}

std::vector<std::string> PeoplePage::all_chosen() const {
  std::vector<std::string> out;
  for (const QModelIndex& row : table_->selectionModel()->selectedRows())
    out.push_back(row.data(PeopleModel::kId).toString().toStdString());
  return out;
}

// with their metrics; those of other people are not read
std::vector<record::AttemptRow> PeoplePage::attempts_of(const std::vector<std::string>& people, const std::string& lesson) {
  std::vector<record::AttemptRow> out;
  const std::shared_ptr<record::Store> store = link_->store();
  for (const std::string& id : people) {
    if (!store) break;
    std::vector<record::AttemptRow> own = store->attempts(id, lesson);
    out.insert(out.end(), std::make_move_iterator(own.begin()), std::make_move_iterator(own.end()));
  }
  std::stable_sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.started_utc > b.started_utc; });
  return out;
}

const std::vector<record::AttemptRow>& PeoplePage::experts_at(const std::string& lesson, const std::vector<std::string>& experts) {
  if (lesson_read_ == lesson) return of_experts_;
  const std::shared_ptr<record::Store> store = link_->store();
  of_experts_ = store ? read_expert_attempts(*store, experts, lesson) : std::vector<record::AttemptRow>();
  lesson_read_ = lesson;
  return of_experts_;
}

void PeoplePage::show_chosen() {
  if (filling_) return;
  const std::string id = chosen().toStdString();
  for (QPushButton* b : of_person_) b->setEnabled(!id.empty());
  if (id.empty()) return person_->show_person({}, {});
  std::vector<record::AttemptRow> own = attempts_of({id}, "");
  person_->show_person(table_->currentIndex().siblingAtColumn(0).data().toString(), std::move(own));
}

}  // namespace swage::console
