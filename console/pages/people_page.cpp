// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/people_page.hpp"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QSplitter>
#include <QVBoxLayout>

#include "console/widgets/parts.hpp"

namespace swage::console {
namespace {

constexpr int kWatch_ms = 2000;  // what others have written appears that soon; a look costs under a millisecond

}  // namespace

PeoplePage::PeoplePage(StoreLink* link, QWidget* parent)
    : QWidget(parent), link_(link), people_(new PeopleModel(this)), sorted_(new QSortFilterProxyModel(this)) {
  sorted_->setSourceModel(people_);
  sorted_->setSortRole(PeopleModel::kSortRole);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 10, 12, 6);
  stack_ = new QStackedWidget(this);
  auto* splitter = new QSplitter(Qt::Vertical, stack_);
  splitter->setObjectName(QStringLiteral("people_splitter"));
  splitter->setChildrenCollapsible(false);
  splitter->addWidget(make_people());
  person_ = new PersonPanel(splitter);
  splitter->addWidget(person_);
  splitter->setStretchFactor(0, 2);
  splitter->setStretchFactor(1, 3);
  stack_->addWidget(splitter);
  stack_->addWidget(make_empty());
  row->addWidget(stack_);
  watch_.setInterval(kWatch_ms);
  connect(&watch_, &QTimer::timeout, this, &PeoplePage::look);
  watch_.start();
}

// what other programs and stations have written; nothing is asked while nobody looks
void PeoplePage::look() {
  if (isVisible() && link_->changed()) refresh();
}

QWidget* PeoplePage::make_people() {
  Card card = make_card({}, this);
  auto* head = new QHBoxLayout;
  head->addWidget(make_heading(tr("People"), card.frame));
  count_ = make_muted({}, card.frame);
  head->addWidget(count_, 1);
  card.body->addLayout(head);
  table_ = new QTableView(card.frame);
  table_->setObjectName(QStringLiteral("people"));
  table_->setAccessibleName(tr("People"));
  table_->setModel(sorted_);
  table_->setSortingEnabled(true);
  table_->sortByColumn(PeopleModel::kAttention, Qt::DescendingOrder);
  table_->setShowGrid(false);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setTabKeyNavigation(false);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(28);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(PeopleModel::kAttention, QHeaderView::Stretch);
  table_->setToolTip(tr("Enter shows this person's attempts"));
  card.body->addWidget(table_, 1);
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &PeoplePage::show_chosen);
  connect(table_, &QTableView::activated, this, [this] { person_->focus_attempts(); });
  return card.frame;
}

QWidget* PeoplePage::make_empty() {
  auto* box = new QWidget(this);
  auto* column = new QVBoxLayout(box);
  empty_ = new QLabel(box);
  empty_->setObjectName(QStringLiteral("empty"));
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  auto* go = make_button(tr("Run a lesson"), QStringLiteral("Ctrl+1"), QStringLiteral("run_lesson"), box);
  connect(go, &QPushButton::clicked, this, &PeoplePage::run_lesson);
  column->addStretch(2);
  column->addWidget(empty_);
  column->addSpacing(10);
  column->addWidget(go, 0, Qt::AlignHCenter);
  column->addStretch(3);
  return box;
}

void PeoplePage::show_empty(const QString& words) {
  empty_->setText(words);
  stack_->setCurrentIndex(1);
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

void PeoplePage::refresh() {
  const QString id = chosen();
  const std::shared_ptr<record::Store> store = link_->store();
  if (!store) return show_empty(link_->problem());
  const std::vector<record::Person> people = store->people();
  all_ = store->attempts("");
  if (!link_->reads()) return show_empty(link_->problem());
  people_->set_people(people, all_);
  count_->setText(people.size() == 1 ? tr("1 person") : tr("%1 people, those who need attention first").arg(people.size()));
  if (people.empty())
    return show_empty(
        tr("No one here yet. Attempts appear here after the first lesson; without a name they are kept for "
           "Guest."));
  stack_->setCurrentIndex(0);
  choose(id);
  show_chosen();
}

void PeoplePage::select_person(const QString& name) {
  const qsizetype row = people_->names().indexOf(name);
  if (row >= 0) choose(QString::fromStdString(people_->at(static_cast<int>(row)).id));
}

void PeoplePage::show_chosen() {
  const std::string id = chosen().toStdString();
  if (id.empty()) return;
  std::vector<record::AttemptRow> own;
  for (const record::AttemptRow& a : all_)
    if (a.person_id == id) own.push_back(a);
  person_->show_person(table_->currentIndex().siblingAtColumn(0).data().toString(), std::move(own));
}

}  // namespace swage::console
