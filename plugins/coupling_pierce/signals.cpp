// SPDX-License-Identifier: Apache-2.0
//
// Signals and events that the coupling reports, as listed in coupling_pierce.md.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "pierce.hpp"

namespace swage::coupling_pierce {

using toolkit::vec;

void Pierce::declare(CouplingBuilder& builder) {
  const auto place = [&builder](Signal(&signal)[3], const char* const(&ids)[3], const char* doc) {
    for (int i = 0; i < 3; ++i) signal[i] = builder.signal(ids[i], "m", doc);
  };
  state_ =
      builder.signal("pierce.state", "1", "0 away, 1 touching, 2 in the tissue, 3 in it with the point out.");
  angle_ = builder.signal("pierce.angle", "rad", "Between the needle and the inward normal; 0 when away.");
  cosine_ =
      builder.signal("pierce.cosine", "1", "Of the angle between needle and surface: 0 perfect, 1 worst.");
  force_ = builder.signal("pierce.force", "N", "Against the needle's advance, along itself; 0 when away.");
  lateral_signal_ = builder.signal("pierce.lateral", "N", "On the needle, across itself; 0 when away.");
  pull_signal_ = builder.signal("pierce.pull", "N", "On the tissue along its surface; 0 when away.");
  peak_entry_ = builder.signal("pierce.peak_entry", "N", "Greatest normal force before the point went in.");
  peak_exit_ = builder.signal("pierce.peak_exit", "N", "Greatest force before the point came out, 0 before.");
  s_ = builder.signal("pierce.s", "1", "Where the needle crosses the entry surface; 0 when away.");
  depth_ = builder.signal("pierce.depth", "m", "Inserted length along the needle; 0 when away.");
  below_ =
      builder.signal("pierce.below", "m", "The deepest that the point has been below the entry surface.");
  place(at_, {"pierce.at_x", "pierce.at_y", "pierce.at_z"},
        "Where the needle crosses or touches the surface, W.");
  place(entry_, {"pierce.entry_x", "pierce.entry_y", "pierce.entry_z"}, "First puncture, W.");
  place(exit_, {"pierce.exit_x", "pierce.exit_y", "pierce.exit_z"}, "Where the point came out, W.");
  wound_ =
      builder.signal("pierce.wound", "1", "Reach of the entry wound over the wire's radius: 1 is perfect.");
  area_ = builder.signal("pierce.area", "m2", "Torn area of the entry wound.");
  area_ratio_ = builder.signal("pierce.area_ratio", "1", "That over the wire's section: 1 is perfect.");
  exit_wound_ =
      builder.signal("pierce.exit_wound", "1", "Reach of the exit wound over the wire's radius, 0 before.");
  exit_area_ = builder.signal("pierce.exit_area", "m2", "Torn area of the exit wound, 0 before.");
  swept_ = builder.signal("pierce.swept", "m2", "Area swept sideways inside the tissue, where it gave way.");
  entries_ = builder.signal("pierce.entries", "1", "How often the point went in so far.");
  deflections_ = builder.signal("pierce.deflections", "1", "How often it was deflected so far.");
  law_signal_ = builder.signal("pierce.law", "1", "Index of the reaction law.");
  wound_wide_ =
      builder.signal("pierce.wound_wide", "1",
                     "Edge of the entry wound from its own centre over the wire's radius: 1 is perfect.");
  exit_wide_ = builder.signal("pierce.exit_wide", "1", "The same of the exit wound, 0 before.");
  declare_events(builder);
}

void Pierce::declare_events(CouplingBuilder& builder) {
  touched_ =
      builder.event("pierce.touched", "The point presses, after at least 0.15 s without; value: angle, rad.");
  entered_ = builder.event("pierce.entered", "The point went in; value: angle to the inward normal, rad.");
  exited_ = builder.event("pierce.exited", "The point came out; value: angle to the outward normal, rad.");
  back_out_ =
      builder.event("pierce.back_out", "It left by the way it came; value: how far it had been in, m.");
  passed_ = builder.event("pierce.passed", "The swage went in; value: wound ratio.");
  deflected_ = builder.event("pierce.deflected", "Refused because of its angle; value: that angle, rad.");
  torn_ = builder.event("pierce.torn", "A wound begins to tear, whatever the lesson allows; value: wound ratio.");
  cut_out_ =
      builder.event("pierce.cut_out", "The tear came to the tissue's rim and let it go; value: wound ratio.");
}

void Pierce::tell_place(const CouplingStep& step, const Signal (&signal)[3], const double* p_W) const {
  for (int i = 0; i < 3; ++i) step.signal(signal[i], p_W[i]);
}

void Pierce::tell(const CouplingStep& step, const PierceState& state, const Site& site,
                  const Press& press) const {
  const Track& track = state.track[static_cast<uint32_t>(state.newest)];
  if (track.open != 0) {
    tell_track(step, state, site, press);
  } else {
    const bool touching = press.force > 0;
    const double angle = touching ? angle_of_point(site, press.normal_W) : 0;
    step.signal(state_, touching ? 1 : 0);
    step.signal(angle_, angle);
    step.signal(cosine_, std::sin(angle));
    const Vec3 n = press.normal_W, t = vec(site.point.tangent_W);
    step.signal(force_, touching ? press.force * std::max(0.0, n.dot(t)) : 0);
    step.signal(lateral_signal_, touching ? press.force * n.cross(t).norm() : 0);
    step.signal(pull_signal_, 0);
    step.signal(s_, 0);
    step.signal(depth_, 0);
    if (touching) tell_place(step, at_, press.surface_W.data());
  }
  tell_wounds(step, state);
}

void Pierce::tell_track(const CouplingStep& step, const PierceState& state, const Site& site,
                        const Press& press) const {
  const Track& track = state.track[static_cast<uint32_t>(state.newest)];
  const double angle = angle_in(site, track, state);
  const bool out = track.out == Track::kOut;
  step.signal(state_, out && track.s_out > 0 ? 3 : 2);
  step.signal(angle_, angle);
  step.signal(cosine_, std::sin(angle));
  step.signal(force_, along_ + press.force);
  step.signal(lateral_signal_, lateral_);
  step.signal(pull_signal_, pull_);
  step.signal(s_, track.s_in);
  step.signal(depth_, std::max(0.0, track.s_in - (out ? track.s_out : 0)) * site.length);
  step.signal(below_, track.below);
  const auto place = needle_.place(site.a, track.s_in);
  // a blunt end that is inside no longer crosses the entry
  if (place && track.s_in < 1) tell_place(step, at_, &place->p_W.x);
}

void Pierce::tell_wounds(const CouplingStep& step, const PierceState& state) const {
  step.signal(peak_entry_, state.peak_entry);
  step.signal(peak_exit_, state.peak_exit);
  tell_place(step, entry_, state.entry_p);
  tell_place(step, exit_, state.exit_p);
  if (state.last_entry >= 0) {
    const Wound& wound = state.wound[static_cast<uint32_t>(state.last_entry)];
    step.signal(wound_, wound.reach / wound.radius);
    step.signal(wound_wide_, wound.wide / wound.radius);
    step.signal(area_, wound.area);
    step.signal(area_ratio_, wound.area / (std::numbers::pi * wound.radius * wound.radius));
  }
  const bool out = state.last_exit >= 0;
  const Wound& exit = state.wound[out ? static_cast<uint32_t>(state.last_exit) : 0];
  step.signal(exit_wound_, out ? exit.reach / exit.radius : 0);
  step.signal(exit_wide_, out ? exit.wide / exit.radius : 0);
  step.signal(exit_area_, out ? exit.area : 0);
  step.signal(swept_, state.swept);
  step.signal(entries_, state.entries);
  step.signal(deflections_, state.deflections);
  step.signal(law_signal_, static_cast<double>(params_.law));
}

}  // namespace swage::coupling_pierce
