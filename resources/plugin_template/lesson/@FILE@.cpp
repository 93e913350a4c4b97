// SPDX-License-Identifier: Apache-2.0
#include "@FILE@.hpp"

#include <swage/eigen.hpp>

#include <algorithm>

// [main] Declares all outputs of the lesson. Ids are meanings; the console gives them colours, shapes and sounds.
void @NAME@::build(const @NAME@Params&, Builder& builder) {
  builder.state<State>();
  time_ = builder.metric("time.task", "s", "Time until the object had stayed at the target.");
  nearest_ = builder.metric("reach.nearest", "m", "Smallest distance from the target.");
  there_ = builder.cue(cues[0]);
  away_ = builder.cue(cues[1]);
  late_ = builder.event("failed.out_of_time", "Time ran out.");
  reach_ = builder.phase("reach", "Bring the object to the target.");
  hold_ = builder.phase("hold", "Keep it there.");
}

// [main] Finds the object to watch; reports one that is missing.
void @NAME@::bind(const swage::Scene& scene, swage::Binder& binder) {
  object_ = scene.find_object(params().object);
  if (object_ == swage::kNone) return binder.error("There is no object \"" + params().object + "\" in the scene.");
  if (scene->object[object_].n_body == 0) return binder.error("\"" + params().object + "\" has no body to watch.");
  body_ = scene->object[object_].first_body;
  target_ = binder.mark_point(params().target, params().tolerance, "target.point");
}

// [rt] Observes one step and judges it.
void @NAME@::observe(const swage::View& view, const swage::Verdict& verdict, std::span<double> state) {
  State& mine = as<State>(state);
  const double distance = (swage::vec(view.pose(body_).p) - swage::vec(params().target)).norm();
  const bool there = distance <= params().tolerance;
  mine.held = there ? mine.held + view.dt() : 0;
  mine.nearest = std::min(mine.nearest, distance);

  verdict.cue(object_, there ? there_ : away_);
  verdict.mark(target_, there ? there_ : away_);
  verdict.phase(there ? hold_ : reach_);
  verdict.metric(time_, view.time());
  verdict.metric(nearest_, mine.nearest);
  if (there && mine.held >= params().hold_time) verdict.pass(100);
  if (view.time() > params().max_time) verdict.fail(late_);
}

// [rt] Called before the first step and at each restart of the attempt.
void @NAME@::reset(std::span<double> state) { as<State>(state) = {0, 1e3}; }

SWAGE_EXPORT(@NAME@)
