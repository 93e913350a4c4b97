// SPDX-License-Identifier: Apache-2.0
//
// A pasted list of people: one name per line, or CSV with a head "name, group, hand, code" in any order; without a head that is the
// order. The result for each line is known before anything is written. The console reads heads and encodings by the same functions. [main]
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

/// Meaning of a column; kFirst and kLast make a name together.
enum class ListColumn { kName, kFirst, kLast, kGroup, kHand, kCode, kOther };
struct ListHead {
  std::vector<ListColumn> columns;    // empty: the line is no head
  std::vector<std::string> left_out;  // titles of columns that are not known
  bool has_name = false;              // false: nobody can be read below this head
};
/// Reads the fields of a first line. It is a head where a field says "name", "first name", "student"... or the first of several fields
/// titles another column.
ListHead read_list_head(const std::vector<std::string>& fields);
/// Order of columns without a head.
std::vector<ListColumn> usual_columns();

/// Text of a file as UTF-8, without a byte order mark; bytes that are not UTF-8 are taken for Windows-1252, as spreadsheets write it:
/// `told` then has a sentence for the person. False with a sentence in `error` for any other encoding.
bool decode_list(const std::string& bytes, std::string& text, std::string& told, std::string& error);

/// False with a sentence when the text is not a list: its head has no name. `told`: columns that are left out, as sentences.
bool read_people(const std::string& text, std::span<const Person> known, std::span<const Group> groups,
                 std::vector<ListedPerson>& out, std::string& error, std::vector<std::string>* told = nullptr);

/// Adds new people of the list, and missing groups; none when a line has a problem. Returns the number added, -1 on failure.
int add_people(School& school, std::span<ListedPerson> list, std::string& error);

}  // namespace swage::record
