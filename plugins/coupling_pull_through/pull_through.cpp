// SPDX-License-Identifier: Apache-2.0
#include "pull_through.hpp"

#include <algorithm>
#include <cmath>

namespace swage::coupling_pull_through {

using toolkit::raw;
using toolkit::vec;

namespace {

// In thread radii: part of the thread beside its holes that does not touch the surface, as it bends out of them there.
constexpr double kMouth = 24;
// A contact that overlaps by more than this many radii when first detected is inside, not on the surface.
constexpr double kNewTouch = 4;
// In thread radii: distance from the holes at which tensions are reported, beyond the segment on which a hole bears.
constexpr double kBeside = 24;
// In thread radii: thread that must be out of the last bite before another begins: tissue that springs back over the end is no new bite.
constexpr double kApart = 96;
// s, in which a thread that was laid through the tissue comes to rest. What it tears meanwhile is where its holes are, not a cut:
// nobody has touched it. 8-0 nylon bent to a half circle of 1 mm moves its holes by 0.1 mm in 2 ms. Shorter: that counts as cut. Longer: a quick hand's
// first pull does not.
constexpr double kComesToRest = 0.1;

Vec3 vec3(const double* a) { return {a[0], a[1], a[2]}; }

}  // namespace

void PullThrough::build(const PullThroughParams& params, CouplingBuilder& builder) {
  params_ = params;
  builder.state<PullThroughState>();
  state_ = builder.signal("pull.state", "1", "0 the thread is not in the tissue, 1 its leading end is in it, 2 that is out again.");
  tail_ = builder.signal("pull.tail", "m", "Thread that has not gone in yet; 0 when it is not in the tissue.");
  out_ = builder.signal("pull.out", "m", "Thread that has come out; 0 when none has.");
  inside_ = builder.signal("pull.inside", "m", "Thread in the tissue.");
  const bool all = params.tells == Tells::kAll;
  if (!all) drawn_ = builder.signal("pull.drawn", "m", "Thread from its leading end to where it went in last; 0 when it is not in the tissue.");
  if (all) drag_ = builder.signal("pull.drag", "N", "Of the tissue against the thread, along it.");
  force_ = builder.signal("pull.force", "N", "Of the thread on the tissue.");
  if (all) lateral_ = builder.signal("pull.lateral", "N", "The greatest across the thread at one of its holes.");
  tension_tail_ = builder.signal("pull.tension_tail", "N", "Tension of the thread before it goes in.");
  tension_out_ = builder.signal("pull.tension_out", "N", "Tension of the thread where it has come out.");
  cut_ = builder.signal("pull.cut", "m", "How far the thread has cut its holes through the tissue, the farthest of them.");
  back_ = builder.signal("pull.back", "m", "Thread drawn back so far, against its way: sawing.");
  if (all) declare_loops(builder);
  in_ = builder.event("pull.went_in", "The thread went in; value: drawn in so far, m.");
  came_out_ = builder.event("pull.came_out", "Its leading end came out; value: length inside, m.");
  back_out_ = builder.event("pull.went_back", "It was drawn back out of the way it came.");
  through_ = builder.event("pull.went_through", "Its other end has gone through; nothing is left in the tissue.");
  cut_event_ = builder.event("pull.has_cut", "It has cut farther through the tissue than the limit; value: how far, m.");
}

void PullThrough::declare_loops(CouplingBuilder& builder) {
  bites_ = builder.signal("pull.bites", "1", "Times that the thread goes through the tissue now.");
  loop_ = builder.signal("pull.loop", "m", "Thread between the last bite and the one before it, or the other end; 0 when it is not in the tissue.");
  loop_least_ = builder.signal("pull.loop_least", "m", "The shortest such length of all bites.");
  loop_most_ = builder.signal("pull.loop_most", "m", "The longest such length of all bites.");
}

void PullThrough::bind(const Peer& a, const Peer& b) {
  thread_ = StrandPeer(a);
  tissue_ = b;
  if (!thread_.valid()) refuse("the thread has no table of " SWAGE_TRAIT_STRAND);
}

PassageLaw PullThrough::law(const Site& site) const {
  return {params_.drag, params_.friction, site.law.side_stiffness, site.law.failure_stress, params_.saw};
}

void PullThrough::reset(const CouplingStep& step) {
  auto& state = step.state<PullThroughState>();
  state = {};
  state.began_s = step.time();
  if (params_.starts == Starts::kOutside) return;
  const Site site = this->site(step);
  if (site.good && lie_through(site, state.bite[0])) state.bites = 1;
}

/// True when the leading end can begin another bite.
bool PullThrough::may_begin(const Site& site, const PullThroughState& state) const {
  if (state.bites == 0) return true;
  const Passage& last = state.bite[0];
  return state.bites < params_.bites && last.out != 0 && last.hole[last.holes() - 1].u > kApart * site.strand.radius;
}

/// True for a contact of thread in a hole, in the tissue, or still in the needle that enters: it does not touch the surface.
bool PullThrough::passes(const Site& site, const PullThroughState& state, const swage_contact& contact) const {
  const double mouth = kMouth * site.strand.radius;
  const bool fresh = contact.gap < -kNewTouch * site.strand.radius && vec(contact.f_a_W).isZero(0);
  if (fresh) return true;
  const auto at = thread_.nearest(site.a, contact.p_W);
  if (!at) return true;
  const double u = site.last_leads ? site.strand.length - at->s : at->s;
  if (u < mouth && may_begin(site, state)) return true;
  return std::any_of(state.bite, state.bite + state.count(), [&](const Passage& passage) {
    const double to = passage.out != 0 ? passage.hole[passage.holes() - 1].u - mouth : 0;
    return u > to && u < passage.hole[0].u + mouth;
  });
}

void PullThrough::resolve(const CouplingStep& step) {
  const Site site = this->site(step);
  if (!site.good) return discard();
  const auto& state = step.state<PullThroughState>();
  for (swage_contact& contact : step.contacts()) {
    contact.friction = params_.friction;
    contact.stiffness = site.law.stiffness + site.law.stiffening * std::max(0.0, -contact.gap);
    contact.restitution = 0;
    if (passes(site, state, contact)) contact.stiffness = contact.friction = 0;
  }
}

uint32_t PullThrough::ties(const CouplingStep& step, std::span<swage_tie> out) {
  const auto& state = step.state<PullThroughState>();
  if (state.bites == 0 || out.size() < state.holes()) return 0;
  const Site site = this->site(step);
  if (!site.good) return 0;
  uint32_t n = 0;
  for (int b = 0; b < state.count(); ++b)
    for (uint32_t i = 0; i < state.bite[b].holes(); ++i) out[n++] = tie_of(site, law(site), state.bite[b], i);
  return n;
}

void PullThrough::on_solved(const CouplingStep& step, std::span<const swage_tie> ties) {
  auto& state = step.state<PullThroughState>();
  const Site site = this->site(step);
  if (!site.good) return discard();
  if (ties.size() != state.holes()) return;
  Vec3 force = Vec3::Zero();
  state.drag_along = state.lateral = 0;
  const double before = state.bite[0].hole[0].rest;
  const bool comes_to_rest = params_.starts == Starts::kThrough && step.time() - state.began_s < kComesToRest;
  const swage_tie* tie = ties.data();
  for (int b = 0; b < state.count(); ++b)
    for (uint32_t i = 0; i < state.bite[b].holes(); ++i, ++tie) {
      Hole& hole = state.bite[b].hole[i];
      take_tie(site, law(site), *tie, hole);
      if (comes_to_rest) begin_here(hole);
      force -= vec(tie->f_a_W);
      state.drag_along -= hole.along;
      state.lateral = std::max(state.lateral, vec3(hole.across).norm());
      state.cut = std::max(state.cut, hole.cut);
    }
  for (int i = 0; i < 3; ++i) state.force[i] = force[i];
  state.back += std::max(0.0, before - state.bite[0].hole[0].rest);
}

void PullThrough::finish(const CouplingStep& step) {
  auto& state = step.state<PullThroughState>();
  const Site site = this->site(step);
  if (!site.good) return discard();
  if (state.bites == 0) state.drag_along = state.lateral = state.force[0] = state.force[1] = state.force[2] = 0;
  const bool begins = may_begin(site, state);
  follow_bites(step, site, state);
  if (begins) follow_end(step, site, state);
  if (state.cut > params_.cut_from && state.told == 0) {
    state.told = 1;
    step.event(cut_event_, state.cut);
  }
  tell(step, site, state);
}

/// Removes bites that the thread has left: the last one when it was drawn back, the first when the thread has gone through.
void PullThrough::follow_bites(const CouplingStep& step, const Site& site, PullThroughState& state) const {
  for (int b = state.count() - 1; b >= 0; --b) {
    const double inside = state.bite[b].inside();
    const Change change = follow(site, state.bite[b], law(site), params_.in_from);
    if (change == Change::kCameOut) {  // also repeated where the tissue springs back over the end: the event is sent once
      if (state.told_out == 0) step.event(came_out_, state.bite[b].inside());
      state.told_out = 1;
    }
    if (change != Change::kWentBack && change != Change::kIsThrough) continue;
    step.event(change == Change::kWentBack ? back_out_ : through_, inside);
    std::copy(state.bite + b + 1, state.bite + state.count(), state.bite + b);
    state.bites -= 1;
    state.bite[state.count()] = {};
    state.told_out = state.bites > 0 ? state.bite[0].out : 0;
  }
}

void PullThrough::follow_end(const CouplingStep& step, const Site& site, PullThroughState& state) const {
  Passage fresh{};
  if (state.count() == kMostBites || follow(site, fresh, law(site), params_.in_from) != Change::kWentIn) return;
  std::copy_backward(state.bite, state.bite + state.count(), state.bite + state.count() + 1);
  state.bite[0] = fresh;
  state.bites += 1;
  state.told_out = 0;
  step.event(in_, fresh.inside());
}

/// Reports on the bite nearest to the leading end; the tail, and the tension there, are of the bite nearest to the other end.
void PullThrough::tell(const CouplingStep& step, const Site& site, const PullThroughState& state) const {
  const bool in = state.bites > 0;
  const Passage &newest = state.bite[0], &oldest = state.bite[in ? state.count() - 1 : 0];
  const double first = in ? oldest.hole[0].u : 0, last = in && newest.out != 0 ? newest.hole[newest.holes() - 1].u : 0;
  const double beside = kBeside * site.strand.radius;
  const double loop = in ? state.loop(0, site.strand.length) : 0;
  double inside = 0, least = loop, most = loop;
  for (int b = 0; b < state.count(); ++b) {
    const double l = state.loop(b, site.strand.length);
    inside += state.bite[b].inside(), least = std::min(least, l), most = std::max(most, l);
  }
  step.signal(state_, !in ? 0 : newest.out == 0 ? 1 : 2);
  if (bites_.valid()) {
    step.signal(bites_, state.bites);
    step.signal(loop_, loop);
    step.signal(loop_least_, least);
    step.signal(loop_most_, most);
    step.signal(drag_, state.drag_along);
    step.signal(lateral_, state.lateral);
  } else {
    step.signal(drawn_, in ? newest.hole[0].u : 0);
  }
  step.signal(tail_, in ? std::max(0.0, site.strand.length - first) : 0);
  step.signal(out_, last);
  step.signal(inside_, inside);
  step.signal(force_, vec3(state.force).norm());
  step.signal(tension_tail_, in ? site.place(first + beside).tension : 0);
  step.signal(tension_out_, in ? site.place(last - beside).tension : 0);
  step.signal(cut_, state.cut);
  step.signal(back_, state.back);
}

/// Marks entry and exit where they have been cut longer.
void PullThrough::draw(const CouplingStep& step, Visuals& out) {
  const auto& state = step.state<PullThroughState>();
  const Site site = this->site(step);
  if (!site.good) return;
  for (uint32_t k = 0; k < Passage::kHoles * static_cast<uint32_t>(state.count()); ++k) {
    const Passage& passage = state.bite[k / Passage::kHoles];
    const uint32_t i = k % Passage::kHoles;
    if (i >= passage.holes()) continue;
    const Hole& hole = passage.hole[i];
    const bool face = i == 0 || (passage.out != 0 && i + 1 == passage.holes());
    if (!face || hole.cut < site.strand.radius) continue;
    const Vec3 normal = vec3(hole.normal), way = vec3(hole.p) - vec3(hole.first), flat = way - normal.dot(way) * normal;
    const swage_vec3 first_W = raw(site.world(hole.first));
    out.tear(out.size(), first_W, raw(Vec3(vec(first_W) + toolkit::rotated(site.X_WO.q, flat))),
             raw(toolkit::rotated(site.X_WO.q, normal)), site.strand.radius);
  }
}

}  // namespace swage::coupling_pull_through

SWAGE_EXPORT(swage::coupling_pull_through::PullThrough)
