// SPDX-License-Identifier: Apache-2.0
//
// A pasted list of people: one name per line, or CSV with a head "name, code, handedness, group" in any order. The result
// for each line is known before anything is written. [main]
#pragma once

#include <span>
#include <string>
#include <vector>

#include "record/school.hpp"

namespace swage::record {

struct ListedPerson {
  std::size_t line = 0;  // from 1
  Person person;         // group_id is "" for a group that does not exist yet
  std::string group;     // name of the group
  bool is_there = false;  // the name or code is in the store, or in a line above: skipped
  std::string problem;    // a sentence; "" for a valid line
};

/// False with a sentence when the text is not a list: its head has an unknown column.
bool read_people(const std::string& text, std::span<const Person> known, std::span<const Group> groups,
                 std::vector<ListedPerson>& out, std::string& error);

/// Adds new people of the list, and missing groups; none when a line has a problem. Returns the number added, -1 on failure.
int add_people(School& school, std::span<ListedPerson> list, std::string& error);

}  // namespace swage::record
