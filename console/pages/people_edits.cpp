// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The edits of the People page: dialogs and confirmations, whose results go to the desk.
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLocale>
#include <QSaveFile>

#include "console/models/words.hpp"
#include "console/pages/people_dialogs.hpp"
#include "console/pages/people_page.hpp"
#include "console/report/person_report.hpp"
#include "console/widgets/parts.hpp"
#include "console/widgets/save_file.hpp"

namespace swage::console {

void PeoplePage::add_buttons(QHBoxLayout* row, QWidget* parent) {
  const auto add = [&](const QString& words, const char* key, const char* name, const QString& tip, auto call) {
    auto* button = make_button(words, {}, QString::fromLatin1(name), parent);
    button->setToolTip(tip);
    if (key) give_key(button, QString::fromLatin1(key));
    connect(button, &QPushButton::clicked, this, call);
    row->addWidget(button);
    return button;
  };
  add(tr("Add…"), "Ctrl+N", "add_person", tr("Add a person"), &PeoplePage::add_person);
  add(tr("Paste a list…"), "Ctrl+L", "add_list", tr("Add a list of people, with a preview"), &PeoplePage::add_list);
  row->addSpacing(10);
  of_person_ += add(tr("Change…"), "F2", "change_person", tr("Name, group and hand of the chosen person"), &PeoplePage::change_person);
  of_person_ += add(tr("Assign…"), "Ctrl+Shift+A", "assign_course", tr("Give the chosen people, or a group, a course"),
                    &PeoplePage::assign_course);
  of_person_ += add(tr("Report…"), "Ctrl+R", "report_person", tr("Pages about the chosen person and lesson, to print; of several people the one chosen last"),
                    &PeoplePage::report_person);
  of_person_ += add(tr("Export…"), "Ctrl+E", "export_person",
                    tr("The chosen person's attempts as a table, under the code and without the name"), &PeoplePage::export_person);
  of_person_ += add(tr("Erase…"), "Shift+Del", "erase_person", tr("The chosen person and everything of theirs, for good"),
                    &PeoplePage::erase_person);
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
}

QStringList PeoplePage::taken_names(const QString& but) const {
  QStringList names = people_->names();
  names.removeAll(but);
  return names;
}

void PeoplePage::add_person() {
  QStringList codes;
  for (int i = 0; i < people_->rowCount(); ++i) codes += QString::fromStdString(people_->at(i).code);
  PersonDialog dialog({}, true, groups_.values(), taken_names(), codes, this);
  if (dialog.exec() != QDialog::Accepted) return;
  if (desk_->add_people({dialog.person()})) select_person(dialog.person().name);
}

void PeoplePage::add_list() {
  RosterDialog dialog(people_->names(), this);
  if (dialog.exec() != QDialog::Accepted || !desk_->add_people(dialog.lines())) return;
  // selects the first new person, who may be listed far below those who need attention
  for (const RosterLine& line : dialog.lines())
    if (line.is == RosterLine::Is::kNew) return select_person(line.name);
}

void PeoplePage::change_person() {
  const int row = people_->row_of(chosen());
  if (row < 0) return;
  record::Person p = people_->at(row);
  RosterLine now;
  now.name = QString::fromStdString(p.name);
  now.group = groups_.value(QString::fromStdString(p.group_id));
  now.hand = QString::fromStdString(p.handedness);
  now.code = QString::fromStdString(p.code);
  PersonDialog dialog(now, false, groups_.values(), taken_names(now.name), {}, this);
  if (dialog.exec() != QDialog::Accepted) return;
  const RosterLine said = dialog.person();
  p.name = said.name.toStdString();
  p.handedness = said.hand.toStdString();
  p.group_id = desk_->group_id(said.group);
  desk_->change_person(p);
}

void PeoplePage::erase_person() {
  const int row = people_->row_of(chosen());
  record::School* school = desk_->school();
  if (row < 0 || !school) return;
  const record::Person p = people_->at(row);
  QStringList files;
  for (const record::ExportedFile& f : school->exported_files(p.id)) files += QString::fromStdString(f.station + ": " + f.file);
  EraseDialog dialog(QString::fromStdString(p.name), static_cast<int>(p.attempts), files, this);
  if (dialog.exec() == QDialog::Accepted) desk_->erase_person(QString::fromStdString(p.id));
}

// Title of the course by person: the person's own, else that of their group.
QHash<QString, QString> PeoplePage::courses_of(const std::vector<record::Person>& people) {
  QHash<QString, QString> out;
  record::School* school = desk_->school();
  if (!school) return out;
  QHash<QString, QString> titles;
  for (const record::Course& c : school->courses())
    if (c.archived_utc.empty()) titles.insert(QString::fromStdString(c.id), QString::fromStdString(c.title));
  const std::vector<record::Assignment> all = school->assignments();
  const auto add = [&](const std::string& person, const record::Assignment& a) {
    const QString title = titles.value(QString::fromStdString(a.course_id)), id = QString::fromStdString(person);
    if (title.isEmpty()) return;
    const QDate due = QDate::fromString(QString::fromStdString(a.due_utc).left(10), Qt::ISODate);
    const QString words = due.isValid() ? tr("%1, until %2").arg(title, QLocale().toString(due, QLocale::ShortFormat)) : title;
    QString& known = out[id];
    if (!known.contains(title)) known += (known.isEmpty() ? QString() : QStringLiteral("; ")) + words;
  };
  for (const record::Assignment& a : all)
    if (!a.to_group) add(a.who_id, a);
  for (const record::Assignment& a : all) {
    if (!a.to_group) continue;
    for (const record::Person& p : people)
      if (p.group_id == a.who_id) add(p.id, a);
  }
  return out;
}

void PeoplePage::assign_course() {
  record::School* school = desk_->school();
  const std::vector<std::string> people = all_chosen();
  if (!school || people.empty()) return;
  QVector<QPair<QString, QString>> courses;
  for (const record::Course& c : school->courses())
    if (c.archived_utc.empty()) courses += {QString::fromStdString(c.title), QString::fromStdString(c.id)};
  const int row = people_->row_of(chosen());
  const QString group = row < 0 ? QString() : QString::fromStdString(people_->at(row).group_id);
  AssignDialog dialog(courses, static_cast<int>(people.size()), groups_.value(group), this);
  if (dialog.exec() != QDialog::Accepted) return;
  const std::vector<std::string> who = dialog.to_group() ? std::vector<std::string>{group.toStdString()} : people;
  desk_->assign(dialog.course(), who, dialog.to_group(), dialog.due());
}

void PeoplePage::void_attempt() {
  const record::AttemptRow* attempt = person_->chosen_row();
  if (!attempt) return;
  const QString id = QString::fromStdString(attempt->id);
  if (attempt->is_void) {
    desk_->set_void(id, false, tr("counts again"));
    return;
  }
  bool ok = false;
  const QString reason = QInputDialog::getItem(
      this, tr("Void an attempt"), tr("Why does it not count?"),
      {tr("Technical fault"), tr("Wrong lesson or settings"), tr("Interrupted"), tr("Somebody helped")}, 0, true, &ok);
  if (ok && !reason.trimmed().isEmpty()) desk_->set_void(id, true, reason.trimmed());
}

void PeoplePage::give_attempt() {
  const record::AttemptRow* attempt = person_->chosen_row();
  if (!attempt) return;
  const QString id = QString::fromStdString(attempt->id), from = QString::fromStdString(attempt->person_id);
  QStringList names;
  for (int i = 0; i < people_->rowCount(); ++i)
    if (people_->at(i).id != attempt->person_id) names += QString::fromStdString(people_->at(i).name);
  bool ok = false;
  const QString name = QInputDialog::getItem(this, tr("Whose attempt is it?"), tr("Choose a person or type a new name"), names, 0, true, &ok)
                           .simplified();
  if (!ok || name.isEmpty()) return;
  RosterLine fresh;
  fresh.name = name;
  if (!people_->names().contains(name, Qt::CaseInsensitive) && !desk_->add_people({fresh})) return;
  for (int i = 0; i < people_->rowCount(); ++i) {
    if (QString::fromStdString(people_->at(i).name).compare(name, Qt::CaseInsensitive) == 0) {
      desk_->give_attempt(id, from, QString::fromStdString(people_->at(i).id));
      return;
    }
  }
}

QString PeoplePage::export_file(const QString& what, const QString& ending) const {
  const int row = people_->row_of(chosen());
  return row < 0 ? QString() : QStringLiteral("%1_%2%3").arg(QString::fromStdString(people_->at(row).code), what, ending);
}

QString PeoplePage::write_report_to(const QString& file) {
  const int row = people_->row_of(chosen());
  if (row < 0) return tr("Nobody is chosen.");
  const record::Person& p = people_->at(row);
  const QVector<record::AttemptRow> shown = person_->attempts()->attempts();
  return write_report({QString::fromStdString(p.name), QString::fromStdString(p.code), person_->lesson_title(), people_->standing(row),
                       person_->chart()->series(), person_->bars()->bars(), shown,
                       shown.isEmpty() ? std::vector<record::Exported>() : exported(shown.front().lesson_id)},
                      file);
}

// of the chosen person; lesson_id "": at all lessons
std::vector<record::Exported> PeoplePage::exported(const std::string& lesson_id) {
  std::vector<record::Exported> out;
  std::string error;
  const int row = people_->row_of(chosen());
  if (row < 0 || !exported_) return out;
  if (!exported_({}, {people_->at(row).id, lesson_id, {}}, out, error)) problem_->setText(tr("▲ %1").arg(QString::fromStdString(error)));
  return out;
}

void PeoplePage::report_person() {
  const int row = people_->row_of(chosen());
  const QString name = ask_save(this, tr("Report"), export_file(QStringLiteral("report"), QStringLiteral(".pdf")), tr("Page (*.pdf)"));
  if (row < 0 || name.isEmpty()) return;
  const std::string id = people_->at(row).id;
  const QString why = write_report_to(name);
  if (why.isEmpty() && desk_->school()) desk_->school()->log_export({id}, "report", name.toStdString());
  QString words = why.isEmpty() ? tr("Saved to: %1").arg(name) : tr("▲ %1").arg(why);
  if (const size_t chosen = all_chosen().size(); why.isEmpty() && chosen > 1)
    words += QLatin1Char(' ') + tr("It is about %1 alone, one of the %2 people chosen.")
                                    .arg(person_text(QString::fromStdString(people_->at(row).name)))
                                    .arg(chosen);
  problem_->setText(words);
  problem_->show();
}

void PeoplePage::export_person() {
  const int row = people_->row_of(chosen());
  if (row < 0) return;
  const record::Person p = people_->at(row);
  const QString name = ask_save(this, tr("Export a person's attempts"), export_file(QStringLiteral("attempts"), QStringLiteral(".csv")),
                                tr("Table (*.csv)"));
  if (name.isEmpty()) return;
  const QString why = write_attempts_to(name);
  if (why.isEmpty() && desk_->school()) desk_->school()->log_export({p.id}, "csv", name.toStdString());
  problem_->setText(why.isEmpty() ? tr("Saved to: %1").arg(name) : tr("▲ %1").arg(why));
  problem_->show();
}

QString PeoplePage::write_attempts_to(const QString& name) {
  QSaveFile file(name);
  const QByteArray text = QByteArray::fromStdString(record::csv_long(exported({})));
  const bool ok = file.open(QIODevice::WriteOnly) && file.write(text) == text.size() && file.commit();
  return ok ? QString() : tr("%1 cannot be written: %2.").arg(name, file.errorString());
}

}  // namespace swage::console
