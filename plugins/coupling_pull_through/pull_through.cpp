// SPDX-License-Identifier: Apache-2.0
#include "pull_through.hpp"

#include <algorithm>
#include <cmath>

namespace swage::coupling_pull_through {

using toolkit::raw;
using toolkit::vec;

namespace {

// Beside its holes the thread does not touch the surface, in its radii: it bends out of them there.
constexpr double kMouth = 24;
// A touch that overlaps by more than this many radii when first seen is inside, not on the surface.
constexpr double kNewTouch = 4;
// Tensions are told this far outside of the holes, in radii: beyond the segment that a hole bears on.
constexpr double kBeside = 24;

Vec3 vec3(const double* a) { return {a[0], a[1], a[2]}; }

}  // namespace

void PullThrough::build(const PullThroughParams& params, CouplingBuilder& builder) {
  params_ = params;
  builder.state<PullThroughState>();
  state_ = builder.signal("pull.state", "1", "0 the thread is not in the tissue, 1 its leading end is in it, 2 that is out again.");
  tail_ = builder.signal("pull.tail", "m", "Thread that has not gone in yet; 0 when it is not in the tissue.");
  out_ = builder.signal("pull.out", "m", "Thread that has come out; 0 when none has.");
  inside_ = builder.signal("pull.inside", "m", "Thread in the tissue.");
  drag_ = builder.signal("pull.drag", "N", "Of the tissue against the thread, along it.");
  force_ = builder.signal("pull.force", "N", "Of the thread on the tissue.");
  lateral_ = builder.signal("pull.lateral", "N", "The greatest across the thread at one of its holes.");
  tension_tail_ = builder.signal("pull.tension_tail", "N", "Tension of the thread before it goes in.");
  tension_out_ = builder.signal("pull.tension_out", "N", "Tension of the thread where it has come out.");
  cut_ = builder.signal("pull.cut", "m", "How far the thread has cut its holes through the tissue, the farthest of them.");
  back_ = builder.signal("pull.back", "m", "Thread drawn back so far, against its way: sawing.");
  in_ = builder.event("pull.went_in", "The thread went in; value: drawn in so far, m.");
  came_out_ = builder.event("pull.came_out", "Its leading end came out; value: length inside, m.");
  back_out_ = builder.event("pull.went_back", "It was drawn back out of the way it came.");
  through_ = builder.event("pull.went_through", "Its other end has gone through; nothing is left in the tissue.");
  cut_event_ = builder.event("pull.has_cut", "It has cut farther through the tissue than the limit; value: how far, m.");
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
  if (params_.starts == Starts::kOutside) return;
  const Site site = this->site(step);
  if (site.good) lie_through(site, state.passage);
}

/// What is in a hole, in the tissue, or still in the needle that goes in, does not touch the surface.
bool PullThrough::passes(const Site& site, const Passage& passage, const swage_contact& contact) const {
  const double mouth = kMouth * site.strand.radius;
  const bool fresh = contact.gap < -kNewTouch * site.strand.radius && vec(contact.f_a_W).isZero(0);
  if (fresh) return true;
  const auto at = thread_.nearest(site.a, contact.p_W);
  if (!at) return true;
  const double u = site.last_leads ? site.strand.length - at->s : at->s;
  if (passage.count == 0) return u < mouth;
  const double to = passage.out != 0 ? passage.hole[passage.holes() - 1].u - mouth : 0;
  return u > to && u < passage.hole[0].u + mouth;
}

void PullThrough::resolve(const CouplingStep& step) {
  const Site site = this->site(step);
  if (!site.good) return discard();
  const auto& passage = step.state<PullThroughState>().passage;
  for (swage_contact& contact : step.contacts()) {
    contact.friction = params_.friction;
    contact.stiffness = site.law.stiffness + site.law.stiffening * std::max(0.0, -contact.gap);
    contact.restitution = 0;
    if (passes(site, passage, contact)) contact.stiffness = contact.friction = 0;
  }
}

uint32_t PullThrough::ties(const CouplingStep& step, std::span<swage_tie> out) {
  const Passage& passage = step.state<PullThroughState>().passage;
  const uint32_t n = passage.holes();
  if (n == 0 || out.size() < n) return 0;
  const Site site = this->site(step);
  if (!site.good) return 0;
  for (uint32_t i = 0; i < n; ++i) out[i] = tie_of(site, law(site), passage, i);
  return n;
}

void PullThrough::tied(const CouplingStep& step, std::span<const swage_tie> ties) {
  auto& state = step.state<PullThroughState>();
  const Site site = this->site(step);
  if (!site.good) return discard();
  Vec3 force = Vec3::Zero();
  state.drag_along = state.lateral = 0;
  const double before = state.passage.hole[0].rest;
  for (uint32_t i = 0; i < ties.size() && i < state.passage.holes(); ++i) {
    Hole& hole = state.passage.hole[i];
    take_tie(site, law(site), ties[i], hole);
    force -= vec(ties[i].f_a_W);
    state.drag_along -= hole.along;
    state.lateral = std::max(state.lateral, vec3(hole.across).norm());
    state.cut = std::max(state.cut, hole.cut);
  }
  for (int i = 0; i < 3; ++i) state.force[i] = force[i];
  state.back += std::max(0.0, before - state.passage.hole[0].rest);
}

void PullThrough::finish(const CouplingStep& step) {
  auto& state = step.state<PullThroughState>();
  const Site site = this->site(step);
  if (!site.good) return discard();
  if (state.passage.count == 0) state.drag_along = state.lateral = state.force[0] = state.force[1] = state.force[2] = 0;
  const double inside = state.passage.inside();
  switch (follow(site, state.passage, law(site), params_.in_from)) {
    case Change::kNone: break;
    case Change::kWentIn: step.event(in_, state.passage.inside()); break;
    case Change::kCameOut:  // again where the tissue springs back over the end: told once
      if (state.told_out == 0) step.event(came_out_, state.passage.inside());
      state.told_out = 1;
      break;
    case Change::kWentBack: step.event(back_out_, inside); break;
    case Change::kIsThrough: step.event(through_, inside); break;
  }
  if (state.passage.count == 0) state.told_out = 0;
  if (state.cut > params_.cut_from && state.told == 0) {
    state.told = 1;
    step.event(cut_event_, state.cut);
  }
  tell(step, site, state);
}

void PullThrough::tell(const CouplingStep& step, const Site& site, const PullThroughState& state) const {
  const Passage& passage = state.passage;
  const bool in = passage.count > 0;
  const double first = in ? passage.hole[0].u : 0, last = in && passage.out != 0 ? passage.hole[passage.holes() - 1].u : 0;
  const double beside = kBeside * site.strand.radius;
  step.signal(state_, !in ? 0 : passage.out == 0 ? 1 : 2);
  step.signal(tail_, in ? std::max(0.0, site.strand.length - first) : 0);
  step.signal(out_, last);
  step.signal(inside_, passage.inside());
  step.signal(drag_, state.drag_along);
  step.signal(force_, vec3(state.force).norm());
  step.signal(lateral_, state.lateral);
  step.signal(tension_tail_, in ? site.place(first + beside).tension : 0);
  step.signal(tension_out_, in ? site.place(last - beside).tension : 0);
  step.signal(cut_, state.cut);
  step.signal(back_, state.back);
}

/// Entry and exit, where they have been cut longer.
uint32_t PullThrough::tears(const CouplingStep& step, std::span<swage_tear> out) {
  const Passage& passage = step.state<PullThroughState>().passage;
  const Site site = this->site(step);
  if (!site.good) return 0;
  uint32_t n = 0;
  for (uint32_t i = 0; i < passage.holes(); ++i) {
    const Hole& hole = passage.hole[i];
    const bool face = i == 0 || (passage.out != 0 && i + 1 == passage.holes());
    if (!face || hole.cut < site.strand.radius || n == out.size()) continue;
    const Vec3 normal = vec3(hole.normal), way = vec3(hole.p) - vec3(hole.first), flat = way - normal.dot(way) * normal;
    swage_tear& tear = out[n];
    tear = {};
    tear.a_W = raw(site.world(hole.first));
    tear.b_W = raw(Vec3(vec(tear.a_W) + toolkit::rotated(site.X_WO.q, flat)));
    tear.normal_W = raw(toolkit::rotated(site.X_WO.q, normal));
    tear.radius = site.strand.radius;
    tear.wound = n++;
  }
  return n;
}

}  // namespace swage::coupling_pull_through

SWAGE_EXPORT(swage::coupling_pull_through::PullThrough)
