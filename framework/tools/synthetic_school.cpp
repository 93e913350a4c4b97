// SPDX-License-Identifier: Apache-2.0
//
// swage people synthetic: scripted hands play a few lessons; the attempts of a whole school are drawn at random between their results.
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/scratch_folder.hpp"
#include "record/address.hpp"
#include "record/synthetic.hpp"
#include "session/session.hpp"
#include "tools/places.hpp"
#include "tools/print.hpp"
#include "tools/school_verbs.hpp"
#include "tools/sentences.hpp"

namespace swage::tools {
namespace {

constexpr uint64_t kNovices = 3;  // runs of the novice hand, whose spread gives that of the simulated beginners

constexpr double kTooShort = 0.6;  // time limit over the time of a passed attempt: no attempt passes within it

struct Played {
  std::string id;  // of the attempt; "": failed, with the reason printed
  double simulated_s = 0;
};

Played play(const SyntheticOptions& o, const std::string& lesson, const std::string& hand, uint64_t seed, const std::string& store,
            double max_time_s = 0) {
  session::Options options;
  options.lesson_path = lesson;
  options.plugin_dirs = o.plugin_dirs;
  options.device = hand;
  options.person = hand;
  options.store_path = store;
  options.mode = "test";
  options.pace = session::Pace::kFastest;
  options.settings = {"seed=" + std::to_string(seed)};
  if (max_time_s > 0) options.settings.push_back("lesson.max_time=" + std::to_string(max_time_s));
  base::Problems problems;
  const auto session = session::Session::open(options, problems);
  if (!session || base::failed(problems)) return tell(problems), Played();
  session->start();
  session->wait();
  const session::Result result = session->result();
  return {result.attempt_id, result.simulated_s};
}

}  // namespace

int make_synthetic_school(const SyntheticOptions& o) {
  std::vector<std::string> lessons = o.lessons, searched;
  const std::string series = data_folder("lessons/series", searched);
  if (lessons.empty() && !series.empty())
    for (const char* name : {"020_grasp_basic", "031_grasp_advanced_1_three_eighths", "110_insertion"}) lessons.push_back(series + "/" + name + ".json");
  if (lessons.empty()) return problem(say::kNoLessons());
  const base::ScratchFolder folder("synthetic");
  record::SyntheticSchool school;
  school.from = (folder.path() / "hands.db").string();
  school.people = o.people;
  school.attempts = o.attempts;
  school.recordings = o.recordings;
  school.seed = o.seed;
  for (const std::string& lesson : lessons) {
    progress("hands play " + lesson);
    record::SyntheticLesson played;
    played.expert = play(o, lesson, "expert", 1, school.from).id;
    for (uint64_t seed = 1; seed <= kNovices; ++seed) {
      const Played passed = play(o, lesson, "novice", seed, school.from);
      played.novices.push_back(passed.id);
      played.failed.push_back(play(o, lesson, "novice", seed, school.from, kTooShort * passed.simulated_s).id);
    }
    progress("");
    for (const std::string& id : played.novices)
      if (id.empty() || played.expert.empty()) return problem(say::kHandsFail(lesson));
    school.lessons.push_back(std::move(played));
  }
  std::string error;
  const std::string where = store_place(o.store);
  if (!record::write_synthetic_school(where, school, error)) return problem(error);
  if (o.json)
    print({{"store", record::shown(where)}, {"people", o.people}, {"attempts", o.attempts}, {"synthetic", true}});
  else
    std::printf("%u synthetic people with %u synthetic attempts are in %s\n", o.people, o.attempts, record::shown(where).c_str());
  return kPassed;
}

}  // namespace swage::tools
