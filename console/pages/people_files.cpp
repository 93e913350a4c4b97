// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/people_files.hpp"

#include <QInputDialog>
#include <QSaveFile>

#include "console/models/people_courses.hpp"
#include "console/models/said.hpp"
#include "console/models/words.hpp"
#include "console/report/group_report.hpp"
#include "console/report/person_report.hpp"
#include "console/widgets/save_file.hpp"

namespace swage::console {

PeopleFiles::PeopleFiles(const Sources& from, QWidget* page) : QObject(page), from_(from), page_(page) {}

QString PeopleFiles::file_name(const QString& id, const QString& what, const QString& ending) const {
  const int row = from_.people->row_of(id);
  return row < 0 ? QString() : QStringLiteral("%1_%2%3").arg(QString::fromStdString(from_.people->at(row).code), what, ending);
}

// lesson_id "": at all lessons
std::vector<record::Exported> PeopleFiles::exported(const QString& id, const std::string& lesson_id) {
  std::vector<record::Exported> out;
  std::string error;
  if (!exported_) return out;
  if (!exported_({}, {id.toStdString(), lesson_id, {}}, out, error)) Q_EMIT told(tr("▲ %1").arg(said_message(error)));
  return out;
}

// says the result, and logs what left the store
void PeopleFiles::tell(const QString& file, const QString& why, const std::vector<std::string>& people, const char* kind,
                       const QString& more) {
  if (why.isEmpty() && from_.desk->school()) from_.desk->school()->log_export(people, kind, file.toStdString());
  Q_EMIT told(why.isEmpty() ? tr("Saved to: %1").arg(file) + more : tr("▲ %1").arg(why));
}

QString PeopleFiles::write_report_to(const QString& file, const QString& id) {
  const int row = from_.people->row_of(id);
  if (row < 0) return tr("Nobody is chosen.");
  const record::Person& p = from_.people->at(row);
  const QVector<record::AttemptRow> shown = from_.person->attempts()->attempts();
  return write_report({QString::fromStdString(p.name), QString::fromStdString(p.code), from_.person->lesson_title(),
                       from_.people->standing(row), from_.person->chart()->series(), from_.person->bars()->bars(), shown,
                       shown.isEmpty() ? std::vector<record::Exported>() : exported(id, shown.front().lesson_id)},
                      file);
}

void PeopleFiles::report(const QString& id, std::size_t chosen) {
  const int row = from_.people->row_of(id);
  if (row < 0) return;
  const QString file = ask_save(page_, tr("Report"), file_name(id, QStringLiteral("report"), QStringLiteral(".pdf")), tr("Page (*.pdf)"));
  if (file.isEmpty()) return;
  const QString alone = tr("It is about %1 alone, one of the %2 people chosen.");
  const QString name = person_text(QString::fromStdString(from_.people->at(row).name));
  tell(file, write_report_to(file, id), {id.toStdString()}, "report", chosen > 1 ? QLatin1Char(' ') + alone.arg(name).arg(chosen) : QString());
}

void PeopleFiles::export_attempts(const QString& id) {
  if (from_.people->row_of(id) < 0) return;
  const QString file = ask_save(page_, tr("Export a person's attempts"), file_name(id, QStringLiteral("attempts"), QStringLiteral(".csv")),
                                tr("Table (*.csv)"));
  if (!file.isEmpty()) tell(file, write_attempts_to(file, id), {id.toStdString()}, "csv");
}

QString PeopleFiles::write_attempts_to(const QString& name, const QString& id) {
  QSaveFile file(name);
  const QByteArray text = QByteArray::fromStdString(record::csv_long(exported(id, {})));
  const bool ok = file.open(QIODevice::WriteOnly) && file.write(text) == text.size() && file.commit();
  return ok ? QString() : tr("%1 cannot be written: %2.").arg(name, file.errorString());
}

std::vector<record::Person> PeopleFiles::people_of(const std::vector<std::string>& ids) const {
  std::vector<record::Person> out;
  for (const std::string& id : ids)
    if (const int row = from_.people->row_of(QString::fromStdString(id)); row >= 0) out.push_back(from_.people->at(row));
  return out;
}

// Of the courses that these people have, or all lessons. Asks only where there is something to choose; false when the choice was left.
bool PeopleFiles::choose_course(const std::vector<record::Person>& people, std::optional<record::Course>& out) {
  record::School* school = from_.desk->school();
  const std::vector<record::Course> courses = school ? courses_of_any(*school, people) : std::vector<record::Course>();
  out.reset();
  if (courses.empty()) return true;
  QStringList titles;
  for (const record::Course& c : courses) titles += QString::fromStdString(c.title);
  titles += tr("All lessons");
  bool ok = false;
  const QString chosen = QInputDialog::getItem(page_, tr("Report"), tr("About which course?"), titles, 0, false, &ok);
  const auto at = static_cast<std::size_t>(titles.indexOf(chosen));
  if (ok && at < courses.size()) out = courses[at];
  return ok;
}

void PeopleFiles::report_group(const std::vector<std::string>& people, const QString& title) {
  std::optional<record::Course> course;
  if (people.empty() || !choose_course(people_of(people), course)) return;
  const QString file = ask_save(page_, tr("Report"), tr("%1_report.pdf").arg(title), tr("Page (*.pdf)"));
  if (!file.isEmpty()) tell(file, write_group_to(file, people, title, course ? &*course : nullptr), people, "report");
}

QString PeopleFiles::write_group_to(const QString& file, const std::vector<std::string>& people, const QString& title,
                                    const record::Course* course) {
  const std::shared_ptr<record::Store> store = from_.store->store();
  if (!store) return from_.store->problem();
  GroupReport report{title, course ? QString::fromStdString(course->title) : QString(), {}, {}};
  if (course)
    for (const record::CourseStep& step : course->steps) report.lessons += said(step.title.empty() ? step.lesson_id : step.title);
  const QDateTime now = QDateTime::currentDateTimeUtc();
  for (const record::Person& p : people_of(people)) report.rows += group_row(p, store->attempts(p.id), course, now);
  sort_by_attention(report.rows);
  return write_group_report(report, file);
}

}  // namespace swage::console
