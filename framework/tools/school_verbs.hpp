// SPDX-License-Identifier: Apache-2.0
//
// Verbs about people, courses and notes on attempts: people, courses, stations, and attempts void, name, note, export. [main]
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "record/school.hpp"
#include "tools/verbs.hpp"

namespace CLI {
class App;
}

namespace swage::tools {

struct PeopleOptions {
  std::string store, who, name, code, handedness, group, file, confirm;
  bool json = false, archived = false, back = false, dry_run = false;
};
int list_people(const PeopleOptions&);
int add_person(const PeopleOptions&);
int edit_person(const PeopleOptions&);
int import_people(const PeopleOptions&);
int archive_person(const PeopleOptions&);
int erase_person(const PeopleOptions&);

struct SyntheticOptions {
  std::string store;
  std::vector<std::string> lessons, plugin_dirs;
  uint32_t people = 30, attempts = 5000, recordings = 30;
  uint64_t seed = 1;
  bool json = false;
};
int make_synthetic_school(const SyntheticOptions&);

struct CourseOptions {
  std::string store, course, file, person, group, experts, due;
  std::vector<std::string> plugin_dirs;
  uint32_t attempts = 30;  // of each simulated trainee
  bool json = false, back = false;
};
int list_courses(const CourseOptions&);
int add_course(const CourseOptions&);
int show_course(const CourseOptions&);
int check_course(const CourseOptions&);
int assign_course(const CourseOptions&);
int archive_course(const CourseOptions&);
int course_progress(const CourseOptions&);

struct AttemptWords {
  std::string store, id, person, text, by, file, as = "swage", home, lesson;
  double at_s = 0;
  bool json = false, undo = false, trace = false, even_if_named = false;
};
int void_attempt(const AttemptWords&);
int name_attempt(const AttemptWords&);
int note_attempt(const AttemptWords&);
/// Exports one attempt or all, in the format `as`.
int export_attempts(const AttemptWords&);

struct SendOptions {
  std::string store, to, home, login_file, receipts;
  bool json = false;
};
/// Sends the statements of all attempts of people that were not sent yet to a Learning Record Store.
int send_attempts(const SendOptions&);

struct StationsOptions {
  std::string store;
  bool json = false;
};
/// Lists the present state of every station of the school.
int list_stations(const StationsOptions&);

/// Writes every signal and input of each step as CSV; `<file>.about.json` describes the attempt and the columns.
bool write_trace(const std::string& file, const std::string& store, const std::string& attempt_id);
/// Name of the account that runs the program, for a user who gives none.
std::string user_name();
/// The school of an existing store; nullptr with the reason printed.
std::unique_ptr<record::School> existing_school(const std::string& where);

/// Adds the verbs to the command line, some below "attempts", which must exist.
void add_school_verbs(CLI::App& app, std::function<int()>& chosen);

}  // namespace swage::tools
