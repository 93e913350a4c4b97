// SPDX-License-Identifier: Apache-2.0
//
// swage people synthetic: scripted hands really play a few lessons; a school's worth of attempts is drawn between them.
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/scratch_folder.hpp"
#include "record/address.hpp"
#include "record/synthetic.hpp"
#include "session/session.hpp"
#include "tools/places.hpp"
#include "tools/print.hpp"
#include "tools/school_verbs.hpp"

namespace swage::tools {
namespace {

constexpr uint64_t kNovices = 3;  // seeds of the novice hand: their spread is that of the drawn beginners

// The attempt's id, "" once told.
std::string play(const SyntheticOptions& o, const std::string& lesson, const std::string& hand, uint64_t seed, const std::string& store) {
  session::Options options;
  options.lesson_path = lesson;
  options.plugin_dirs = o.plugin_dirs;
  options.device = hand;
  options.person = hand;
  options.store_path = store;
  options.mode = "test";
  options.pace = session::Pace::kFastest;
  options.settings = {"seed=" + std::to_string(seed)};
  base::Problems problems;
  const auto session = session::Session::open(options, problems);
  if (!session || base::failed(problems)) return tell(problems), "";
  session->start();
  session->wait();
  return session->result().attempt_id;
}

}  // namespace

int make_synthetic_school(const SyntheticOptions& o) {
  std::vector<std::string> lessons = o.lessons, searched;
  const std::string series = data_folder("lessons/series", searched);
  if (lessons.empty() && !series.empty())
    for (const char* name : {"020_grasp_basic", "031_grasp_advanced_1_three_eighths", "110_insertion"}) lessons.push_back(series + "/" + name + ".json");
  if (lessons.empty()) return problem("No lessons are there: name some with --lesson.");
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
    played.expert = play(o, lesson, "expert", 1, school.from);
    for (uint64_t seed = 1; seed <= kNovices; ++seed) played.novices.push_back(play(o, lesson, "novice", seed, school.from));
    progress("");
    for (const std::string& id : played.novices)
      if (id.empty() || played.expert.empty()) return problem(lesson + ": its hands could not play it.");
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
