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

ListColumn column_of(const std::string& title) {
  static const std::vector<std::pair<ListColumn, std::vector<std::string>>> kTitles = {
      {ListColumn::kName, {"name", "full name", "trainee", "student"}},
      {ListColumn::kFirst, {"first name", "firstname", "given name", "vorname"}},
      {ListColumn::kLast, {"last name", "lastname", "surname", "family name", "nachname"}},
      {ListColumn::kGroup, {"group", "gruppe", "cohort", "class"}},
      {ListColumn::kHand, {"hand", "handedness"}},
      {ListColumn::kCode, {"id", "code", "pseudonym"}}};
  for (const auto& [column, titles] : kTitles)
    if (std::find(titles.begin(), titles.end(), lower(title)) != titles.end()) return column;
  return ListColumn::kOther;
}

bool is_name(ListColumn column) { return column <= ListColumn::kLast; }

std::string handedness(const std::string& said, std::string& problem) {
  const std::string s = lower(said);
  if (s.empty()) return "";
  for (const char* left : {"left", "links"})
    if (std::string(left).starts_with(s)) return "left";
  for (const char* right : {"right", "rechts"})
    if (std::string(right).starts_with(s)) return "right";
  problem = say::kNoHandedness(said);
  return "";
}

ListedPerson read_fields(const std::vector<std::string>& fields, const std::vector<ListColumn>& columns) {
  ListedPerson p;
  std::string last;
  if (fields.size() > columns.size()) p.problem = say::kManyFields(fields.size(), columns.size());
  for (std::size_t i = 0; i < std::min(fields.size(), columns.size()); ++i) {
    if (columns[i] == ListColumn::kName || columns[i] == ListColumn::kFirst) p.person.name = fields[i];
    if (columns[i] == ListColumn::kLast) last = fields[i];
    if (columns[i] == ListColumn::kCode) p.person.code = fields[i];
    if (columns[i] == ListColumn::kGroup) p.group = fields[i];
    if (columns[i] == ListColumn::kHand) p.person.handedness = handedness(fields[i], p.problem);
  }
  p.person.name = trimmed(p.person.name + " " + last);
  if (p.person.name.empty() && p.problem.empty()) p.problem = say::kNoName();
  return p;
}

// Length of the UTF-8 sequence at `at`, or 0.
std::size_t utf8_at(const std::string& s, std::size_t at) {
  const auto byte = [&](std::size_t i) { return i < s.size() ? static_cast<unsigned char>(s[i]) : 0U; };
  const unsigned lead = byte(at);
  const std::size_t n = lead < 0x80 ? 1 : lead >= 0xC2 && lead < 0xE0 ? 2 : lead >= 0xE0 && lead < 0xF0 ? 3 : lead >= 0xF0 && lead < 0xF5 ? 4 : 0;
  for (std::size_t i = 1; i < n; ++i)
    if ((byte(at + i) & 0xC0) != 0x80) return 0;
  return n;
}

// Code points of the bytes 0x80 to 0x9F in Windows-1252; 0: none.
constexpr unsigned kWindows[32] = {0x20AC, 0, 0x201A, 0x192, 0x201E, 0x2026, 0x2020, 0x2021, 0x2C6, 0x2030, 0x160, 0x2039, 0x152, 0, 0x17D, 0,
                                   0, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014, 0x2DC, 0x2122, 0x161, 0x203A, 0x153, 0, 0x17E, 0x178};

void append_utf8(std::string& out, unsigned code) {
  if (code < 0x80) return out.push_back(static_cast<char>(code));
  if (code >= 0x800) {
    out += static_cast<char>(0xE0 | (code >> 12));
    out += static_cast<char>(0x80 | ((code >> 6) & 0x3F));
  } else {
    out += static_cast<char>(0xC0 | (code >> 6));
  }
  out += static_cast<char>(0x80 | (code & 0x3F));
}

std::size_t line_of(const std::string& bytes, std::size_t at) {
  return 1 + static_cast<std::size_t>(std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

}  // namespace

ListHead read_list_head(const std::vector<std::string>& fields) {
  ListHead head;
  for (const std::string& title : fields) {
    head.columns.push_back(column_of(title));
    if (head.columns.back() == ListColumn::kOther && !title.empty()) head.left_out.push_back(title);
  }
  head.has_name = std::any_of(head.columns.begin(), head.columns.end(), is_name);
  const bool titled = fields.size() > 1 && head.columns.front() != ListColumn::kOther;
  return head.has_name || titled ? head : ListHead{};
}

std::vector<ListColumn> usual_columns() { return {ListColumn::kName, ListColumn::kGroup, ListColumn::kHand, ListColumn::kCode}; }

bool decode_list(const std::string& bytes, std::string& text, std::string& told, std::string& error) {
  text.clear();
  told.clear();
  const std::size_t start = bytes.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  if (const std::size_t zero = bytes.find('\0'); zero != std::string::npos) {
    error = say::kOtherText(line_of(bytes, zero));
    return false;
  }
  std::size_t bad = start;
  for (std::size_t n = 1; bad < bytes.size() && n > 0;)
    if (n = utf8_at(bytes, bad); n > 0) bad += n;
  if (bad >= bytes.size()) {
    text = bytes.substr(start);
    return true;
  }
  for (std::size_t i = start; i < bytes.size(); ++i) {
    const auto byte = static_cast<unsigned char>(bytes[i]);
    const unsigned code = byte >= 0x80 && byte < 0xA0 ? kWindows[byte - 0x80] : byte;
    if (code == 0) {
      error = say::kOtherText(line_of(bytes, i));
      return false;
    }
    append_utf8(text, code);
  }
  told = say::kWindowsText(line_of(bytes, bad));
  return true;
}

bool read_people(const std::string& text, std::span<const Person> known, std::span<const Group> groups,
                 std::vector<ListedPerson>& out, std::string& error, std::vector<std::string>* told) {
  out.clear();
  std::vector<ListColumn> columns;
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
      const ListHead head = read_list_head(fields);
      if (!head.columns.empty() && !head.has_name) {
        error = say::kHeadWithoutName(fields.front());
        return false;
      }
      for (const std::string& title : head.left_out)
        if (told != nullptr) told->push_back(say::kColumn(title));
      columns = head.columns.empty() ? usual_columns() : head.columns;
      if (!head.columns.empty()) continue;
    }
    ListedPerson p = read_fields(fields, columns);
    p.line = number;
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
