// SPDX-License-Identifier: Apache-2.0
#include "record/people_list.hpp"

#include <algorithm>
#include <cctype>
#include <map>

#include "record/sentences.hpp"

namespace swage::record {
namespace {

std::string trimmed(const std::string& s) {
  const auto from = s.find_first_not_of(" \t\r"), to = s.find_last_not_of(" \t\r");
  return from == std::string::npos ? "" : s.substr(from, to - from + 1);
}

std::string lower(std::string s) {
  for (char& c : s) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return s;
}

// Fields of one line: RFC 4180 without line ends in fields. Many spreadsheets separate by semicolon or tab.
std::vector<std::string> fields_of(const std::string& line, char separator) {
  std::vector<std::string> out(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
      out.back() += line[++i];
    else if (c == '"')
      quoted = !quoted;
    else if (c == separator && !quoted)
      out.emplace_back();
    else
      out.back() += c;
  }
  for (std::string& f : out) f = trimmed(f);
  return out;
}

char separator_of(const std::string& line) {
  for (const char c : {'\t', ';', ','})
    if (line.find(c) != std::string::npos) return c;
  return ',';
}

const std::vector<std::string> kPeopleColumns = {"name", "code", "handedness", "group"};

// Meaning of each column; empty when the line is not a head.
bool read_head(const std::vector<std::string>& fields, std::vector<std::string>& columns, std::string& error) {
  const auto is_column = [](const std::string& f) { return std::find(kPeopleColumns.begin(), kPeopleColumns.end(), lower(f)) != kPeopleColumns.end(); };
  if (!std::any_of(fields.begin(), fields.end(), [](const std::string& f) { return lower(f) == "name"; })) return true;
  for (const std::string& f : fields) {
    if (!is_column(f)) {
      error = say::kColumn(f);
      return false;
    }
    columns.push_back(lower(f));
  }
  return true;
}

std::string handedness(const std::string& said, std::string& problem) {
  const std::string s = lower(said);
  if (s.empty() || s == "left" || s == "right") return s;
  if (s == "l" || s == "r") return s == "l" ? "left" : "right";
  problem = say::kNoHandedness(said);
  return "";
}

}  // namespace

bool read_people(const std::string& text, std::span<const Person> known, std::span<const Group> groups,
                 std::vector<ListedPerson>& out, std::string& error) {
  out.clear();
  std::vector<std::string> columns;
  std::vector<Person> there(known.begin(), known.end());
  std::size_t number = 0, from = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  bool first = true;
  while (from < text.size()) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    const std::string line = trimmed(text.substr(from, end - from));
    from = end + 1;
    ++number;
    if (line.empty()) continue;
    const std::vector<std::string> fields = fields_of(line, separator_of(line));
    if (std::exchange(first, false)) {
      if (!read_head(fields, columns, error)) return false;
      if (!columns.empty()) continue;
      columns = kPeopleColumns;
    }
    ListedPerson p;
    p.line = number;
    if (fields.size() > columns.size()) p.problem = say::kManyFields(fields.size(), columns.size());
    for (std::size_t i = 0; i < std::min(fields.size(), columns.size()); ++i) {
      if (columns[i] == "name") p.person.name = fields[i];
      if (columns[i] == "code") p.person.code = fields[i];
      if (columns[i] == "group") p.group = fields[i];
      if (columns[i] == "handedness") p.person.handedness = handedness(fields[i], p.problem);
    }
    if (p.person.name.empty() && p.problem.empty()) p.problem = say::kNoName();
    for (const Group& g : groups)
      if (g.name == p.group) p.person.group_id = g.id;
    p.is_there = std::any_of(there.begin(), there.end(), [&](const Person& other) {
      return other.name == p.person.name || (!p.person.code.empty() && other.code == p.person.code);
    });
    if (p.problem.empty()) there.push_back(p.person);
    out.push_back(std::move(p));
  }
  return true;
}

int add_people(School& school, std::span<ListedPerson> list, std::string& error) {
  for (const ListedPerson& p : list)
    if (!p.problem.empty()) {
      error = say::kOfLine(p.line, p.problem);
      return -1;
    }
  std::map<std::string, std::string> groups;
  for (const Group& g : school.groups()) groups[g.name] = g.id;
  int added = 0;
  for (ListedPerson& p : list) {
    if (p.is_there) continue;
    if (!p.group.empty() && !groups.contains(p.group)) {
      Group g{"", p.group, "", ""};
      if (!school.add_group(g)) {
        error = school.error();
        return -1;
      }
      groups[p.group] = g.id;
    }
    if (!p.group.empty()) p.person.group_id = groups[p.group];
    if (!school.add_person(p.person)) {
      error = "Line " + std::to_string(p.line) + ": " + school.error();
      return -1;
    }
    ++added;
  }
  return added;
}

}  // namespace swage::record
