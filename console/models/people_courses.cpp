// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/people_courses.hpp"

#include <QCoreApplication>
#include <QDate>
#include <QLocale>
#include <algorithm>

#include "console/models/words.hpp"

namespace swage::console {
namespace {

class CourseWords {
  Q_DECLARE_TR_FUNCTIONS(people_courses)
};

bool is_for(const record::Assignment& a, const record::Person& p) { return a.who_id == (a.to_group ? p.group_id : p.id); }

}  // namespace

QHash<QString, QString> courses_of(record::School& school, const std::vector<record::Person>& people) {
  QHash<QString, QString> out, titles;
  for (const record::Course& c : school.courses())
    if (c.archived_utc.empty()) titles.insert(QString::fromStdString(c.id), QString::fromStdString(c.title));
  const std::vector<record::Assignment> all = school.assignments();
  const auto add = [&](const record::Person& person, const record::Assignment& a) {
    const QString title = titles.value(QString::fromStdString(a.course_id));
    if (title.isEmpty()) return;
    const QDate due = QDate::fromString(QString::fromStdString(a.due_utc).left(10), Qt::ISODate);
    const QString words =
        due.isValid() ? CourseWords::tr("%1, until %2").arg(title, date_text(due)) : title;
    QString& known = out[QString::fromStdString(person.id)];
    if (!known.contains(title)) known += (known.isEmpty() ? QString() : QStringLiteral("; ")) + words;
  };
  for (const bool to_group : {false, true})
    for (const record::Assignment& a : all) {
      if (a.to_group != to_group) continue;
      for (const record::Person& p : people)
        if (is_for(a, p)) add(p, a);
    }
  return out;
}

std::vector<record::Course> courses_of_any(record::School& school, const std::vector<record::Person>& people) {
  const std::vector<record::Assignment> all = school.assignments();
  std::vector<record::Course> out;
  for (const record::Course& c : school.courses()) {
    const auto for_one = [&](const record::Assignment& a) {
      return a.course_id == c.id && std::any_of(people.begin(), people.end(), [&](const record::Person& p) { return is_for(a, p); });
    };
    if (c.archived_utc.empty() && std::any_of(all.begin(), all.end(), for_one)) out.push_back(c);
  }
  return out;
}

}  // namespace swage::console
