// SPDX-License-Identifier: Apache-2.0
//
// swage: one program with verbs. Its window is swage-console.
#include <fcntl.h>
#include <locale.h>
#include <signal.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <functional>

#include "host/nearest.hpp"
#include "session/bounded_call.hpp"
#include "tools/print.hpp"
#include "tools/school_verbs.hpp"
#include "tools/sensor_verbs.hpp"
#include "tools/sentences.hpp"
#include "tools/verbs.hpp"

namespace {

using namespace swage::tools;

// all options of the command line
struct Arguments {
  RunOptions run;
  StudyOptions study;
  ReplayOptions replay;
  PullVerbOptions pull;
  ValidateOptions validate;
  DescribeOptions describe;
  WordsOptions words;
  NewOptions make_new;
  AuditOptions audit;
  DoctorOptions doctor;
  BenchOptions bench;
  AttemptsOptions attempts;
  NeedleOptions needle;
  SimulateSensorOptions simulate_sensor;
  CalibrateOptions calibrate;
  std::function<int()> chosen;
};

void plugin_dirs(CLI::App* verb, std::vector<std::string>& dirs) {
  verb->add_option("--plugin-dir", dirs, "Folder of plugins, before all others; may be repeated")
      ->allow_extra_args(false);
}

void add_run(CLI::App& app, Arguments& a) {
  CLI::App* verb = app.add_subcommand("run", "Run a lesson once and say how it went");
  RunOptions& o = a.run;
  verb->add_option("lesson", o.lesson, "Lesson file (.json)")->required();
  verb->add_option("--device", o.device, "Hand: a name of the lesson (expert), a plugin (mouse)");
  verb->add_option("--device-params", o.device_params, "Parameters of that device, a JSON object");
  verb->add_option("--set", o.settings,
                   "Another value than the file's: needle.arc=2/8, seed=7; may be repeated")
      ->allow_extra_args(false);
  verb->add_flag("--headless", o.headless, "Without a window");
  verb->add_flag("--as-fast-as-possible", o.fast, "Without a clock; gives the same numbers every time");
  verb->add_option("--person", o.person, "Whose attempt it is")->capture_default_str();
  verb->add_option("--store", o.store, "Attempts database, or :none: to keep nothing");
  verb->add_option("--mode", o.mode,
                   "practice (limits of force and time are told and end nothing, but for a hand of the lesson, which is judged as in a "
                   "test), test (they end the attempt; no cues) or demo (the expert's hand, not kept); what the lesson says, else test")
      ->check(CLI::IsMember({"practice", "test", "demo"}));
  verb->add_flag("--safe-mode", o.safe_mode, "Only the plugins that came with Swage");
  verb->add_option("--max-time", o.max_time_s, "Simulated seconds after which the attempt ends")
      ->check(CLI::Validator(
          [](std::string& text) {
            return std::atof(text.c_str()) > 0 ? "" : say::kNoTime(text);
          },
          "SECONDS"));
  verb->add_flag("--json", o.json, "The result as JSON");
  verb->add_option("--trace", o.trace, "CSV file for every signal of every step; the attempt must be kept");
  plugin_dirs(verb, o.plugin_dirs);
  verb->final_callback([&] { a.chosen = [&] { return run(a.run); }; });
}

void add_study(CLI::App& app, Arguments& a) {
  CLI::App* verb =
      app.add_subcommand("study", "Run a lesson over a matrix of variants and hands, or reaction laws over one recorded hand, and draw the figures");
  verb->add_option("study", a.study.file, "Study file (.json)")->required();
  verb->add_option("--set", a.study.settings,
                   "Another value than the lesson's, in every attempt: needle.level=bending; may be repeated")
      ->allow_extra_args(false);
  verb->add_option("--out", a.study.out, "Folder for figures (SVG) and all attempts (CSV)");
  CLI::Option* shard = verb->add_option("--shard", a.study.shard, "Only a part of the attempts: 2/8 does every eighth, from the second");
  verb->add_flag("--merge", a.study.merge, "Run nothing: table and figures of what the shards have left in the folder")->excludes(shard);
  verb->add_option("--store", a.study.store, "Attempts database that keeps them; none unless given");
  plugin_dirs(verb, a.study.plugin_dirs);
  verb->final_callback([&] { a.chosen = [&] { return study(a.study); }; });
}

void add_replay(CLI::App& app, Arguments& a) {
  CLI::App* verb = app.add_subcommand("replay", "Step a kept attempt again and compare every hash");
  verb->add_option("attempt", a.replay.what, "Attempt id or its beginning, \"last\", or a .swage file")
      ->required();
  verb->add_option("--store", a.replay.store, "Attempts database");
  verb->add_flag("--grade", a.replay.grade,
                 "Let the lesson of today judge it (\"all\": every attempt), and keep that beside what was said");
  verb->add_flag("--json", a.replay.json, "The result as JSON");
  plugin_dirs(verb, a.replay.plugin_dirs);
  verb->final_callback([&] { a.chosen = [&] { return replay(a.replay); }; });
}

void add_pull(CLI::App& app, Arguments& a) {
  CLI::App* verb = app.add_subcommand("pull", "Pull a copy of a knot of a kept attempt: does it hold?");
  PullVerbOptions& o = a.pull;
  verb->add_option("attempt", o.what, "Attempt id or its beginning, \"last\", or a .swage file")->required();
  verb->add_option("--at", o.at_s, "Moment of the attempt [s]; its end unless given")->check(CLI::NonNegativeNumber);
  verb->add_option("--load", o.load, "What the loop is to bear [N]")->capture_default_str()->check(CLI::Range(1e-3, 10.0));
  verb->add_option("--friction", o.friction, "Of the thread on itself; as in the attempt unless given")->check(CLI::Range(1e-3, 3.0));
  verb->add_option("--store", o.store, "Attempts database");
  verb->add_flag("--json", o.json, "The result as JSON");
  plugin_dirs(verb, o.plugin_dirs);
  verb->final_callback([&] { a.chosen = [&] { return pull(a.pull); }; });
}

void add_audit(CLI::App& app, Arguments& a) {
  CLI::App* verb =
      app.add_subcommand("audit", "Play lessons at every level of detail and say which is enough");
  AuditOptions& o = a.audit;
  verb->add_option("lessons", o.lessons, "Lesson files (.json)");
  verb->add_flag("--series", o.series, "Every lesson that comes with Swage");
  verb->add_option("--out", o.out, "Folder for tables (CSV, Markdown) and chart (SVG)");
  verb->add_flag("--add", o.add, "Keep the lessons that --out has from an earlier audit: a long one in pieces");
  verb->add_option("--only", o.only, "One ladder, as needle.level; may be repeated")->allow_extra_args(false);
  verb->add_option("--device", o.device, "Hand that plays them")->capture_default_str();
  verb->add_option("--tolerance", o.tolerance, "Relative difference that still counts as equal")
      ->capture_default_str()
      ->check(CLI::Range(1e-6, 1.0));
  verb->add_option("--max-time", o.max_time_s, "Simulated seconds after which a run ends")
      ->capture_default_str()
      ->check(CLI::Range(0.001, 86400.0));
  verb->add_option("--budget", o.budget_s, "Seconds of processor time after which a run is called too slow")
      ->capture_default_str()
      ->check(CLI::Range(0.001, 86400.0));
  verb->add_flag("--json", o.json, "The result as JSON");
  plugin_dirs(verb, o.plugin_dirs);
  verb->final_callback([&] { a.chosen = [&] { return audit(a.audit); }; });
}

void add_validate(CLI::App& app, Arguments& a) {
  CLI::App* verb = app.add_subcommand("validate", "Test plugins and check lesson files");
  ValidateOptions& o = a.validate;
  verb->add_option("paths", o.paths, "Bundles, libraries (.so) or lesson files (.json)")->required();
  verb->add_option("--strictness", o.strictness, "Tests up to this level")
      ->check(CLI::Range(1, 10))
      ->capture_default_str();
  verb->add_option("--only", o.only, "One test by its name");
  verb->add_option("--seed", o.seed, "Of the random tests")->capture_default_str();
  verb->add_option("--with", o.with, "Lesson file: the plugins are tested in its scene")->check(CLI::ExistingFile);
  verb->add_option("--limit", o.limit_s, "Seconds that one test may take, of processor time or of waiting: more for a plugin built with a sanitizer")
      ->check(CLI::Range(0.1, 86400.0))
      ->capture_default_str();
  verb->add_flag("--in-process", o.in_process, "No child processes and no time limit: for a debugger");
  verb->add_flag("--json", o.json, "The result as JSON");
  plugin_dirs(verb, o.plugin_dirs);
  verb->final_callback([&] { a.chosen = [&] { return validate(a.validate); }; });
}

void add_describe(CLI::App& app, Arguments& a) {
  CLI::App* verb = app.add_subcommand("describe", "Say what a plugin is and which parameters it has");
  DescribeOptions& o = a.describe;
  verb->add_option("plugin", o.what, "Plugin id or path of a bundle; none: everything that is installed");
  verb->add_option("--with", o.with, "Lesson file: its scene says which signals and events there are, and what starts inside what")->check(CLI::ExistingFile);
  verb->add_flag("--schema", o.schema, "JSON Schema, for editors; without a plugin that of lesson files");
  verb->add_flag("--markdown", o.markdown, "The table of a README");
  verb->add_flag("--json", o.json, "As JSON");
  plugin_dirs(verb, o.plugin_dirs);
  verb->final_callback([&] { a.chosen = [&] { return describe(a.describe); }; });
}

void add_words(CLI::App& app, Arguments& a) {
  CLI::App* verb = app.add_subcommand("words", "List what a lesson or plugin says and has no translation for, as a file to fill in");
  WordsOptions& o = a.words;
  verb->add_option("what", o.what, "Lesson files (with all plugins that they use), bundles, ids of plugins")->required();
  verb->add_option("--language", o.language, "Two letters: de, fr, hi")->capture_default_str();
  verb->add_flag("--all", o.all, "What is translated, too");
  plugin_dirs(verb, o.plugin_dirs);
  verb->final_callback([&] { a.chosen = [&] { return words(a.words); }; });
}

void add_new(CLI::App& app, Arguments& a) {
  CLI::App* verb = app.add_subcommand("new", "Start a plugin or lesson of your own");
  NewOptions& o = a.make_new;
  verb->add_option("kind", o.kind, "object, flexible (an object that stretches and bends), coupling, device, hardware (a device with a driver) or lesson")->required();
  verb->add_option("id", o.id, "Reverse domain, lower case: org.example.clip")->required();
  verb->add_option("--name", o.name, "Name of the class; the last word of the id unless given");
  verb->add_option("--dir", o.dir, "Folder to make; the last word of the id unless given");
  verb->final_callback([&] { a.chosen = [&] { return make_new(a.make_new); }; });
}

void add_doctor(CLI::App& app, Arguments& a) {
  CLI::App* verb = app.add_subcommand("doctor", "Say what this machine grants and what to mend");
  verb->add_option("--store", a.doctor.store, "Attempts database");
  verb->add_flag("--json", a.doctor.json, "As JSON");
  plugin_dirs(verb, a.doctor.plugin_dirs);
  verb->final_callback([&] { a.chosen = [&] { return doctor(a.doctor); }; });
}

void add_bench(CLI::App& app, Arguments& a) {
  CLI::App* verb = app.add_subcommand("bench", "Measure speed and accuracy");
  verb->add_option("which", a.bench.which, "charts, stability or bar")->required();
  verb->prefix_command();
  verb->final_callback([&a, verb] {
    a.bench.rest = verb->remaining();
    a.chosen = [&a] { return bench(a.bench); };
  });
}

void add_attempts(CLI::App& app, Arguments& a) {
  CLI::App* verb = app.add_subcommand("attempts", "List, export, name, void, import, back up and salvage what the store keeps");
  AttemptsOptions& o = a.attempts;
  verb->require_subcommand(1);
  const auto common = [&](CLI::App* sub, int (*what)(const AttemptsOptions&)) {
    sub->add_option("--store", o.store, "Attempts database");
    sub->add_flag("--json", o.json, "As JSON");
    sub->final_callback([&a, what] { a.chosen = [&a, what] { return what(a.attempts); }; });
  };
  CLI::App* list = verb->add_subcommand("list", "Newest first");
  list->add_option("--person", o.person, "Only this person's");
  list->add_option("--lesson", o.lesson, "Only of this lesson id");
  common(list, list_attempts);
  CLI::App* in = verb->add_subcommand("import", "Files into the store; what is there already stays");
  in->add_option("files", o.files, "Files that were exported")->required();
  common(in, import_attempts);
  CLI::App* save = verb->add_subcommand("backup", "The whole store, file or server, into one file");
  save->add_option("file", o.file, "File to write")->required();
  save->add_flag("--force", o.force, "A file that is there is replaced, once the new one is whole");
  common(save, backup_attempts);
  CLI::App* back = verb->add_subcommand("restore", "What a backup holds into the store; what is there already stays");
  back->add_option("file", o.file, "File that \"backup\" has written")->required();
  common(back, restore_attempts);
  CLI::App* rescue = verb->add_subcommand("salvage", "A new store of what a damaged one still holds");
  rescue->add_option("--to", o.file,
                     "File of the new store; unless given it takes the place of the damaged one, which is kept beside it");
  common(rescue, salvage_store);
}

void add_needle(CLI::App& app, Arguments& a) {
  CLI::App* verb = app.add_subcommand("needle", "List the library of needles, and bend one on the bench");
  NeedleOptions& o = a.needle;
  verb->require_subcommand(1);
  const auto common = [&](CLI::App* sub, int (*what)(const NeedleOptions&)) {
    sub->add_flag("--json", o.json, "As JSON");
    sub->final_callback([&a, what] { a.chosen = [&a, what] { return what(a.needle); }; });
  };
  common(verb->add_subcommand("list", "Every needle of the library with its strength"), list_needles);
  CLI::App* bench =
      verb->add_subcommand("bench", "Bending test of ASTM F1874, squeeze and ductility, beside closed forms");
  bench->add_option("--model", o.model, "Needle of the library, or a file of its format")
      ->capture_default_str();
  bench->add_option("--pieces", o.pieces, "Arcs of the bending needle")
      ->check(CLI::Range(2, 48))
      ->capture_default_str();
  bench->add_option("--width", o.width_mm, "Of the flat jaws, mm")
      ->check(CLI::Range(0.05, 10.0))
      ->capture_default_str();
  common(bench, bench_needle);
}

void add_simulate_sensor(CLI::App& app, Arguments& a) {
  CLI::App* verb = app.add_subcommand("simulate-sensor", "A jaw sensor on a pseudo terminal, until Ctrl-C; says its port first");
  SimulateSensorOptions& o = a.simulate_sensor;
  verb->add_option("--link", o.link, "Name at which the port can be found");
  verb->add_option("--script", o.script, "breathe, or a table of rows \"s, V\"")->capture_default_str();
  verb->add_option("--serial", o.serial, "Serial number that it says")->capture_default_str();
  verb->add_option("--rate", o.rate_hz, "Measurements per second")->check(CLI::Range(1.0, 2000.0))->capture_default_str();
  verb->add_option("--seconds", o.seconds, "How long; 0: until Ctrl-C")->check(CLI::NonNegativeNumber);
  verb->add_option("--drift", o.drift, "Relative error of its clock")->check(CLI::Range(-0.01, 0.01));
  verb->add_option("--burst", o.burst_s, "s for which an adapter keeps bytes back; FTDI: 0.016")->check(CLI::Range(0.0, 1.0));
  verb->add_option("--corrupt-each", o.corrupt_each, "Every n-th message has a wrong bit");
  verb->add_option("--lose-each", o.lose_each, "Every n-th message is not sent");
  verb->add_option("--unplug-each", o.unplug_each_s, "s after which it is unplugged for a second, again and again")->check(CLI::NonNegativeNumber);
  verb->add_flag("--grip", o.grip, "Has a strain gauge, too");
  verb->final_callback([&] { a.chosen = [&] { return simulate_sensor(a.simulate_sensor); }; });
}

void add_calibrate(CLI::App& app, Arguments& a) {
  CLI::App* verb = app.add_subcommand("calibrate", "Say what a jaw sensor's volts mean");
  CalibrateOptions& o = a.calibrate;
  verb->require_subcommand(1);
  const auto common = [&](CLI::App* sub, int (*what)(const CalibrateOptions&)) {
    sub->add_option("--serial", o.serial, "Serial number of the sensor; it says it itself when it is plugged in");
    sub->final_callback([&a, what] { a.chosen = [&a, what] { return what(a.calibrate); }; });
  };
  const auto sensor = [&](CLI::App* sub) {
    sub->add_option("--port", o.port, "Port of the sensor; the only serial adapter unless given");
    sub->add_option("--bits-per-s", o.bits_per_s, "Of the port")->capture_default_str();
    sub->add_option("--seconds", o.seconds, "For which one value is averaged")->check(CLI::Range(0.05, 60.0))->capture_default_str();
    sub->add_option("--file", o.file, "Kept there instead of among the stored ones");
  };
  CLI::App* displacement = verb->add_subcommand("displacement", "Volts to millimetres: 13 points over 6 mm, once");
  displacement->add_option("--nominal", o.nominal_mm_per_v, "mm/V of the data sheet; 0: not known")->capture_default_str();
  displacement->add_option("--valid-days", o.valid_days, "After which it expires")->check(CLI::Range(1, 3650))->capture_default_str();
  CLI::App* force = verb->add_subcommand("force", "Travel to force at the handle: 5 to 11 points, once");
  CLI::App* tip = verb->add_subcommand("tip", "Force at the handle to force at the tips: 5 to 11 points, once");
  for (CLI::App* sub : {displacement, force, tip}) {
    sub->add_option("--table", o.table, "Rows \"mm, V\", \"mm, N\" or \"N, N\" of a bench, instead of a sensor");
    sub->add_option("--by", o.by, "Who calibrates");
    sub->add_option("--name", o.name, "Of the sensor");
    sensor(sub);
  }
  CLI::App* poses = verb->add_subcommand("poses", "Open, just closed, squeezed: 20 s, each session");
  poses->add_option("--a", o.a_mm, "mm from the pivot to one swivel");
  poses->add_option("--b", o.b_mm, "mm from the pivot to the other");
  poses->add_option("--gap", o.gap_mm, "mm between the swivels when the jaws just meet");
  poses->add_flag("--another-needleholder", o.force_anyway, "The ways may differ from those of before");
  sensor(poses);
  CLI::App* zero = verb->add_subcommand("zero", "The handle let go: what it reads there is nothing; 5 s, when a session says so");
  sensor(zero);
  CLI::App* check = verb->add_subcommand("check", "A force at the tips, on a gauge with a real needle");
  check->add_option("--tip-force", o.tip_N, "N that the gauge shows")->check(CLI::Range(0.05, 10.0))->capture_default_str();
  check->add_option("--ratio", o.ratio, "N at the tips per N at the handle, where no table tells it")->check(CLI::Range(0.001, 10.0))->capture_default_str();
  sensor(check);
  CLI::App* show = verb->add_subcommand("show", "What is stored");
  show->add_flag("--json", o.json, "As JSON");
  common(displacement, calibrate_displacement);
  common(force, calibrate_force);
  common(tip, calibrate_tip);
  common(check, calibrate_check);
  common(poses, calibrate_poses);
  common(zero, calibrate_zero);
  common(show, calibrate_show);
}

// CLI11 reports a wrong verb as an unexpected argument; reports it as a wrong verb, with the nearest one
bool wrong_verb(const CLI::App& app, int argc, char** argv) {
  std::vector<std::string> verbs;
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; }))
    verbs.push_back(sub->get_name());
  if (verbs.empty() || (argc >= 2 && argv[1][0] == '-')) return false;
  const std::string name = app.get_name(),
                    has = say::kVerbs(swage::host::join(verbs));
  if (argc < 2) {
    problem(say::kSayVerb(name) + has);
    return true;
  }
  const std::string verb = argv[1];
  if (std::find(verbs.begin(), verbs.end(), verb) != verbs.end())
    return wrong_verb(*app.get_subcommand(verb), argc - 1, argv + 1);
  problem(say::kNoVerb(name, verb, swage::host::did_you_mean(verb, verbs)) + has);
  return true;
}

int parse_and_run(int argc, char** argv) {
  CLI::App app("Swage: an open microsurgery trainer. Exit codes: 0 good, 1 not passed, 2 a problem.",
               "swage");
  app.set_version_flag("--version", "swage " SWAGE_VERSION);
  app.require_subcommand(1);
  Arguments a;
  for (const auto add : {add_run, add_study, add_replay, add_pull, add_validate, add_audit, add_describe, add_words, add_new,
                         add_doctor, add_bench, add_attempts, add_needle, add_simulate_sensor, add_calibrate})
    add(app, a);
  add_school_verbs(app, a.chosen);
  std::vector<char*> words(argv, argv + argc);
  char help[] = "--help";
  // "help VERB" is "VERB --help", as people know it of other programs
  if (argc >= 2 && !strcmp(argv[1], "help")) {
    words.erase(words.begin() + 1);
    words.push_back(help);
  }
  if (wrong_verb(app, argc, words.data())) return kProblem;
  try {
    app.parse(argc, words.data());
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    const auto chosen = app.get_subcommands();
    return problem(say::kSeeHelp(error.what(), chosen.empty() ? "" : chosen[0]->get_name() + " "));
  }
  return a.chosen();
}

// Opens /dev/null for closed standard streams: a file opened later would get number 0, 1 or 2 and be overwritten by output.
void occupy_standard_streams() {
  int file = open("/dev/null", O_RDWR);
  while (file >= 0 && file <= STDERR_FILENO) file = open("/dev/null", O_RDWR);
  if (file >= 0) close(file);
}

}  // namespace

int main(int argc, char** argv) {
  occupy_standard_streams();
  // a file above the process's size limit is then reported as an error of that file and does not end the program
  signal(SIGXFSZ, SIG_IGN);
  // numbers are written with a decimal point, even if a plugin changes the locale of the process
  uselocale(newlocale(LC_ALL_MASK, "C", nullptr));
  try {
    return swage::session::end_program(parse_and_run(argc, argv));
  } catch (const std::exception& error) {
    return problem(say::kUnexpected(error.what()));
  }
}
