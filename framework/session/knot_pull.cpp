// SPDX-License-Identifier: Apache-2.0
#include "session/knot_pull.hpp"

#include "host/units.hpp"

namespace swage::session {

std::unique_ptr<Rehearsal> open_pull(const KnotCopy& copy, const PullOptions& options, base::Problems& problems) {
  Options lesson;
  lesson.lesson_path = options.lesson_path;
  lesson.plugin_dirs = options.plugin_dirs;
  lesson.settings = copy.settings;
  lesson.settings.push_back("lesson.load=" + host::format_quantity(options.load, "N"));
  if (options.friction > 0) lesson.settings.push_back("itself.friction=" + host::format_number(options.friction));
  return Rehearsal::open(lesson, "expert", problems);
}

Pulled pulled(const Rehearsal& pull) {
  const host::Rig& rig = pull.rig();
  const judge::Verdict& verdict = pull.engine().verdict();
  Pulled out;
  out.over = verdict.outcome != judge::Outcome::kRunning;
  out.holds = verdict.outcome == judge::Outcome::kPassed;
  if (verdict.outcome == judge::Outcome::kFailed && verdict.reason < rig.script.events.size()) out.reason = rig.script.events[verdict.reason].id;
  for (std::size_t i = 0; i < rig.script.metrics.size(); ++i) {
    if (rig.script.metrics[i].id == "pull.bears") out.bears = verdict.metric[i];
    if (rig.script.metrics[i].id == "pull.slip") out.slip = verdict.metric[i];
  }
  out.health = base::text(pull.engine().stats().health);
  return out;
}

}  // namespace swage::session
