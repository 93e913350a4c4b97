// SPDX-License-Identifier: Apache-2.0
#include "session/knot_test.hpp"

#include <cmath>
#include <filesystem>

#include "session/sentences.hpp"

namespace swage::session {
namespace {

std::string beside(const host::Rig& rig) { return (std::filesystem::path(rig.descriptor_path).parent_path() / kPullLesson).string(); }

}  // namespace

KnotTest::KnotTest(const host::Rig& rig, const scene::World& world, const std::string& lesson, const std::vector<std::string>& plugin_dirs)
    : rig_(rig) {
  KnotCopy copy;
  Problems found;
  if (copy_knot(rig, world, copy, found))
    pull_ = open_pull(copy, {lesson.empty() ? beside(rig) : lesson, plugin_dirs, rig.pull.load, 0}, found);
  if (pull_) return;
  for (const Problem& p : found) problems_.push_back({base::Severity::kWarning, p.where, say::kNotPulled(p.message)});
}

bool KnotTest::step(uint64_t most) {
  for (uint64_t n = 0; n < most; ++n)
    if (!pull_ || !pull_->step()) return false;
  return true;
}

PullProgress KnotTest::progress() const {
  const double bears = pull_ ? pulled(*pull_).bears : 0;
  return {std::isfinite(bears) ? bears : 0, rig_.pull.load};
}

void KnotTest::tell(Result& out) const {
  out.problems.insert(out.problems.end(), problems_.begin(), problems_.end());
  if (!pull_) return;
  const Pulled came = pulled(*pull_);
  if (!came.over) return;
  // a knot that slips before its loop bears anything has borne nothing
  const double bears = std::isfinite(came.bears) ? came.bears : 0;
  Result::Metric* const metric = &out.metrics[rig_.first_pull_metric];
  metric[judge::kPullBears].value = bears;
  metric[judge::kPullSlip].value = came.slip;
  metric[judge::kPullPoints].value = judge::points_lost(rig_.pull, bears);
  out.score = judge::score_after_pull(rig_.pull, out.score, bears);
  if (!came.health.empty()) out.problems.push_back({base::Severity::kWarning, kPullLesson, came.health});
}

}  // namespace swage::session
