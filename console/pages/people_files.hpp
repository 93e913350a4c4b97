// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Files of the People page: reports to print, of one person or of several, and a person's attempts as a table.
#pragma once

#include <QObject>
#include <QWidget>
#include <optional>

#include "console/link/school_desk.hpp"
#include "console/link/store_link.hpp"
#include "console/models/made_with.hpp"
#include "console/models/people_model.hpp"
#include "console/pages/person_panel.hpp"

namespace swage::console {

class PeopleFiles : public QObject {
  Q_OBJECT
 public:
  struct Sources {
    const PeopleModel* people;
    PersonPanel* person;  // of the person chosen last
    SchoolDesk* desk;
    StoreLink* store;
  };
  /// `page`: parent of the dialogs. All outlive the files.
  PeopleFiles(const Sources& from, QWidget* page);
  /// Reader of attempts for exports.
  void set_export(ExportReader reader) { exported_ = std::move(reader); }

  /// Each asks for a file, then writes a report: of the person that the panel shows and the lesson chosen there, one of `chosen` people; or
  /// a table of people, with a title, after the question about which course.
  void report(const QString& id, std::size_t chosen);
  void report_group(const std::vector<std::string>& people, const QString& title);
  void export_attempts(const QString& id);

  /// Each writes a file. Returns "" or the error. `id`: of the person that the panel shows.
  QString write_report_to(const QString& file, const QString& id);
  QString write_attempts_to(const QString& file, const QString& id);
  /// `course`: nullptr for all lessons.
  QString write_group_to(const QString& file, const std::vector<std::string>& people, const QString& title, const record::Course* course);

 Q_SIGNALS:
  /// Where a file was saved, or why not.
  void told(const QString& words);

 private:
  bool choose_course(const std::vector<record::Person>& people, std::optional<record::Course>& out);
  std::vector<record::Person> people_of(const std::vector<std::string>& ids) const;
  QString file_name(const QString& id, const QString& what, const QString& ending) const;
  std::vector<record::Exported> exported(const QString& id, const std::string& lesson_id);
  void tell(const QString& file, const QString& why, const std::vector<std::string>& people, const char* kind, const QString& more = {});

  Sources from_;
  QWidget* page_;
  ExportReader exported_;
};

}  // namespace swage::console
