// SPDX-License-Identifier: Apache-2.0
//
// swage run: one attempt at a lesson.
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "assembly/lesson_file.hpp"
#include "host/nearest.hpp"
#include "host/units.hpp"
#include "judge/metrics.hpp"
#include "record/address.hpp"
#include "record/recorder.hpp"
#include "record/school.hpp"
#include "session/session.hpp"
#include "tools/places.hpp"
#include "tools/print.hpp"
#include "tools/ratings.hpp"
#include "tools/school_verbs.hpp"
#include "tools/sentences.hpp"
#include "tools/verbs.hpp"

namespace swage::tools {
namespace {

using Json = nlohmann::ordered_json;

std::atomic<int> interrupts{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may touch nothing else");

// Interrupting a group of processes often reaches a process twice (from a terminal and from timeout(1) alike), so the second
// signal must not lose the attempt. The third one ends the program in any state.
void on_signal(int number) {
  constexpr char kPatience[] =
      "The attempt is being kept. Interrupt once more to end at once; it is then recovered at the next "
      "start.\n";
  const int now = ++interrupts;
  if (now == 2) [[maybe_unused]]
    const auto n = write(STDERR_FILENO, kPatience, sizeof kPatience - 1);
  if (now < 3) return;
  signal(number, SIG_DFL);
  raise(number);
}

// While an object of this class exists, Ctrl-C and kill end the attempt, which is then stored, and not the program.
class Interruptible {
 public:
  Interruptible() {
    interrupts = 0;
    struct sigaction action {};
    action.sa_handler = on_signal;
    sigaction(SIGINT, &action, &old_int_);
    sigaction(SIGTERM, &action, &old_term_);
  }
  ~Interruptible() {
    sigaction(SIGINT, &old_int_, nullptr);
    sigaction(SIGTERM, &old_term_, nullptr);
  }
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

 private:
  struct sigaction old_int_ {
  }, old_term_{};
};

// replaces this program by the console with the same options; returns when there is no console
void open_window(const RunOptions& o) {
  const std::string console = beside("swage-console");
  if (console.empty() || !has_display()) {
    tell(base::Severity::kNote, "",
         console.empty() ? say::kNoConsole() : say::kNoDisplay());
    return;
  }
  std::vector<std::string> arguments = {o.lesson};
  const auto pass = [&](const char* option, const std::string& value) {
    if (!value.empty()) arguments.insert(arguments.end(), {option, value});
  };
  pass("--device", o.device);
  pass("--person", o.person == "Guest" ? "" : o.person);
  pass("--store", o.store);
  pass("--mode", o.mode);
  for (const std::string& dir : o.plugin_dirs) pass("--plugin-dir", dir);
  become(console, arguments);
  tell(base::Severity::kWarning, console, say::kNoWindow());
}

// true, with an error printed, for a pointer device without a time limit: headless, such an attempt would never end
bool needs_window(const RunOptions& o, const snapshot::SceneCard& card) {
  if (o.max_time_s > 0) return false;
  const auto mouse = std::find_if(card.devices.begin(), card.devices.end(),
                                  [](const auto& d) { return (d.flags & SWAGE_DEVICE_POINTER) != 0; });
  if (mouse == card.devices.end()) return false;
  std::vector<std::string> hands;
  assembly::LessonFile file;
  base::Problems ignored;
  assembly::read_lesson_file(o.lesson, file, ignored);
  for (const assembly::LessonDevice& device : file.devices)
    for (const assembly::DeviceChoice& choice : device.choices)
      if (!choice.as.empty() && choice.plugin != mouse->plugin) hands.push_back(choice.as);
  tell(base::Severity::kError, o.lesson,
       say::kIsMouse(mouse->name, hands.empty() ? "" : " (" + host::join(hands) + ")"));
  return true;
}

// reports once that the lesson waits for a lost hand, which only the console shows otherwise
void tell_of_lost_hand(const session::Session& session, bool& told) {
  static snapshot::Snapshot now;  // large
  if (told || !session.latest(now) || now.paused == 0) return;
  for (uint32_t i = 0; i < now.n_device && !told; ++i) {
    if (now.device[i].stale == 0) continue;
    tell(base::Severity::kWarning, session.card().devices[i].name,
         say::kHandLost());
    told = true;
  }
}

// pulls the knot of a passed attempt, with progress on a terminal
void pull_knot(session::Session& session) {
  constexpr uint64_t kSteps = 100;  // between two looks at the signals
  session::PullProgress now;
  while (interrupts == 0 && session.pull_knot(kSteps, now)) progress(say::kBeingPulled(quantity_text(now.bears, "N"), quantity_text(now.load, "N")));
  progress("");
}

void drive(session::Session& session) {
  session.start();
  bool told = false;
  for (int look = 0; !session.finished() && interrupts == 0; ++look) {
    usleep(5'000);
    if (look % 40 == 39) tell_of_lost_hand(session, told);
  }
  if (interrupts != 0) tell(base::Severity::kNote, "", say::kInterrupted());
  pull_knot(session);
  session.stop();
}

std::string loop_text(const snapshot::LoopHealth& h, bool fast) {
  std::string text =
      format("%llu steps, mean %.3f ms of processor time, 99 %% within %.2f ms, 99.9 %% within %.2f ms, worst %.2f ms",
             static_cast<unsigned long long>(h.executed), 1e3 * h.mean_step_cpu_s, 1e3 * h.p99_step_cpu_s,
             1e3 * h.p999_step_cpu_s, 1e3 * h.worst_step_s);
  if (!fast)
    text += format("; %llu late, %llu overrun, %llu dropped, %s", static_cast<unsigned long long>(h.late),
                   static_cast<unsigned long long>(h.overrun), static_cast<unsigned long long>(h.dropped),
                   h.realtime != 0 ? "real-time scheduling" : "no real-time scheduling (see swage doctor)");
  if (h.quarantined > 0) text += format("; %u in quarantine", h.quarantined);
  return text;
}

std::string kept_text(const session::Result& r, const std::string& store) {
  if (r.not_kept) return "NOT KEPT: nothing of this attempt is in the store";
  if (r.attempt_id.empty()) return "not kept";
  std::string text = "kept as attempt " + r.attempt_id + " in ";
  text += r.kept_beside.empty() ? record::shown(store)
                                : r.kept_beside + ", until " + record::shown(store) + " can be written again";
  if (r.missing_steps > 0)
    text += format("; %llu steps are missing in it", static_cast<unsigned long long>(r.missing_steps));
  return text;
}

void print_text(const RunOptions& o, const snapshot::SceneCard& card, const session::Result& r,
                const std::string& store) {
  std::printf("%s (%s)\n", printable(card.title).c_str(), printable(card.lesson_id).c_str());
  for (const auto& d : card.devices)
    std::printf("  %s: %s %s\n", printable(d.name).c_str(), printable(d.plugin).c_str(),
                printable(d.plugin_version).c_str());
  std::printf("%s", judge::text(r.outcome));
  if (!r.reason.empty()) std::printf(": %s", printable(r.reason).c_str());
  std::printf(", score %s of 100, after %.3f s\n", host::format_number(std::round(10 * r.score) / 10).c_str(),
              r.simulated_s);
  for (const auto& m : r.metrics) {
    std::printf("  %-20s %-14s %s\n", printable(m.id).c_str(),
                printable(std::isfinite(m.value) ? quantity_text(m.value, m.unit) : "not reported").c_str(), printable(m.doc).c_str());
  }
  const std::string ratings = ratings_text(r.outcome, judge::metrics_of(r.metrics));
  if (!ratings.empty()) std::printf("on scales of surgeons, as far as the state of the scene decides them:\n%s", ratings.c_str());
  std::printf("loop: %s\n", loop_text(r.health, o.fast).c_str());
  if (r.health.solver.steps > 0)
    std::printf("solver: fell short in %llu steps: %s (what that means: guide/realtime.md)\n",
                static_cast<unsigned long long>(r.health.solver.steps), base::text(r.health.solver).c_str());
  if (const std::string left_out = base::text(r.health.visuals); !left_out.empty()) std::printf("drawing: %s\n", left_out.c_str());
  std::printf("%s\n", kept_text(r, store).c_str());
}

Json solver_json(const base::SolverHealth& health) {
  Json out = {{"steps", health.steps}};
  for (const auto& field : base::kSolverHealthFields) out[field.id] = health.*field.count;
  return out;
}

Json visuals_json(const base::DrawingHealth& h, const snapshot::SceneCard& card) {
  Json out = Json::object();
  for (const auto& field : base::kDrawingHealthFields) out[field.id] = h.*field.count;
  if (h.faulty == 0) return out;
  const bool named = h.object < card.objects.size();
  out["first"] = {{"object", named ? Json(card.objects[h.object].name) : Json(nullptr)},
                  {"coupling", h.coupling == base::kNoCoupling ? Json(nullptr) : Json(h.coupling)},
                  {"index", h.index},
                  {"kind", base::visual_kind(h.kind)},
                  {"member", base::visual_member(h.member)}};
  return out;
}

Json loop_json(const snapshot::LoopHealth& h, const snapshot::SceneCard& card) {
  return {{"executed", h.executed},
          {"late", h.late},
          {"overrun", h.overrun},
          {"dropped", h.dropped},
          {"worst_wake_s", number(h.worst_wake_s)},
          {"worst_step_s", number(h.worst_step_s)},
          {"mean_step_cpu_s", number(h.mean_step_cpu_s)},
          {"p99_step_cpu_s", number(h.p99_step_cpu_s)},
          {"p999_step_cpu_s", number(h.p999_step_cpu_s)},
          {"realtime", h.realtime != 0},
          {"quarantined", h.quarantined},
          {"solver", solver_json(h.solver)},
          {"visuals", visuals_json(h.visuals, card)}};
}

void print_json(const snapshot::SceneCard& card, const session::Result& r, const std::string& store) {
  Json out = {{"lesson", card.lesson_id}, {"title", card.title}};
  out["devices"] = Json::array();
  for (const auto& d : card.devices)
    out["devices"].push_back({{"name", d.name}, {"plugin", d.plugin}, {"version", d.plugin_version}});
  out["outcome"] = judge::text(r.outcome);
  out["reason"] = r.reason;
  out["score"] = number(r.score);
  out["simulated_s"] = number(r.simulated_s);
  out["steps"] = r.steps;
  out["hash"] = format("%016llx", static_cast<unsigned long long>(r.hash));
  out["metrics"] = Json::array();
  for (const auto& m : r.metrics)
    out["metrics"].push_back({{"id", m.id}, {"value", number(m.value)}, {"unit", m.unit}, {"doc", m.doc}});
  out["ratings"] = ratings_json(r.outcome, judge::metrics_of(r.metrics));
  out["loop"] = loop_json(r.health, card);
  out["attempt"] = r.attempt_id.empty() ? Json(nullptr) : Json(r.attempt_id);
  out["store"] = r.attempt_id.empty() ? Json(nullptr) : Json(record::shown(store));
  out["kept_beside"] = r.kept_beside.empty() ? Json(nullptr) : Json(r.kept_beside);
  out["missing_steps"] = r.missing_steps;
  out["speed"] = number(r.speed);
  out["forces_off_s"] = number(r.forces_off_s);
  out["problems"] = to_json(r.problems);
  print(out);
}

// prints the problems of a run that was refused
int refused(const RunOptions& o, const base::Problems& problems) {
  tell(problems);
  if (o.json) print({{"problems", to_json(problems)}});
  return kProblem;
}

// Enters a person whom nobody knows: otherwise the attempt would make one whose code is the name, and exports would say it.
void enter_person(const RunOptions& o) {
  assembly::LessonFile lesson;
  base::Problems told_later;
  if (o.person == record::kGuest || o.person.empty() || o.store == ":none:") return;
  if (!assembly::read_lesson_file(o.lesson, lesson, told_later)) return;
  if (o.mode == "demo" || (o.mode.empty() && lesson.mode == "demo")) return;  // nothing is kept
  std::string error;
  const auto school = record::School::open(store_place(o.store), error);
  record::Person person;
  if (school && school->find_person(o.person, person)) return;
  person.name = o.person;
  if (school && school->add_person(person)) return tell(base::Severity::kNote, "", say::kNewHere(person.name, person.code));
  tell(base::Severity::kWarning, "", say::kNotEntered(o.person, school ? school->error() : error));
}

}  // namespace

int run(const RunOptions& o) {
  if (!o.headless) open_window(o);
  if (o.lesson.ends_with(".swage"))
    return problem(say::kIsAttempt(o.lesson, o.lesson, o.lesson));
  session::Options options;
  options.lesson_path = o.lesson;
  options.plugin_dirs = o.plugin_dirs;
  options.pull_lesson = pull_lesson();
  options.device = o.device;
  options.device_params = o.device_params;
  options.settings = o.settings;
  options.person = o.person;
  options.store_path = o.store;
  options.mode = o.mode;
  options.pace = o.fast ? session::Pace::kFastest : session::Pace::kRealtime;
  options.safe_mode = o.safe_mode;
  options.max_time_s = o.max_time_s;

  const Interruptible while_it_runs;
  enter_person(o);
  base::Problems problems;
  const std::unique_ptr<session::Session> session = session::Session::open(options, problems);
  if (!session || base::failed(problems)) return refused(o, problems);
  tell(problems);
  if (needs_window(o, session->card())) return kProblem;

  drive(*session);
  const session::Result result = session->result();
  tell(result.problems);
  const bool traced = o.trace.empty() || write_trace(o.trace, store_place(o.store), result.attempt_id);
  if (o.json)
    print_json(session->card(), result, store_place(o.store));
  else
    print_text(o, session->card(), result, store_place(o.store));
  if (!traced) return kProblem;
  if (result.not_kept) return kProblem;
  return result.outcome == judge::Outcome::kPassed ? kPassed : kNotPassed;
}

}  // namespace swage::tools
