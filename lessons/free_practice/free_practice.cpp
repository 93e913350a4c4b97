// SPDX-License-Identifier: Apache-2.0
#include "free_practice.hpp"

#include <algorithm>
#include <iterator>

#include "common/names.hpp"
#include "sentences.hpp"

namespace swage::lesson_free_practice {
namespace {

using lessons::names_in;
using toolkit::Vec3;

}  // namespace

void FreePractice::build(const PracticeParams& params, LessonBuilder& builder) {
  params_ = params;
  drop_ = lessons::DropWatch(params.drop_distance);
  const size_t n = names_in(params.things).size();
  if (n == 0 || n > kMostThings) builder.error("things", say::kThingsNamed());
  if (static_cast<size_t>(params.goal) > n) builder.error("goal", say::kFewThings());

  builder.state<PracticeMemory>();
  held_ = builder.cue(kCues[0]);
  practice_ = builder.phase("practice", "Pick up each object and put it down.");
  done_ = builder.phase("done", "The attempt is over.");
  dropped_ =
      builder.event("thing.dropped", "A thing has left where it was let go or lay; value: which, from 0.");
  grasped_ =
      builder.event("thing.grasped", "A thing has been held long enough for the first time; value: which.");
  out_of_time_ = builder.event("failed.out_of_time", "Time ran out before the goal was reached.");
  Metric* const order[] = {&metric_.time,  &metric_.touches,   &metric_.grasps,
                           &metric_.drops, &metric_.different, &metric_.path};
  for (size_t i = 0; i < std::size(kMetrics); ++i) *order[i] = builder.metric(kMetrics[i]);
}

void FreePractice::bind(const Scene& scene, Binder& binder) {
  gripper_ = lessons::find_gripper(scene, binder, params_.gripper, gripper_object_);
  const std::vector<std::string> names = names_in(params_.things);
  const std::vector<std::string> owners = lessons::grasp_owners(scene);
  if (owners.size() != names.size()) {
    binder.error(say::kGraspEach(names.size(), owners.size()));
  }
  things_.clear();
  for (size_t i = 0; i < names.size() && i < owners.size(); ++i) {
    Thing thing;
    thing.object = lessons::find_object(scene, binder, names[i]);
    if (thing.object == kNone) continue;
    thing.body = scene->object[thing.object].first_body;
    thing.grasp = lessons::find_grasp(scene, binder, owners[i]);
    things_.push_back(thing);
  }
}

void FreePractice::look_at(const Thing& thing, ThingMemory& memory, PracticeMemory& all, const View& view,
                           const Verdict& verdict) const {
  const auto which = static_cast<double>(&thing - things_.data());
  const Vec3 p_W = toolkit::vec(view.pose(thing.body).p);
  Eigen::Map<Vec3> start(memory.start);
  if (all.begun == 0) {
    start = p_W;
    lessons::DropWatch::rest(memory.drop, p_W);
  }

  const bool held = view.signal(thing.grasp.held) != 0;
  if (view.happened(thing.grasp.touched)) {
    all.touches += 1;
    memory.touched = 1;
  }
  all.grasps += view.happened(thing.grasp.taken) ? 1 : 0;
  held ? verdict.cue(thing.object, held_) : verdict.clear_cue(thing.object);

  // counted once, when held long enough
  memory.held_s = held ? memory.held_s + view.dt() : 0;
  if (memory.grasped == 0 && held && memory.held_s >= params_.hold_time) {
    memory.grasped = 1;
    verdict.event(grasped_, which);
  }

  // the signal of a hold outlasts the hold, and by then a dropped object has landed: the force shows a drop at once
  if (drop_.look(memory.drop, p_W, held && view.signal(thing.grasp.force) > 0)) {
    all.drops += 1;
    verdict.event(dropped_, which);
    // an object that leaves its place without a touch of the jaw faces was pushed by another side of the instrument
    if (memory.touched == 0) all.touches += 1;
    memory.touched = 0;
  }
  const bool back = (p_W - start).norm() < 0.1 * params_.drop_distance;
  if (memory.drop.armed == 0 && back) lessons::DropWatch::rest(memory.drop, p_W);
}

void FreePractice::observe(const View& view, const Verdict& verdict, std::span<double> state) {
  const auto jaws = gripper_.describe(view.object(gripper_object_));
  if (!jaws) return discard();
  auto& memory = as<PracticeMemory>(state);
  path_.look(memory.path, toolkit::vec(jaws->tip_W), view.time());
  double different = 0;
  for (size_t i = 0; i < things_.size(); ++i) {
    look_at(things_[i], memory.thing[i], memory, view, verdict);
    different += memory.thing[i].grasped;
  }
  memory.begun = 1;
  report(memory, different, view.time(), verdict);

  // the attempt ends at the goal or the time limit
  const bool reached = params_.goal > 0 && different >= params_.goal;
  const bool over = view.time() >= params_.max_time && (params_.goal == 0 || !is_practice());
  verdict.phase(reached || over ? done_ : practice_);
  if (!reached && !over) return;
  const double share =
      different / static_cast<double>(params_.goal > 0 ? params_.goal : static_cast<int>(things_.size()));
  constexpr double kDropCosts = 10, kLeast = 40;
  const double whole = 100 * std::min(1.0, share);
  const double score = std::max(std::min(whole, kLeast), whole - kDropCosts * memory.drops);
  if (reached || params_.goal == 0) return verdict.pass(score);
  verdict.event(out_of_time_);
  verdict.fail(out_of_time_, 0.4 * whole);
}

void FreePractice::report(const PracticeMemory& memory, double different, double time_s,
                          const Verdict& verdict) const {
  verdict.metric(metric_.time, memory.path.set_off_s < 0 ? 0 : time_s - memory.path.set_off_s);
  verdict.metric(metric_.touches, memory.touches);
  verdict.metric(metric_.grasps, memory.grasps);
  verdict.metric(metric_.drops, memory.drops);
  verdict.metric(metric_.different, different);
  verdict.metric(metric_.path, memory.path.length);
}

}  // namespace swage::lesson_free_practice

SWAGE_EXPORT(swage::lesson_free_practice::FreePractice)
