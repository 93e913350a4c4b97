// SPDX-License-Identifier: Apache-2.0
#include "insertion_lesson.hpp"

#include <algorithm>

#include "common/declare.hpp"
#include "common/rules.hpp"
#include "common/sentences.hpp"
#include "sentences.hpp"

namespace swage::lesson_insertion {

using lessons::index;
using toolkit::vec;

namespace {

constexpr double kMarkRadius = 60e-6;  // m, drawn; the hole in its middle leaves the needle's point visible

}  // namespace

void InsertionLesson::build(const InsertionParams& params, LessonBuilder& builder) {
  params_ = params;
  lessons::require_ordered(builder, "force", params.force);
  lessons::require_ordered(builder, "tip_zone", params.tip_zone);
  if (params.region.high > 0) lessons::require_ordered(builder, "region", params.region);
  if (has_far() && params.task != Task::kStitch) builder.error("far", say::kTwoEdges());
  builder.state<Kept>();
  const auto shows = [&](size_t i) {
    if (i == index(Sign::kSwageHeld) || i == index(Sign::kTailGood)) return !params.suture.empty();
    if (i == index(Sign::kTaut)) return params.tension > 0;
    return i < index(Sign::kGraspWrong) || has_region();
  };
  // the whole card would be one metric more than a scene has room for
  const auto tells = [&](size_t i) {
    if (i == index(Measure::kTwist)) return !has_far();
    if (i == index(Measure::kWoundWide)) return !has_cut();
    if (i == index(Measure::kPointsExit)) return params.task == Task::kStitch;
    const bool several = i == index(Measure::kMostOblique) || i == index(Measure::kUnequal) || i == index(Measure::kUneven) ||
                         i == index(Measure::kPointsEven) || i == index(Measure::kPointsOblique);
    if (several) return params.stitches > 1;
    const bool tails = (i >= index(Measure::kTailLeast) && i <= index(Measure::kCutsAstray)) || i == index(Measure::kPointsTails);
    if (tails) return has_cut();
    const bool loops = i == index(Measure::kLoopLeast) || i == index(Measure::kLoopMost) || i == index(Measure::kPointsLoops);
    if (has_cut() && (loops || i == index(Measure::kPointsTension))) return false;
    return has_far() || (i != index(Measure::kPointsStep) && (i < index(Measure::kInnerNear) || i > index(Measure::kFarWound)));
  };
  lessons::declare_card(builder, kCues, cue_, kMetrics, metric_, shows, tells);

  phase_[index(Stage::kTake)] = builder.phase("take", "Take the needle.");
  phase_[index(Stage::kAim)] = builder.phase("aim", "Bring its point to the mark, perpendicular to the tissue.");
  phase_[index(Stage::kDrive)] = builder.phase("drive", "Drive it in along its own curve.");
  phase_[index(Stage::kRegrasp)] = builder.phase("regrasp", "The jaws are at the tissue: let go, and take the needle nearer its swage.");
  if (has_far()) phase_[index(Stage::kCross)] = builder.phase("cross", "On across the gap, into the other edge and out of it.");
  phase_[index(Stage::kRelease)] = builder.phase("release", "The point is out: let go.");
  phase_[index(Stage::kRetake)] = builder.phase("retake", "Take it where it came out.");
  phase_[index(Stage::kPull)] = builder.phase("pull", "Pull it through along its curve.");
  if (params.tail > 0) phase_[index(Stage::kDraw)] = builder.phase("draw", "Draw the thread through until its mark is at the entry.");
  else if (params.loop > 0) phase_[index(Stage::kDraw)] = builder.phase("draw", "Draw the thread until its loop lies on and has its length.");
  if (has_cut()) phase_[index(Stage::kCutOff)] = builder.phase("cut", "Cut the thread beyond the exit, as long as the tail.");
  phase_[index(Stage::kDone)] = builder.phase("done", "The attempt is over.");

  dropped_ = builder.event("needle.dropped", "The needle has left where it was held or lay.");
  damaged_ = builder.event("suture.damaged", "The needle was grasped at the swage, which damages the suture.");
  if (has_cut()) cut_off_ = builder.event("suture.cut_off", "The thread was cut; value: the tail that is left beyond the exit, m.");
  missed_ = builder.event("entry.missed", "The point went in too far from the mark.");
  if (has_far()) far_first_ = builder.event("entry.far_first", "The point went into the other edge, and not through the first one.");
  const auto failure = [&](End end, const char* code, const char* doc) {
    failed_[index(end)] = builder.event(code, doc);
  };
  failure(End::kDropped, "failed.dropped", "The needle was dropped too often.");
  failure(End::kMissed, "failed.missed", "The needle went in too far from the mark.");
  failure(End::kTorn, "failed.torn", "The entry wound became too large.");
  failure(End::kDeflected, "failed.deflected", "The point failed to puncture the tissue too often.");
  failure(End::kOutOfTime, "failed.out_of_time",
          "Time ran out before the needle was where it should be.");
  failure(End::kOffAngle, "failed.off_angle",
          "The needle was not perpendicular to the tissue for long enough.");
  if (has_far()) failure(End::kStep, "failed.step", "The two edges were taken at unlike depths: they heal with a step.");
  failure(End::kPulledOff, "failed.pulled_off", "The thread was pulled out of the needle.");
  failure(End::kTailLost, "failed.tail_lost", "The thread was drawn too far: its tail is too short or gone.");
  failure(End::kLost, "failed.lost", "The needle has gone where nobody can reach it.");
}

void InsertionLesson::bind(const Scene& scene, Binder& binder) {
  gripper_ = lessons::find_gripper(scene, binder, params_.gripper, gripper_object_);
  needle_object_ = lessons::find_object(scene, binder, params_.needle);
  tissue_object_ = lessons::find_object(scene, binder, params_.tissue);
  const std::vector<std::string> owners = lessons::grasp_owners(scene);
  if (owners.empty()) binder.error(lessons::say::kNoGrasp());
  if (binder.failed()) return;
  grasp_ = lessons::find_grasp(scene, binder, owners.front());
  needle_ = Peer(scene->object[needle_object_].instance);
  tissue_ = Peer(scene->object[tissue_object_].instance);
  if (!needle_.has(SWAGE_TRAIT_PIERCING)) binder.error(say::kCannotPierce(params_.needle));
  if (!tissue_.has(SWAGE_TRAIT_PIERCEABLE)) binder.error(say::kNotPierced(params_.tissue));
  if (scene->object[needle_object_].n_body == 0 || scene->object[tissue_object_].n_body == 0)
    binder.error(say::kNoBodies());
  bending_ = scene.find_signal(params_.needle, "needle.stress");  // only a needle that bends offers it
  const auto pierces = [&](const swage_scene_signal& signal) {
    return view(signal.id) == "pierce.state" && (!has_far() || view(signal.owner) != params_.far_pierce);
  };
  const std::span signals(scene->signal, scene->n_signal);
  const auto owner = std::find_if(signals.begin(), signals.end(), pierces);
  if (owner == signals.end()) return binder.error(say::kNoPiercing());
  pierce_ = find_pierce(scene, binder, std::string(view(owner->owner)));
  if (has_far()) find_far(scene, binder);
  if (!params_.suture.empty()) find_suture(scene, binder);
  if (params_.suture.empty() && (params_.tail + params_.loop > 0 || has_cut()))
    binder.error(say::kNoSuture());
  if (binder.failed()) return;
  gripper_body_ = scene->object[gripper_object_].first_body;
  needle_body_ = scene->object[needle_object_].first_body;
  tissue_body_ = scene->object[tissue_object_].first_body;
  target_ = binder.mark_point({0, 0, 0}, kMarkRadius, "target.point");
  if (params_.tail > 0) tail_ = binder.mark_point({0, 0, 0}, kMarkRadius, "tail.point");
  if (has_region()) region_ = binder.mark_arc(needle_object_, params_.region.low, params_.region.high, "region.target");
  if (has_exit()) exit_ = binder.mark_point({0, 0, 0}, kMarkRadius, "exit.point");
}

InsertionLesson::Pierce InsertionLesson::find_pierce(const Scene& scene, Binder& binder, const std::string& owner) const {
  const auto signal = [&](const std::string& word) {
    const Signal found = scene.find_signal(owner, "pierce." + word);
    if (!found.valid()) binder.missing(scene, "signal", owner, "pierce." + word, lessons::say::kWatched());
    return found;
  };
  const auto event = [&](const std::string& word) {
    const Event found = scene.find_event(owner, "pierce." + word);
    if (!found.valid()) binder.missing(scene, "event", owner, "pierce." + word, lessons::say::kWatched());
    return found;
  };
  return {signal("state"),
          signal("angle"),
          signal("cosine"),
          signal("s"),
          {signal("entry_x"), signal("entry_y"), signal("entry_z")},
          signal("wound"),
          signal("area_ratio"),
          signal("swept"),
          signal("below"),
          signal("pull"),
          signal("depth"),
          {signal("exit_x"), signal("exit_y"), signal("exit_z")},
          scene.find_signal(owner, "pierce.wound_wide"),
          scene.find_signal(owner, "pierce.exit_wound"),
          event("entered"),
          event("exited"),
          event("passed"),
          event("deflected")};
}

void InsertionLesson::activate(double dt_s) {
  const InsertionParams& p = params_;
  Rules rules;
  lessons::set_common_rules(p, is_practice(), rules);
  rules.task = p.task;
  rules.tolerance = p.tolerance;
  rules.in_angle = p.in_angle;
  rules.least_in_angle = p.least_in_angle;
  rules.drive = p.drive;
  rules.max_wound = p.max_wound;
  rules.max_deflections = p.max_deflections;
  rules.stitches = p.stitches;
  rules.exit_mark = has_exit();
  rules.region_low = p.region.low;
  rules.region_high = p.region.high;
  rules.tip_low = p.tip_zone.low;
  rules.tip_high = p.tip_zone.high;
  rules.suture.there = !p.suture.empty();
  rules.suture.swage_zone = p.swage_zone;
  rules.suture.tail = p.tail;
  rules.suture.tail_tolerance = p.tail_tolerance;
  rules.suture.loop = p.loop;
  rules.suture.loop_tolerance = p.loop_tolerance;
  rules.suture.tension = p.tension;
  rules.suture.cut = has_cut();
  rules.far = {has_far(), p.step};
  judge_ = Judge(rules, dt_s);
}

/// Draws the entry mark at random on the surface, once per attempt, and places the exit mark beside it.
bool InsertionLesson::draw(const View& scene, Kept& kept) {
  const toolkit::Pose X_WO(scene.pose(tissue_body_));
  const auto between = [this](const Interval& range) {
    return range.low + (range.high - range.low) * random();
  };
  const double x = between(params_.target_x), y = between(params_.target_y);
  const auto place = tissue_.inside(scene.object(tissue_object_), toolkit::raw(X_WO * Vec3(x, y, 0)));
  if (!place) return false;
  Eigen::Map<Vec3>(kept.target) = vec(place->p_W);
  Eigen::Map<Vec3>(kept.normal) = vec(place->normal_W);
  Eigen::Map<Vec3>(kept.exit) = vec(place->p_W) + X_WO.q * Eigen::Map<const Vec3>(params_.exit.data());
  kept.drawn = 1;
  return true;
}

/// Moves the marks by one spacing along the edge.
void InsertionLesson::next_mark(const View& scene, Kept& kept) const {
  Eigen::Map<Vec3> target(kept.target), normal(kept.normal);
  const Vec3 edge = Eigen::Map<const Vec3>(kept.memory.stitch.edge);
  const Vec3 along = edge.norm() > 0 ? Vec3(normal.cross(edge)) : Vec3(normal.unitOrthogonal());
  const auto place =
      tissue_.inside(scene.object(tissue_object_), toolkit::raw(Vec3(target + params_.spacing * along)));
  if (!place) return;
  Eigen::Map<Vec3>(kept.exit) += vec(place->p_W) - target;
  target = vec(place->p_W);
  normal = vec(place->normal_W);
}

Vec3 InsertionLesson::place(const View& scene, const Signal (&signal)[3]) {
  return {scene.signal(signal[0]), scene.signal(signal[1]), scene.signal(signal[2])};
}

/// A hole and the direction to the nearest edge, in which the distance from the edge falls fastest.
Hole InsertionLesson::hole(const Peer& peer, const Step& tissue, const Vec3& p_W) {
  Hole hole;
  hole.p_W = p_W;
  const auto here = peer.inside(tissue, toolkit::raw(p_W));
  if (!here) return hole;
  hole.edge = here->edge;
  hole.wall = here->depth - here->beyond;
  hole.normal_W = vec(here->normal_W);
  const Vec3 u = hole.normal_W.unitOrthogonal(), v = hole.normal_W.cross(u);
  const auto slope = [&](const Vec3& way) {
    constexpr double kBeside = 10e-6;  // m, less than any bite and more than rounding
    const auto ahead = peer.inside(tissue, toolkit::raw(Vec3(p_W + kBeside * way)));
    const auto behind = peer.inside(tissue, toolkit::raw(Vec3(p_W - kBeside * way)));
    return ahead && behind ? (ahead->edge - behind->edge) / (2 * kBeside) : 0.0;
  };
  const Vec3 down = -slope(u) * u - slope(v) * v;
  if (down.norm() > 0) hole.edge_W = down.normalized();
  return hole;
}

/// Angle of the exit in this step, rad; negative: there was none.
double InsertionLesson::exit_angle(const View& scene, const Pierce& pierce) {
  for (const swage_view_event& event : scene.events())
    if (event.event == pierce.exited) return event.value;
  return -1;
}

bool InsertionLesson::read(const View& scene, const Kept& kept, Look& look) const {
  const auto jaws = gripper_.describe(scene.object(gripper_object_));
  const auto point = needle_.place(scene.object(needle_object_), 0);
  if (!jaws || !point) return false;
  const auto number = [&](Signal signal) { return scene.signal(signal); };
  look.time_s = scene.time();
  look.dt_s = scene.dt();
  look.held = number(grasp_.held) != 0;
  look.force = number(grasp_.force);
  look.grip_s = number(grasp_.s);
  look.tip_reach = number(grasp_.tip_reach);
  look.tilt_axis = number(grasp_.tilt_axis);
  look.tilt_plane = number(grasp_.tilt_plane);
  if (bending_.valid()) look.bending = number(bending_);
  look.tip_W = vec(jaws->tip_W);
  look.needle_W = vec(scene.pose(needle_body_).p);
  look.length = point->length;
  look.point_W = vec(point->p_W);
  look.target_W = Eigen::Map<const Vec3>(kept.target);
  look.normal_W = Eigen::Map<const Vec3>(kept.normal);
  look.exit_target_W = Eigen::Map<const Vec3>(kept.exit);
  look.diameter = 2 * point->radius;
  read_pierce(scene, look);
  read_stray(scene, *jaws, look);
  if (has_far()) read_far(scene, kept, *jaws, look);
  if (thread_.valid()) read_suture(scene, look);
  return true;
}

void InsertionLesson::read_pierce(const View& scene, Look& look) const {
  const auto number = [&](Signal signal) { return scene.signal(signal); };
  constexpr double kInTissue = 2;
  look.touching = number(pierce_.state) > 0;
  look.in_tissue = number(pierce_.state) >= kInTissue;
  look.entered = scene.happened(pierce_.entered);
  look.passed = scene.happened(pierce_.passed);
  look.deflected = scene.happened(pierce_.deflected);
  look.exit_angle = exit_angle(scene, pierce_);
  look.exited = look.exit_angle >= 0;
  look.angle = number(pierce_.angle);
  look.cosine = number(pierce_.cosine);
  look.s = number(pierce_.s);
  look.entry_W = place(scene, pierce_.entry);
  if (look.entered || look.exited)
    look.hole = hole(tissue_, scene.object(tissue_object_), look.exited ? place(scene, pierce_.exit) : look.entry_W);
  look.wound = number(pierce_.wound);
  look.area_ratio = number(pierce_.area_ratio);
  if (pierce_.wound_wide.valid()) look.wound_wide = number(pierce_.wound_wide);
  if (pierce_.exit_wound.valid()) look.exit_wound = number(pierce_.exit_wound);
  look.swept = number(pierce_.swept);
  look.below = number(pierce_.below);
  look.pull = number(pierce_.pull);
  if (!look.in_tissue) return;
  const auto nearest = needle_.nearest(scene.object(needle_object_), toolkit::raw(look.entry_W));
  if (nearest) look.arc_error = (vec(nearest->p_W) - look.entry_W).norm();
}

/// Observes stray touches. The needle may touch the tissue at the mark, at its entry and exit, and with the part between them.
void InsertionLesson::read_stray(const View& scene, const swage_gripper_state& jaws, Look& look) const {
  Region region;
  region.middle[0] = look.in_tissue ? look.entry_W : look.target_W;
  region.normal = look.normal_W;
  region.radius = params_.tolerance;
  constexpr double kOut = 3;
  if (look.in_tissue) {
    region.s_in = look.s;
    const bool out = scene.signal(pierce_.state) >= kOut;
    if (out) region.middle[region.count++] = place(scene, pierce_.exit);
    region.s_out = out ? look.s - scene.signal(pierce_.depth) / look.length : 0;
  }
  const Step tissue = scene.object(tissue_object_);
  look.needle_astray = needle_astray(needle_, scene.object(needle_object_), tissue_, tissue, region);
  const auto origin = [&](uint32_t body) { return vec(scene.pose(gripper_body_ + body).p); };
  look.jaws_astray = jaws_astray(jaws, {origin(jaws.left_body), origin(jaws.right_body)}, tissue_, tissue);
}

void InsertionLesson::observe(const View& scene, const Verdict& verdict, std::span<double> state) {
  auto& kept = as<Kept>(state);
  Look look;
  if ((kept.drawn == 0 && !draw(scene, kept)) || !read(scene, kept, look)) return discard();
  const Finding finding = judge_.look(kept.memory, look);
  if (finding.stitched) next_mark(scene, kept);
  report(look, finding, kept.memory, verdict);
  if (finding.end == End::kPassed) report_points(finding.lost, verdict);
  say(finding, kept, look.time_s, verdict);
  if (params_.tail > 0) show_tail(scene, kept, verdict);
}

void InsertionLesson::say(const Finding& finding, const Kept& kept, double time_s, const Verdict& verdict) const {
  // cues
  const auto show = [&](uint32_t object, Cue cue) {
    cue.valid() ? verdict.cue(object, cue) : verdict.clear_cue(object);
  };
  const Memory& m = kept.memory;
  Cue needle;
  if (finding.grip != Grip::kNone) needle = cue_[index(Sign::kGraspWrong) + index(finding.grip) - 1];
  if (finding.stage == Stage::kTake && m.drops > 0) needle = sign(Sign::kDropped);
  if (finding.angle_good) needle = sign(Sign::kAngleGood);
  if (m.bending >= 1) needle = sign(Sign::kBent);
  if (finding.angle_off) needle = sign(Sign::kAngleOff);
  if (finding.stuck) needle = sign(Sign::kStuck);
  show(needle_object_, needle);
  show(gripper_object_, finding.too_hard ? sign(Sign::kTooHard) : Cue());
  if (thread_.valid()) say_suture(finding, verdict);
  constexpr double kSigned = 3;  // s: long enough to be read
  const bool turned_away = finding.stage == Stage::kAim && m.entries == 0 && time_s - m.deflected_s < kSigned;
  show(tissue_object_, finding.torn ? sign(Sign::kTorn) : turned_away ? sign(Sign::kDeflected) : Cue());
  const auto point = [&](Mark mark, const double(&p)[3], bool near) {
    const swage_vec3 p_W{p[0], p[1], p[2]};
    if (finding.end == End::kPassed) return verdict.mark(mark, sign(Sign::kDone), &p_W);
    verdict.mark(mark, near ? sign(Sign::kNear) : Cue(), &p_W);
  };
  // the mark keeps its cue while a needle that entered there is pulled through, and its thread
  const bool was_there = (finding.stage == Stage::kPull || finding.stage == Stage::kDraw) && m.entry_distance <= params_.tolerance;
  point(target_, kept.target, finding.near || was_there);
  if (finding.stage == Stage::kDrive && m.entry_distance > params_.tolerance) {
    const swage_vec3 p_W{kept.target[0], kept.target[1], kept.target[2]};
    verdict.mark(target_, sign(Sign::kLeft), &p_W);
  }
  if (has_exit()) point(exit_, kept.exit, finding.exit_near);

  // events
  if (finding.dropped) verdict.event(dropped_);
  if (finding.damaged) verdict.event(damaged_);
  if (finding.missed) verdict.event(missed_, kept.memory.entry_distance);
  if (finding.cut_off) verdict.event(cut_off_, finding.cut_tail);
  if (finding.far_first) verdict.event(far_first_);
  verdict.phase(phase_[index(finding.stage)]);

  // verdict
  if (finding.end == End::kRunning) return;
  if (finding.end == End::kPassed) return verdict.pass(finding.score);
  const Event reason = failed_[index(finding.end)];
  verdict.event(reason);
  verdict.fail(reason, finding.score);
}

}  // namespace swage::lesson_insertion

SWAGE_EXPORT(swage::lesson_insertion::InsertionLesson)
