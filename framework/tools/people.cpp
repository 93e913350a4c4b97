// SPDX-License-Identifier: Apache-2.0
//
// swage people: the trainees and their groups.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <pwd.h>

#include "host/nearest.hpp"
#include "record/address.hpp"
#include "record/erase.hpp"
#include "record/identity.hpp"
#include "record/people_list.hpp"
#include "tools/places.hpp"
#include "tools/print.hpp"
#include "tools/school_verbs.hpp"
#include "tools/sentences.hpp"

namespace swage::tools {
namespace {

using Json = nlohmann::ordered_json;

// creates a missing store, to add a person
std::unique_ptr<record::School> open(const std::string& store) {
  std::string error;
  auto school = record::School::open(store_place(store), error);
  if (!school) problem(error);
  return school;
}

bool find(record::School& school, const std::string& who, record::Person& out) {
  if (school.find_person(who, out)) return true;
  std::vector<std::string> names;
  const std::string why = school.error();
  for (const record::Person& p : school.people()) names.push_back(p.name);
  problem(why + host::did_you_mean(who, names));
  return false;
}

std::string group_name(const std::vector<record::Group>& groups, const std::string& id) {
  for (const record::Group& g : groups)
    if (g.id == id) return g.name;
  return "";
}

// finds the group of that name or creates it; false with the reason printed
bool find_group(record::School& school, const std::string& name, std::string& id) {
  for (const record::Group& g : school.groups())
    if (g.name == name) return id = g.id, true;
  record::Group made{"", name, "", ""};
  if (!school.add_group(made)) return problem(school.error()), false;
  id = made.id;
  return true;
}

Json person_json(const record::Person& p, const std::vector<record::Group>& groups) {
  return {{"id", p.id},
          {"code", p.code},
          {"name", p.name},
          {"handedness", p.handedness},
          {"group", group_name(groups, p.group_id)},
          {"created_utc", p.created_utc},
          {"archived", !p.archived_utc.empty()},
          {"attempts", p.attempts}};
}

int said(const record::Person& p, record::School& school, bool json) {
  if (json)
    print(person_json(p, school.groups()));
  else
    std::printf("%s  %s\n", printable(p.code).c_str(), printable(p.name).c_str());
  return kPassed;
}

bool read_list(const std::string& file, std::string& text) {
  if (file == "-") {
    text.assign(std::istreambuf_iterator<char>(std::cin), {});
    return true;
  }
  std::ifstream in(file, std::ios::binary);
  text.assign(std::istreambuf_iterator<char>(in), {});
  return in.good() || in.eof();
}

}  // namespace

std::string user_name() {
  const passwd* user = getpwuid(geteuid());
  return user != nullptr ? user->pw_name : "somebody";
}

std::unique_ptr<record::School> existing_school(const std::string& where) {
  std::string error;
  const bool there = existing_store(where, error) != nullptr;
  auto school = there ? record::School::open(where, error) : nullptr;
  if (!school) problem(error);
  return school;
}

int list_people(const PeopleOptions& o) {
  const auto school = existing_school(store_place(o.store));
  if (!school) return kProblem;
  const std::vector<record::Group> groups = school->groups();
  std::vector<record::Person> people = school->people();
  if (!school->error().empty()) return problem(school->error());
  std::erase_if(people, [&](const record::Person& p) {
    return (!o.archived && !p.archived_utc.empty()) || (!o.group.empty() && group_name(groups, p.group_id) != o.group);
  });
  Json list = Json::array();
  for (const record::Person& p : people) {
    list.push_back(person_json(p, groups));
    if (!o.json)
      std::printf("%-8s %-28s %-6s %-20s %6u attempts%s\n", printable(p.code).c_str(), printable(p.name).c_str(), p.handedness.c_str(),
                  printable(group_name(groups, p.group_id)).c_str(), p.attempts, p.archived_utc.empty() ? "" : "  archived");
  }
  if (o.json) print(list);
  if (!o.json && people.empty()) std::printf("no one here yet: swage people add NAME\n");
  return kPassed;
}

int add_person(const PeopleOptions& o) {
  const auto school = open(o.store);
  if (!school) return kProblem;
  record::Person p;
  p.name = o.name;
  p.code = o.code;
  p.handedness = o.handedness;
  if (!o.group.empty() && !find_group(*school, o.group, p.group_id)) return kProblem;
  if (!school->add_person(p)) return problem(school->error());
  return said(p, *school, o.json);
}

int edit_person(const PeopleOptions& o) {
  const auto school = existing_school(store_place(o.store));
  record::Person p;
  if (!school || !find(*school, o.who, p)) return kProblem;
  if (!o.name.empty()) p.name = o.name;
  if (!o.handedness.empty()) p.handedness = o.handedness;
  if (!o.group.empty() && !find_group(*school, o.group, p.group_id)) return kProblem;
  if (!school->change_person(p)) return problem(school->error());
  return said(p, *school, o.json);
}

int import_people(const PeopleOptions& o) {
  std::string bytes, text, encoding, error;
  if (!read_list(o.file, bytes)) return problem(say::kNotRead(o.file));
  if (!record::decode_list(bytes, text, encoding, error)) return problem(say::kOfFile(o.file, error));
  if (!encoding.empty()) tell(base::Severity::kWarning, o.file, encoding);
  const auto school = open(o.store);
  if (!school) return kProblem;
  std::vector<record::ListedPerson> list;
  std::vector<std::string> left_out;
  if (!record::read_people(text, school->people(), school->groups(), list, error, &left_out)) return problem(say::kOfFile(o.file, error));
  for (const std::string& column : left_out) tell(base::Severity::kWarning, o.file, column);
  int added = static_cast<int>(std::count_if(list.begin(), list.end(), [](const auto& p) { return !p.is_there && p.problem.empty(); }));
  const bool faulty = std::any_of(list.begin(), list.end(), [](const auto& p) { return !p.problem.empty(); });
  if (!o.dry_run || faulty)
    if (added = record::add_people(*school, list, error); added < 0) return problem(say::kOfFile(o.file, error));
  Json rows = Json::array();
  for (const record::ListedPerson& p : list) {
    rows.push_back({{"line", p.line}, {"name", p.person.name}, {"code", p.person.code}, {"group", p.group}, {"added", !p.is_there && !o.dry_run}, {"there", p.is_there}});
    if (!o.json)
      std::printf("%4zu  %-28s %s\n", p.line, printable(p.person.name).c_str(),
                  p.is_there ? "is there already" : o.dry_run ? "would be added" : p.person.code.c_str());
  }
  if (o.json)
    print(rows);
  else
    std::printf("%d of %zu %s\n", added, list.size(), o.dry_run ? "would be added" : "added");
  return kPassed;
}

int archive_person(const PeopleOptions& o) {
  const auto school = existing_school(store_place(o.store));
  record::Person p;
  if (!school || !find(*school, o.who, p)) return kProblem;
  p.archived_utc = o.back ? "" : record::utc_now();
  if (!school->change_person(p)) return problem(school->error());
  return said(p, *school, o.json);
}

int erase_person(const PeopleOptions& o) {
  const auto school = existing_school(store_place(o.store));
  record::Person p;
  if (!school || !find(*school, o.who, p)) return kProblem;
  if (o.confirm != p.name && o.confirm != p.code)
    return problem(say::kFinal(p.name, p.attempts, p.name));
  // files first: if that fails, it can be repeated while the person is in the store
  Json files = Json::array();
  bool all = true;
  for (const record::ExportedFile& e : school->exported_files(p.id)) {
    const record::Cleaned cleaned = record::erase_from_file(e, p);
    files.push_back({{"file", e.file}, {"done", cleaned.done}, {"said", cleaned.sentence}});
    all &= cleaned.done;
    if (!cleaned.done) tell(base::Severity::kWarning, "", cleaned.sentence);
    if (cleaned.done && !o.json) std::printf("%s\n", printable(cleaned.sentence).c_str());
  }
  if (!school->erase_person(p.id)) return problem(school->error());
  if (o.json)
    print({{"erased", p.code}, {"attempts", p.attempts}, {"files", files}});
  else
    std::printf("%s and %u attempts were erased\n", printable(p.code).c_str(), p.attempts);
  return all ? kPassed : kNotPassed;
}

}  // namespace swage::tools
