// SPDX-License-Identifier: Apache-2.0
//
// swage pull: pulls a copy of a knot of a kept attempt.
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "host/units.hpp"
#include "record/recorder.hpp"
#include "session/knot_pull.hpp"
#include "session/playback.hpp"
#include "tools/places.hpp"
#include "tools/print.hpp"
#include "tools/sentences.hpp"
#include "tools/verbs.hpp"

namespace swage::tools {
namespace {

void print_text(const session::KnotCopy& copy, const session::Pulled& result, const session::PullOptions& asked, double friction) {
  const std::string what = say::kPulledKnot(copy.word, copy.thread, quantity_text(copy.loop, "m"), format("%.3g", friction));
  const std::string slip = quantity_text(result.slip, "m");
  const std::string came = result.holds ? say::kKnotHolds(quantity_text(asked.load, "N"), slip)
                           : result.reason == "failed.broke" ? say::kKnotBroke(quantity_text(result.bears, "N"), slip)
                                                             : say::kKnotSlips(quantity_text(result.bears, "N"), slip);
  std::printf("%s\n%s\n", printable(what).c_str(), came.c_str());
  if (!result.health.empty()) tell(base::Severity::kWarning, session::kPullLesson, result.health);
}

}  // namespace

int pull(const PullVerbOptions& o) {
  record::Recording recording;
  std::string id, error;
  if (!load_attempt(o.what, o.store, recording, id, error)) return problem(error);
  base::Problems problems;
  const auto playback = session::Playback::open(recording, o.plugin_dirs, problems);
  tell(problems);
  if (!playback) return kProblem;
  const double dt = playback->rig().world.dt;
  const uint64_t to = o.at_s < 0 ? playback->count() : static_cast<uint64_t>(std::llround(o.at_s / dt));
  if (to > playback->count()) return problem(say::kNoSuchMoment(format("%.3f", static_cast<double>(playback->count()) * dt)));
  while (!playback->toward(to, playback->count())) {}

  problems.clear();
  session::KnotCopy copy;
  session::PullOptions options{pull_lesson(), o.plugin_dirs, o.load, o.friction};
  if (options.lesson_path.empty()) return problem(say::kNoFile(session::kPullLesson));
  std::unique_ptr<session::Rehearsal> test;
  if (session::copy_knot(playback->rig(), playback->engine().world(), copy, problems)) test = session::open_pull(copy, options, problems);
  tell(problems);
  if (!test) return kProblem;
  while (test->step()) {}
  const session::Pulled result = session::pulled(*test);
  const double friction = o.friction > 0 ? o.friction : copy.friction;
  if (o.json)
    print({{"attempt", id.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(id)},
           {"lesson", recording.info.lesson_id},
           {"at_s", static_cast<double>(to) * dt},
           {"knot", copy.word},
           {"loop_m", copy.loop},
           {"friction", friction},
           {"load_N", o.load},
           {"holds", result.holds},
           {"reason", result.reason},
           {"bears_N", number(result.bears)},
           {"slip_m", number(result.slip)}});
  else
    print_text(copy, result, options, friction);
  return result.holds ? kPassed : kNotPassed;
}

}  // namespace swage::tools
