// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/people_dialogs.hpp"

#include <QFile>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>
#include <algorithm>

#include "console/models/said.hpp"
#include "console/widgets/parts.hpp"
#include "record/people_list.hpp"

namespace swage::console {
namespace {

/// Adds Cancel and an action button, which is returned.
QPushButton* add_buttons(QVBoxLayout* column, const QString& words, const char* name, QDialog* dialog) {
  auto* row = new QHBoxLayout;
  auto* cancel = make_button(QObject::tr("Cancel"), QStringLiteral("Esc"), QStringLiteral("cancel"), dialog);
  auto* ok = make_button(words, {}, QString::fromLatin1(name), dialog);
  ok->setDefault(true);
  QObject::connect(cancel, &QPushButton::clicked, dialog, &QDialog::reject);
  QObject::connect(ok, &QPushButton::clicked, dialog, &QDialog::accept);
  row->addStretch(1);
  row->addWidget(cancel);
  row->addWidget(ok);
  column->addLayout(row);
  return ok;
}

QString hand_words(const QString& hand) {
  return hand == QLatin1String("left")    ? QObject::tr("left")
         : hand == QLatin1String("right") ? QObject::tr("right")
                                          : QString();
}

}  // namespace

PersonDialog::PersonDialog(const RosterLine& person, bool is_new, const QStringList& groups, const QStringList& known,
                           const QStringList& codes, QWidget* parent)
    : QDialog(parent), known_(known), codes_(codes) {
  setObjectName(QStringLiteral("person_dialog"));
  setWindowTitle(is_new ? tr("Add a person") : tr("Change a person"));
  auto* column = new QVBoxLayout(this);
  auto* form = new QFormLayout;
  const auto line = [&](const QString& label, const char* name, const QString& text) {
    auto* edit = new QLineEdit(text, this);
    edit->setObjectName(QString::fromLatin1(name));
    edit->setAccessibleName(label);
    form->addRow(label, edit);
    return edit;
  };
  name_ = line(tr("Name"), "person_name_edit", person.name);
  name_->setMinimumWidth(320);
  group_ = new QComboBox(this);
  group_->setObjectName(QStringLiteral("person_group"));
  group_->setAccessibleName(tr("Group"));
  group_->setEditable(true);
  group_->addItem(QString());
  group_->addItems(groups);
  group_->setCurrentText(person.group);
  group_->lineEdit()->setPlaceholderText(tr("none; type a new one"));
  form->addRow(tr("Group"), group_);
  hand_ = new QComboBox(this);
  hand_->setObjectName(QStringLiteral("person_hand"));
  hand_->setAccessibleName(tr("Handedness"));
  hand_->addItem(tr("not said"), QString());
  for (const char* hand : {"right", "left"}) hand_->addItem(hand_words(QLatin1String(hand)), QString::fromLatin1(hand));
  hand_->setCurrentIndex(hand_->findData(person.hand));
  form->addRow(tr("Handedness"), hand_);
  code_ = line(tr("Code"), "person_code", person.code);
  code_->setPlaceholderText(tr("made by itself"));
  code_->setReadOnly(!is_new);
  code_->setToolTip(tr("Exports say the code and never the name."));
  column->addLayout(form);
  column->addWidget(make_muted(tr("The name stays in this store; everything that leaves it says the code."), this));
  problem_ = make_muted({}, this);
  problem_->setObjectName(QStringLiteral("person_problem"));
  column->addWidget(problem_);
  ok_ = add_buttons(column, is_new ? tr("Add") : tr("Change"), "person_ok", this);
  for (QLineEdit* edit : {name_, code_}) connect(edit, &QLineEdit::textChanged, this, &PersonDialog::check);
  check();
}

void PersonDialog::check() {
  const QString name = name_->text().simplified();
  const bool taken = known_.contains(name, Qt::CaseInsensitive);
  const bool code_taken = codes_.contains(code_->text().simplified(), Qt::CaseInsensitive);
  problem_->setText(taken        ? tr("▲ Somebody is called that already. Add what tells the two apart.")
                    : code_taken ? tr("▲ This code is another person's already. Without one a code is made.")
                                 : QString());
  ok_->setEnabled(!name.isEmpty() && !taken && !code_taken);
}

RosterLine PersonDialog::person() const {
  RosterLine out;
  out.name = name_->text().simplified();
  out.group = group_->currentText().simplified();
  out.hand = hand_->currentData().toString();
  out.code = code_->text().simplified();
  return out;
}

RosterDialog::RosterDialog(const QStringList& known, QWidget* parent) : QDialog(parent), known_(known) {
  setObjectName(QStringLiteral("roster_dialog"));
  setWindowTitle(tr("Add a list of people"));
  resize(860, 480);
  auto* column = new QVBoxLayout(this);
  column->addWidget(make_muted(
      tr("Paste a name per line, or columns name, group, hand, code out of a table. A first line with these words says their order."),
      this));
  auto* row = new QHBoxLayout;
  text_ = new QPlainTextEdit(this);
  text_->setObjectName(QStringLiteral("roster_text"));
  text_->setAccessibleName(tr("List of people"));
  text_->setPlaceholderText(tr("Arun P.\nBea L., Spring, left"));
  text_->setTabChangesFocus(true);
  row->addWidget(text_, 2);
  preview_ = new QTableWidget(0, 5, this);
  preview_->setObjectName(QStringLiteral("roster_preview"));
  preview_->setAccessibleName(tr("What will be added"));
  preview_->setHorizontalHeaderLabels({{}, tr("Name"), tr("Group"), tr("Hand"), tr("Code")});
  preview_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  preview_->setSelectionMode(QAbstractItemView::NoSelection);
  preview_->setTabKeyNavigation(false);
  preview_->setShowGrid(false);
  preview_->verticalHeader()->hide();
  preview_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  preview_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  preview_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
  row->addWidget(preview_, 3);
  column->addLayout(row, 1);
  says_ = make_muted({}, this);
  says_->setObjectName(QStringLiteral("roster_says"));
  column->addWidget(says_);
  auto* open = make_button(tr("Open a file…"), {}, QStringLiteral("roster_file"), this);
  connect(open, &QPushButton::clicked, this, &RosterDialog::open_file);
  column->addWidget(open, 0, Qt::AlignLeft);
  add_ = add_buttons(column, tr("Add"), "roster_add", this);
  connect(text_, &QPlainTextEdit::textChanged, this, &RosterDialog::read);
  read();
}

void RosterDialog::open_file() {
  const QString name = QFileDialog::getOpenFileName(this, tr("A list of people"), {}, tr("Tables (*.csv *.txt *.tsv);;All files (*)"));
  QFile file(name);
  if (name.isEmpty()) return;
  if (!file.open(QIODevice::ReadOnly)) return says_->setText(tr("▲ %1 cannot be read: %2.").arg(name, file.errorString()));
  std::string text, told, error;
  if (!record::decode_list(file.readAll().toStdString(), text, told, error))
    return says_->setText(tr("▲ %1").arg(said_message(error)));
  text_->setPlainText(QString::fromStdString(text));
  if (!told.empty()) says_->setText((QStringLiteral("▲ %1 %2").arg(said_message(told), says_->text())).trimmed());
}

void RosterDialog::read() {
  using Is = RosterLine::Is;
  QStringList left_out;
  lines_ = read_roster(text_->toPlainText(), known_, &left_out);
  const auto n = std::count_if(lines_.begin(), lines_.end(), [](const RosterLine& l) { return l.is == Is::kNew; });
  preview_->setRowCount(static_cast<int>(lines_.size()));
  for (int i = 0; i < lines_.size(); ++i) {
    const RosterLine& l = lines_[i];
    const QString sign = l.is == Is::kNew ? tr("+ new") : QStringLiteral("– ") + l.says;
    const QStringList cells = {sign, l.name, l.group, hand_words(l.hand), l.code};
    for (int c = 0; c < cells.size(); ++c) {
      auto* cell = new QTableWidgetItem(cells[c]);
      if (l.is != Is::kNew) cell->setForeground(palette().color(QPalette::PlaceholderText));
      preview_->setItem(i, c, cell);
    }
  }
  says_->setText(lines_.isEmpty() ? QString()
                 : n == lines_.size()
                     ? QString()
                     : tr("%1 of %2 lines are left out; the preview says why.").arg(lines_.size() - n).arg(lines_.size()));
  if (!left_out.isEmpty())
    says_->setText((tr("▲ Columns that are left out: %1.").arg(left_out.join(QStringLiteral(", "))) + QLatin1Char(' ') + says_->text()).trimmed());
  add_->setEnabled(n > 0);
  add_->setText(n == 0 ? tr("Add") : n == 1 ? tr("Add 1 person") : tr("Add %1 people").arg(n));
}

AssignDialog::AssignDialog(const QVector<QPair<QString, QString>>& courses, int people, const QString& group, QWidget* parent)
    : QDialog(parent) {
  setObjectName(QStringLiteral("assign_dialog"));
  setWindowTitle(tr("Assign a course"));
  auto* column = new QVBoxLayout(this);
  auto* form = new QFormLayout;
  const auto combo = [&](const QString& label, const char* name) {
    auto* box = new QComboBox(this);
    box->setObjectName(QString::fromLatin1(name));
    box->setAccessibleName(label);
    box->setMinimumWidth(320);
    form->addRow(label, box);
    return box;
  };
  course_ = combo(tr("Course"), "assign_which");
  for (const auto& [title, id] : courses) course_->addItem(title, id);
  course_->addItem(tr("none: take back what was assigned"), QString());
  whom_ = combo(tr("To"), "assign_whom");
  whom_->addItem(people == 1 ? tr("The chosen person") : tr("The %1 chosen people").arg(people));
  if (!group.isEmpty()) whom_->addItem(tr("Everybody in %1, also who joins later").arg(group));
  auto* row = new QHBoxLayout;
  has_due_ = new QCheckBox(tr("Until"), this);
  has_due_->setObjectName(QStringLiteral("assign_has_due"));
  due_ = new QDateEdit(QDate::currentDate().addMonths(1), this);
  due_->setObjectName(QStringLiteral("assign_due"));
  due_->setAccessibleName(tr("Until"));
  due_->setCalendarPopup(true);
  due_->setDisplayFormat(tr("d MMM yyyy"));  // the format of all dates
  due_->setEnabled(false);
  connect(has_due_, &QCheckBox::toggled, due_, &QWidget::setEnabled);
  row->addWidget(has_due_);
  row->addWidget(due_, 1);
  form->addRow(QString(), row);
  column->addLayout(form);
  if (courses.isEmpty()) column->addWidget(make_muted(tr("There is no course yet: make one on the Courses page."), this));
  add_buttons(column, tr("Assign"), "assign_ok", this);
}

QString AssignDialog::due() const { return has_due_->isChecked() ? due_->date().toString(Qt::ISODate) : QString(); }

EraseDialog::EraseDialog(const QString& name, int attempts, const QStringList& files, QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("erase_dialog"));
  setWindowTitle(tr("Erase a person"));
  auto* column = new QVBoxLayout(this);
  auto* text = new QLabel(tr("%1 and %2 attempts with their recordings, notes and marks are erased for good. There is no undo, and no "
                             "backup brings them back.")
                              .arg(name)
                              .arg(attempts),
                          this);
  text->setWordWrap(true);
  text->setMinimumWidth(420);
  column->addWidget(text);
  if (!files.isEmpty())
    column->addWidget(make_muted(tr("These files were written from this store and are not touched:\n%1").arg(files.join(QLatin1Char('\n'))), this));
  column->addWidget(new QLabel(tr("Type the name to go on:"), this));
  auto* typed = new QLineEdit(this);
  typed->setObjectName(QStringLiteral("erase_name"));
  typed->setAccessibleName(tr("The name of who is to be erased"));
  typed->setPlaceholderText(name);
  column->addWidget(typed);
  QPushButton* ok = add_buttons(column, tr("Erase for good"), "erase_ok", this);
  ok->setEnabled(false);
  connect(typed, &QLineEdit::textChanged, ok, [ok, name](const QString& t) { ok->setEnabled(t == name); });
}

}  // namespace swage::console
