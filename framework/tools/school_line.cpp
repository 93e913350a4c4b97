// SPDX-License-Identifier: Apache-2.0
//
// Command line of the verbs about people, courses and notes on attempts.
#include <CLI/CLI.hpp>

#include "tools/school_verbs.hpp"

namespace swage::tools {
namespace {

struct Options {
  PeopleOptions people;
  SyntheticOptions synthetic;
  CourseOptions courses;
  AttemptWords words;
  SendOptions send;
  StationsOptions stations;
};

// static, because the command line is parsed after add_school_verbs() has returned
Options& options() {
  static Options all;
  return all;
}

template <class Of>
void verb(CLI::App* sub, Of& o, int (*what)(const Of&), std::function<int()>& chosen) {
  sub->add_option("--store", o.store, "Attempts database");
  sub->add_flag("--json", o.json, "As JSON");
  sub->final_callback([&o, &chosen, what] { chosen = [&o, what] { return what(o); }; });
}

void add_people(CLI::App& app, std::function<int()>& chosen) {
  CLI::App* all = app.add_subcommand("people", "Who trains here: names, groups, a synthetic school");
  all->require_subcommand(1);
  PeopleOptions& o = options().people;
  const auto who = [&](CLI::App* sub) { sub->add_option("who", o.who, "Name or code")->required(); };
  const auto facts = [&](CLI::App* sub) {
    sub->add_option("--hand", o.handedness, "Handedness")->check(CLI::IsMember({"left", "right"}));
    sub->add_option("--group", o.group, "Group; made when there is none of that name");
  };
  CLI::App* list = all->add_subcommand("list", "By name");
  list->add_option("--group", o.group, "Only of this group");
  list->add_flag("--archived", o.archived, "Also those who no longer train");
  verb(list, o, list_people, chosen);
  CLI::App* add = all->add_subcommand("add", "Somebody; says the code under which the attempts are kept");
  add->add_option("name", o.name, "As it is shown here; it leaves this store nowhere")->required();
  add->add_option("--code", o.code, "Made unless given");
  facts(add);
  verb(add, o, add_person, chosen);
  CLI::App* edit = all->add_subcommand("edit", "Another name, hand or group");
  who(edit);
  edit->add_option("--name", o.name, "New name");
  facts(edit);
  verb(edit, o, edit_person, chosen);
  CLI::App* import = all->add_subcommand("import", "A list: one name a line, or CSV with a head of name, group, hand, code in any order");
  import->add_option("file", o.file, "File, or - for standard input")->required();
  import->add_flag("--dry-run", o.dry_run, "Only say what would be done");
  verb(import, o, import_people, chosen);
  CLI::App* archive = all->add_subcommand("archive", "Who no longer trains; the attempts stay");
  who(archive);
  archive->add_flag("--back", o.back, "Trains again");
  verb(archive, o, archive_person, chosen);
  CLI::App* erase = all->add_subcommand("erase", "A person with all attempts, for good, also out of files that were exported from this store");
  who(erase);
  erase->add_option("--confirm", o.confirm, "The name once more");
  verb(erase, o, erase_person, chosen);

  SyntheticOptions& s = options().synthetic;
  CLI::App* made = all->add_subcommand("synthetic", "A school that never was, for trying pages: every attempt is marked synthetic");
  made->add_option("--people", s.people, "A tenth of them experts")->check(CLI::Range(1u, 1000u))->capture_default_str();
  made->add_option("--attempts", s.attempts, "Of all together")->check(CLI::Range(1u, 1'000'000u))->capture_default_str();
  made->add_option("--recordings", s.recordings, "Newest attempts that can be opened")->check(CLI::Range(0u, 1000u))->capture_default_str();
  made->add_option("--seed", s.seed, "Of the drawn numbers")->capture_default_str();
  made->add_option("--lesson", s.lessons, "Lesson file with an expert and a novice; may be repeated")->allow_extra_args(false);
  made->add_option("--plugin-dir", s.plugin_dirs, "Folder of plugins, before all others; may be repeated")->allow_extra_args(false);
  verb(made, s, make_synthetic_school, chosen);
}

void add_courses(CLI::App& app, std::function<int()>& chosen) {
  CLI::App* all = app.add_subcommand("courses", "Lessons in order, what is asked of each, who has passed what");
  all->require_subcommand(1);
  CourseOptions& o = options().courses;
  const auto course = [&](CLI::App* sub) { sub->add_option("course", o.course, "Title")->required(); };
  verb(all->add_subcommand("list", "By title"), o, list_courses, chosen);
  CLI::App* add = all->add_subcommand("add", "From a file of format \"swage-course/1\"; one of the same title is changed");
  add->add_option("file", o.file, "Its steps name lessons by \"lesson\" (id) or by \"file\", whose text is then frozen")->required();
  verb(add, o, add_course, chosen);
  CLI::App* show = all->add_subcommand("show", "Its lessons, limits and rules; --json is such a file");
  course(show);
  verb(show, o, show_course, chosen);
  CLI::App* check = all->add_subcommand("check", "How often its rules pass a trainee who succeeds 5, 7 or 9 times in 10");
  course(check);
  check->add_option("--experts", o.experts, "Group or person: how many of their attempts meet all limits together");
  check->add_option("--attempts", o.attempts, "That a trainee makes, 10 a day")->check(CLI::Range(1u, 1000u))->capture_default_str();
  verb(check, o, check_course, chosen);
  CLI::App* assign = all->add_subcommand("assign", "To a group or a person");
  course(assign);
  CLI::Option* group = assign->add_option("--group", o.group, "Group");
  CLI::Option* person = assign->add_option("--person", o.person, "Name or code");
  group->excludes(person);
  assign->add_option("--due", o.due, "Date, 2030-01-31");
  verb(assign, o, assign_course, chosen);
  CLI::App* archive = all->add_subcommand("archive", "No longer offered; who has passed what stays");
  course(archive);
  archive->add_flag("--back", o.back, "Offered again");
  verb(archive, o, archive_course, chosen);
  CLI::App* progress = all->add_subcommand("progress", "Where everybody stands who has it");
  course(progress);
  progress->add_option("--person", o.person, "Only this one, assigned or not");
  verb(progress, o, course_progress, chosen);
}

void add_words(CLI::App& attempts, std::function<int()>& chosen) {
  AttemptWords& o = options().words;
  const auto attempt = [&](CLI::App* sub) {
    sub->add_option("attempt", o.id, "Attempt id or its beginning, or \"last\"")->required();
    sub->add_option("--by", o.by, "Who says so; the user of this machine unless given");
  };
  CLI::App* out = attempts.add_subcommand("export", "One attempt into one file, or many into a table");
  out->add_option("attempt", o.id, "Attempt id or its beginning, \"last\", or \"all\" for tables and statements")->required();
  out->add_option("file", o.file, "File to write; <id>.swage (.csv, .xapi.json) unless given");
  out->add_option("--as", o.as, "swage: all of it, to be imported; csv: a row per metric; csv-wide: a row per attempt; xapi: statements; trace: 1 kHz")
      ->check(CLI::IsMember({"swage", "csv", "csv-wide", "xapi", "trace"}))
      ->capture_default_str();
  out->add_flag("--trace", o.trace, "Every signal and input of each step, as CSV");
  out->add_option("--home", o.home, "Address of the school in xAPI identifiers: https://school.example.org");
  out->add_option("--person", o.person, "Only this person's");
  out->add_option("--lesson", o.lesson, "Only of this lesson id");
  verb(out, o, export_attempts, chosen);
  SendOptions& s = options().send;
  CLI::App* send = attempts.add_subcommand("send", "Statements of people's attempts to a Learning Record Store (xAPI), each once");
  send->add_option("--to", s.to, "Its address: https://lrs.example.org/xapi")->required();
  send->add_option("--home", s.home, "Address of the school in the identifiers: https://school.example.org")->required();
  send->add_option("--login", s.login_file, "File with one line, user:password");
  send->add_option("--receipts", s.receipts, "File that says what has arrived; beside the user's own store unless given");
  verb(send, s, send_attempts, chosen);
  CLI::App* no = attempts.add_subcommand("void", "Leave an attempt out of rules and curves; it is kept");
  attempt(no);
  no->add_option("--reason", o.text, "Why, for whoever reads it later")->required();
  no->add_flag("--undo", o.undo, "It counts again");
  verb(no, o, void_attempt, chosen);
  CLI::App* name = attempts.add_subcommand("name", "Give a guest's attempt to a person");
  attempt(name);
  name->add_option("person", o.person, "Name or code")->required();
  name->add_flag("--even-if-named", o.even_if_named, "Also another person's");
  verb(name, o, name_attempt, chosen);
  CLI::App* note = attempts.add_subcommand("note", "Pin words to a moment of an attempt, or read them");
  attempt(note);
  note->add_option("words", o.text, "The note; unless given, the notes are shown");
  note->add_option("--at", o.at_s, "s from the start")->capture_default_str();
  verb(note, o, note_attempt, chosen);
}

}  // namespace

void add_school_verbs(CLI::App& app, std::function<int()>& chosen) {
  add_people(app, chosen);
  add_courses(app, chosen);
  verb(app.add_subcommand("stations", "What every station of the school does now; they need one PostgreSQL store"), options().stations,
       list_stations, chosen);
  add_words(*app.get_subcommand("attempts"), chosen);
}

}  // namespace swage::tools
