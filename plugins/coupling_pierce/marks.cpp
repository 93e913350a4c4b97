// SPDX-License-Identifier: Apache-2.0
//
// Drawn marks of wounds: torn places, where they lead, whether the needle is in them.
#include <algorithm>
#include <cmath>

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

// Wounds come first: of many capsules the last have no room.
void Pierce::draw(const CouplingStep& step, Visuals& out) {
  const Site site(needle_, tissue_, step.a(), step.b());
  if (!site.good) return;
  const auto& state = step.state<PierceState>();
  const auto each = [&](const auto& put) {
    for (uint32_t i = 0; i < PierceState::kWounds; ++i)
      if (state.wound[i].open != 0) put(i, state.wound[i], plane_in_world(state, site, i));
  };
  each([&](uint32_t i, const Wound& wound, const Pose& X) {
    const Vec3 p_W = X * in_plane(wound, wound.centre), inward_W = X.q * Vec3(wound.inward[0], wound.inward[1], wound.inward[2]);
    out.wound(i, raw(p_W), raw(Vec3(p_W + wound.depth * inward_W)), raw(inward_W), std::sqrt(std::max(0.0, wound.area) / M_PI),
              filled_at(state, i) > 0);
  });
  each([&](uint32_t i, const Wound& wound, const Pose& X) {
    const swage_vec3 normal_W = raw(X.q * axis(wound, 0));
    const auto put = [&](const double* a, const double* b) {
      out.tear(i, raw(X * in_plane(wound, a)), raw(X * in_plane(wound, b)), normal_W, wound.radius);
    };
    for (uint32_t k = 0; k < static_cast<uint32_t>(wound.count); ++k) put(wound.capsule[k].a, wound.capsule[k].b);
    put(wound.centre, wound.centre);
  });
}

}  // namespace swage::coupling_pierce
