// SPDX-License-Identifier: Apache-2.0
#include "winding.hpp"

#include <algorithm>
#include <cmath>

namespace swage::coupling_winding {

using toolkit::vec;
using toolkit::Vec3;

namespace {

// A turn counts as whole when at most this share of it is missing, and no longer when twice as much is: the direction in which the thread
// leaves the instrument depends on the other hand.
constexpr double kMissing = 0.25;

}  // namespace

void Winding::build(const WindingParams& params, CouplingBuilder& builder) {
  params_ = params;
  builder.state<WindingState>();
  turns_ = builder.signal("winding.turns", "1",
                          "Turns of the thread about the instrument, right-handed about the way from hinge to tips; half a turn at most "
                          "where it only passes.");
  whole_ = builder.signal("winding.whole", "1", "Whole turns, with their sign.");
  behind_ = builder.signal("winding.behind", "m", "How far behind the tips the thread is wound.");
  passages_ = builder.signal("winding.passages", "1", "How often the thread has gone through the instrument.");
  wound_ = builder.event("winding.wound", "A whole turn more; value: whole turns now, with their sign.");
  unwound_ = builder.event("winding.unwound", "A whole turn less; value: whole turns now, with their sign.");
  passage_ = builder.event("winding.passage",
                           "The thread has gone through the instrument: what is wound from here on is not to be trusted; value: where, in "
                           "m from its first end.");
}

void Winding::bind(const Peer& a, const Peer& b) {
  tool_ = a;
  thread_ = StrandPeer(b);
  if (!thread_.valid()) refuse("the thread has no table of " SWAGE_TRAIT_STRAND);
}

void Winding::reset(const CouplingStep& step) {
  step.state<WindingState>() = {};
  params_.places = thread_.places(step.b(), params_.places, kPlaces);
  last_ = static_cast<int>(std::lround(params_.to * (params_.places - 1)));  // the tail beyond is not wound
}

/// Computes the places of the thread in the frame of the jaws.
bool Winding::look(const CouplingStep& step, const Jaws& jaws) {
  const auto law = thread_.law(step.b());
  const auto n = static_cast<size_t>(params_.places);
  if (!law || !thread_.line(step.b(), {p_T_, 3 * n}, {parted_, n})) return false;
  length_ = law->length;
  const Vec3 tip(jaws.tip_W), x(jaws.axis_W), z(jaws.closing_W), y = z.cross(x);
  for (int i = 0; i < params_.places; ++i) {
    const Vec3 d = this->place(p_T_, i) - tip;
    p_T_[3 * i] = d.dot(x), p_T_[3 * i + 1] = d.dot(y), p_T_[3 * i + 2] = d.dot(z);
    if (!this->place(p_T_, i).allFinite()) return false;  // a place that is not finite counts as unknown
  }
  return true;
}

/// Finds passages since the last call. A step may be done in substeps: in each of them the jaws are where they will be at its end, and
/// the thread is where the last substep left it.
bool Winding::go_on(const CouplingStep& step, WindingState& state) {
  const auto now = tool_.describe(step.a());
  if (!now) return false;
  const auto keep = [](const swage_vec3& v, double* out) { out[0] = v.x, out[1] = v.y, out[2] = v.z; };
  Jaws jaws;
  keep(now->tip_W, jaws.tip_W), keep(now->axis_W, jaws.axis_W), keep(now->closing_W, jaws.closing_W);
  jaws.opening = now->opening;
  if (state.known == 0) state.jaws = jaws;
  if (!look(step, state.jaws)) return false;
  if (state.known != 0) find_passages(step, state);
  std::copy_n(p_T_, 3 * params_.places, state.p_T);
  state.known = 1, state.opening = state.jaws.opening, state.jaws = jaws;
  return true;
}

Winding::Jaw Winding::jaw(double opening, double side) const {
  const double c = std::cos(0.5 * opening);
  return {c, side * std::sin(0.5 * opening), params_.hinge / c, side * params_.inside};
}

/// Transforms from the tool's frame to that of one jaw.
Vec3 Winding::in_jaw(const Vec3& p_T, const Jaw& jaw) const {
  const double x = p_T.x() + params_.hinge, z = p_T.z();  // from the hinge
  return {jaw.cosine * x + jaw.sine * z - jaw.length, p_T.y(), jaw.cosine * z - jaw.sine * x - jaw.inside};
}

/// Finds passages of the counted part: the tail beyond is what the jaws grasp. A thread may pass between open jaws, but through neither.
void Winding::find_passages(const CouplingStep& step, WindingState& state) const {
  if (std::equal(p_T_, p_T_ + 3 * params_.places, state.p_T)) return;  // at the beginning of a step nothing has moved
  const Jaw before[2] = {jaw(state.opening, 1), jaw(state.opening, -1)};
  const Jaw after[2] = {jaw(state.jaws.opening, 1), jaw(state.jaws.opening, -1)};
  for (int i = 0; i < last_; ++i) {
    int most = 0;
    for (const int side : {0, 1}) {
      const auto then = [&](int k) { return in_jaw(place(state.p_T, k), before[side]); };
      const auto now = [&](int k) { return in_jaw(place(p_T_, k), after[side]); };
      most = std::max(most, std::abs(toolkit::wound_through(then(i), then(i + 1), now(i), now(i + 1), params_.reach)));
    }
    if (most == 0) continue;
    state.passages += most;
    step.event(passage_, length_ * (i + 0.5) / (params_.places - 1));
  }
}

/// Reports whole turns; a reported turn stays until half of it is missing.
void Winding::tell(const CouplingStep& step, WindingState& state, double turns) const {
  const double sign = turns < 0 ? -1 : 1, size = std::abs(turns), before = sign * state.whole;
  double whole = std::floor(size + kMissing);
  if (whole < before && size + 2 * kMissing >= before) whole = before;
  const double now = whole == 0 ? 0 : sign * whole;
  if (now == state.whole) return;
  step.event(std::abs(now) > std::abs(state.whole) ? wound_ : unwound_, now);
  state.whole = now;
}

void Winding::resolve(const CouplingStep& step) {
  if (!go_on(step, step.state<WindingState>())) discard();
}

void Winding::finish(const CouplingStep& step) {
  WindingState& state = step.state<WindingState>();
  if (!go_on(step, state)) return discard();
  toolkit::Winding winding(params_.reach);
  for (int i = 0; i < last_; ++i) winding.add(place(p_T_, i), place(p_T_, i + 1));
  tell(step, state, winding.turns());
  step.signal(turns_, winding.turns());
  step.signal(whole_, state.whole);
  step.signal(behind_, winding.behind());
  step.signal(passages_, state.passages);
}

}  // namespace swage::coupling_winding

SWAGE_EXPORT(swage::coupling_winding::Winding)
