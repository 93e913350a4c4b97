// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The edits of the People page: dialogs and confirmations, whose results go to the desk.
#pragma once

#include <QHash>
#include <QObject>
#include <QWidget>

#include "console/link/school_desk.hpp"
#include "console/models/people_model.hpp"

namespace swage::console {

class PeopleEdits : public QObject {
  Q_OBJECT
 public:
  /// `page`: parent of the dialogs. All outlive the edits.
  PeopleEdits(const PeopleModel* people, SchoolDesk* desk, QWidget* page);
  /// Groups that can be chosen, name by id.
  void set_groups(const QHash<QString, QString>& groups) { groups_ = groups; }

  void add_person();
  void add_list();
  /// `id`: of a person.
  void change_person(const QString& id);
  void erase_person(const QString& id);
  /// Assigns a course to these people, or to the group of the person `of`.
  void assign_course(const std::vector<std::string>& people, const QString& of);
  /// Makes the attempt void, or valid again; nullptr: nothing.
  void void_attempt(const record::AttemptRow* attempt);
  void give_attempt(const record::AttemptRow* attempt);

 Q_SIGNALS:
  /// A new person is to be selected.
  void added(const QString& name);

 private:
  QStringList taken_names(const QString& but = {}) const;

  const PeopleModel* people_;
  SchoolDesk* desk_;
  QWidget* page_;
  QHash<QString, QString> groups_;
};

}  // namespace swage::console
