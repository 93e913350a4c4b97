// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Printed report of a group: a table of its people, and by how many of them each lesson of the course is passed.
#pragma once

#include <QString>
#include <QStringList>
#include <QVector>

#include "console/models/group_rows.hpp"

namespace swage::console {

struct GroupReport {
  QString title;        // of the group, or "5 people"
  QString course;       // "" for all lessons
  QStringList lessons;  // titles of the course's lessons, in its order
  QVector<GroupRow> rows;
};

class Sheet;

/// Draws the report from where the sheet is.
void draw_group(Sheet& sheet, const GroupReport& report);

/// Writes A4 pages for printing in grey: one page for up to about thirty people. Returns "" or the error.
QString write_group_report(const GroupReport& report, const QString& file);

/// "12 people, 3 of whom need attention. 40 of 96 lessons passed. Median of the last scores: 82."
QString group_words(const GroupReport& report);

}  // namespace swage::console
