// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Which courses people have: their own, and those of their groups.
#pragma once

#include <QHash>
#include <QString>
#include <vector>

#include "record/school.hpp"

namespace swage::console {

/// The courses of each person, by id, with their dates: "Basic course, until 31/01/2030; Knots". A person's own courses come first.
QHash<QString, QString> courses_of(record::School& school, const std::vector<record::Person>& people);

/// Courses that are assigned to any of these people, each once; archived ones are left out.
std::vector<record::Course> courses_of_any(record::School& school, const std::vector<record::Person>& people);

}  // namespace swage::console
