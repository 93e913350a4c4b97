// SPDX-License-Identifier: Apache-2.0
//
// A list of people as it is pasted: one name a line, or CSV with a head "name, code, handedness, group" in any order. What would
// happen to each line is known before anything is written. [main]
#pragma once

#include <span>
#include <string>
#include <vector>

#include "record/school.hpp"

namespace swage::record {

struct ListedPerson {
  std::size_t line = 0;  // from 1 on
  Person person;         // group_id is "" for a group that is still to be made
  std::string group;     // name of the group
  bool is_there = false;  // somebody of that name or code is in the store, or stands above: left out
  std::string problem;    // a sentence; "" for a line that can be taken
};

/// False with a sentence when the text is no list at all: its head has a column that Swage does not know.
bool read_people(const std::string& text, std::span<const Person> known, std::span<const Group> groups,
                 std::vector<ListedPerson>& out, std::string& error);

/// Adds whom the list has new, and the groups that are missing; none when a line has a problem. Returns how many, -1 on failure.
int add_people(School& school, std::span<ListedPerson> list, std::string& error);

}  // namespace swage::record
