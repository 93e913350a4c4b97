// SPDX-License-Identifier: Apache-2.0
//
// Drawn marks of wounds: torn places, where they lead, whether the needle is in them.
#include "pierce.hpp"

namespace swage::coupling_pierce {

using toolkit::raw;
using toolkit::vec;

/// Returns the s at which a needle crosses a wound, or 0.
double Pierce::filled_at(const PierceState& state, uint32_t wound) const {
  for (const Track& track : state.track) {
    if (track.open == 0) continue;
    if (track.entry == wound && through(track.s_in)) return track.s_in;
    if (track.exit == wound && through(track.s_out)) return track.s_out;
  }
  return 0;
}

/// Pose of a wound's plane in the world, as drawn. With `sweep` other than kNeedle the torn tissue is drawn displaced to the needle.
Pose Pierce::plane_in_world(const PierceState& state, const Site& site, uint32_t i) const {
  Pose X = site.X_WO;
  const double s = filled_at(state, i);
  if (params_.sweep == Sweep::kNeedle || s == 0) return X;
  const auto place = needle_.place(site.a, s);
  if (!place) return X;
  const Wound& wound = state.wound[i];
  const Vec3 n = X.q * axis(wound, 0), way = vec(place->p_W) - X * in_plane(wound, wound.centre);
  X.p += way - n.dot(way) * n;
  return X;
}

uint32_t Pierce::tears(const CouplingStep& step, std::span<swage_tear> out) {
  const Site site(needle_, tissue_, step.a(), step.b());
  const auto& state = step.state<PierceState>();
  uint32_t n = 0;
  for (uint32_t i = 0; site.good && i < PierceState::kWounds; ++i) {
    const Wound& wound = state.wound[i];
    if (wound.open == 0) continue;
    const Pose X = plane_in_world(state, site, i);
    const auto world = [&](const double* at) { return raw(X * in_plane(wound, at)); };
    const swage_vec3 normal_W = raw(X.q * axis(wound, 0));
    const auto put = [&](const double* a, const double* b) {
      if (n < out.size()) out[n++] = {world(a), world(b), normal_W, wound.radius, i, 0};
    };
    for (uint32_t k = 0; k < static_cast<uint32_t>(wound.count); ++k)
      put(wound.capsule[k].a, wound.capsule[k].b);
    put(wound.centre, wound.centre);
  }
  return n;
}

uint32_t Pierce::wounds(const CouplingStep& step, std::span<swage_wound> out) {
  const Site site(needle_, tissue_, step.a(), step.b());
  const auto& state = step.state<PierceState>();
  uint32_t n = 0;
  for (uint32_t i = 0; site.good && i < PierceState::kWounds && n < out.size(); ++i) {
    const Wound& wound = state.wound[i];
    if (wound.open == 0) continue;
    const Pose X = plane_in_world(state, site, i);
    const uint32_t filled = filled_at(state, i) > 0 ? 1 : 0;
    out[n++] = {raw(X * in_plane(wound, wound.centre)),
                raw(X.q * Vec3(wound.inward[0], wound.inward[1], wound.inward[2])),
                wound.depth,
                wound.area,
                i,
                filled};
  }
  return n;
}

}  // namespace swage::coupling_pierce
