// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/people_edits.hpp"

#include <QInputDialog>

#include "console/pages/people_dialogs.hpp"

namespace swage::console {

PeopleEdits::PeopleEdits(const PeopleModel* people, SchoolDesk* desk, QWidget* page)
    : QObject(page), people_(people), desk_(desk), page_(page) {}

QStringList PeopleEdits::taken_names(const QString& but) const {
  QStringList names = people_->names();
  names.removeAll(but);
  return names;
}

void PeopleEdits::add_person() {
  QStringList codes;
  for (int i = 0; i < people_->rowCount(); ++i) codes += QString::fromStdString(people_->at(i).code);
  PersonDialog dialog({}, true, groups_.values(), taken_names(), codes, page_);
  if (dialog.exec() != QDialog::Accepted) return;
  if (desk_->add_people({dialog.person()})) Q_EMIT added(dialog.person().name);
}

void PeopleEdits::add_list() {
  RosterDialog dialog(people_->names(), page_);
  if (dialog.exec() != QDialog::Accepted || !desk_->add_people(dialog.lines())) return;
  // selects the first new person, who may be listed far below those who need attention
  for (const RosterLine& line : dialog.lines())
    if (line.is == RosterLine::Is::kNew) return added(line.name);
}

void PeopleEdits::change_person(const QString& id) {
  const int row = people_->row_of(id);
  if (row < 0) return;
  record::Person p = people_->at(row);
  RosterLine now;
  now.name = QString::fromStdString(p.name);
  now.group = groups_.value(QString::fromStdString(p.group_id));
  now.hand = QString::fromStdString(p.handedness);
  now.code = QString::fromStdString(p.code);
  PersonDialog dialog(now, false, groups_.values(), taken_names(now.name), {}, page_);
  if (dialog.exec() != QDialog::Accepted) return;
  const RosterLine said = dialog.person();
  p.name = said.name.toStdString();
  p.handedness = said.hand.toStdString();
  p.group_id = desk_->group_id(said.group);
  desk_->change_person(p);
}

void PeopleEdits::erase_person(const QString& id) {
  const int row = people_->row_of(id);
  record::School* school = desk_->school();
  if (row < 0 || !school) return;
  const record::Person p = people_->at(row);
  QStringList files;
  for (const record::ExportedFile& f : school->exported_files(p.id)) files += QString::fromStdString(f.station + ": " + f.file);
  EraseDialog dialog(QString::fromStdString(p.name), static_cast<int>(p.attempts), files, page_);
  if (dialog.exec() == QDialog::Accepted) desk_->erase_person(QString::fromStdString(p.id));
}

void PeopleEdits::assign_course(const std::vector<std::string>& people, const QString& of) {
  record::School* school = desk_->school();
  if (!school || people.empty()) return;
  QVector<QPair<QString, QString>> courses;
  for (const record::Course& c : school->courses())
    if (c.archived_utc.empty()) courses += {QString::fromStdString(c.title), QString::fromStdString(c.id)};
  const int row = people_->row_of(of);
  const QString group = row < 0 ? QString() : QString::fromStdString(people_->at(row).group_id);
  AssignDialog dialog(courses, static_cast<int>(people.size()), groups_.value(group), page_);
  if (dialog.exec() != QDialog::Accepted) return;
  const std::vector<std::string> who = dialog.to_group() ? std::vector<std::string>{group.toStdString()} : people;
  desk_->assign(dialog.course(), who, dialog.to_group(), dialog.due());
}

void PeopleEdits::void_attempt(const record::AttemptRow* attempt) {
  if (!attempt) return;
  const QString id = QString::fromStdString(attempt->id);
  if (attempt->is_void) {
    desk_->set_void(id, false, tr("counts again"));
    return;
  }
  bool ok = false;
  const QString reason = QInputDialog::getItem(
      page_, tr("Void an attempt"), tr("Why does it not count?"),
      {tr("Technical fault"), tr("Wrong lesson or settings"), tr("Interrupted"), tr("Somebody helped")}, 0, true, &ok);
  if (ok && !reason.trimmed().isEmpty()) desk_->set_void(id, true, reason.trimmed());
}

void PeopleEdits::give_attempt(const record::AttemptRow* attempt) {
  if (!attempt) return;
  const QString id = QString::fromStdString(attempt->id), from = QString::fromStdString(attempt->person_id);
  QStringList names;
  for (int i = 0; i < people_->rowCount(); ++i)
    if (people_->at(i).id != attempt->person_id) names += QString::fromStdString(people_->at(i).name);
  bool ok = false;
  const QString name = QInputDialog::getItem(page_, tr("Whose attempt is it?"), tr("Choose a person or type a new name"), names, 0, true, &ok)
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

}  // namespace swage::console
