// SPDX-License-Identifier: Apache-2.0
#include "scene/chain.hpp"

#include <algorithm>
#include <cmath>

namespace swage::scene {

ChainPlace place_on(const ChainView& chain, uint32_t i, const toolkit::Vec3& p_W) noexcept {
  const toolkit::Vec3 p = chain.p(i), u = chain.p(i + 1) - p;
  const double share = std::clamp(u.dot(p_W - p) / u.squaredNorm(), 0.0, 1.0);
  return {i, share, chain.s(i) + share * (chain.s(i + 1) - chain.s(i))};
}

ChainPlace nearest_place(const ChainView& chain, const toolkit::Vec3& p_W) noexcept {
  constexpr double kSurely = 1.001;  // of the least square so far: a segment beyond it is farther, whatever the rounding
  ChainPlace best;
  double least = HUGE_VAL;
  toolkit::Vec3 p1 = chain.p(0), to1 = p_W - p1;
  double far1 = to1.squaredNorm();  // m2, of the end
  for (uint32_t i = 0; i < chain.segments(); ++i) {
    const toolkit::Vec3 p0 = p1, to0 = to1;
    const double far0 = far1;
    p1 = chain.p(i + 1), to1 = p_W - p1, far1 = to1.squaredNorm();
    const toolkit::Vec3 u = p1 - p0;
    const double length2 = u.squaredNorm(), along = u.dot(to0);
    const bool inside = along > 0 && along < length2;
    // the distance from the line is that from the segment or less; no quotient is needed to see that it is too far
    if (inside ? far0 * length2 - along * along > kSurely * least * length2 : std::min(far0, far1) > kSurely * least) continue;
    if (!(chain.radius(i) > 0) || p0 == p1) continue;
    const ChainPlace place = place_on(chain, i, p_W);
    const double far = ((1 - place.share) * p0 + place.share * p1 - p_W).squaredNorm();
    if (far < least) least = far, best = place;
  }
  return best;
}

void place_chain(World& world, const Shape& shape) noexcept {
  const ChainInfo& info = world.chain[shape.chain];
  const size_t n = info.start.size();
  double* at = world.plugin_state.data() + info.state;
  const toolkit::Pose X_WB(world.X_WB[shape.body]);
  for (size_t i = 0; i < n; ++i) {
    const toolkit::Vec3 p = X_WB * toolkit::vec(info.start[i]);
    for (size_t k = 0; k < 3; ++k) at[3 * i + k] = p[static_cast<Eigen::Index>(k)];
  }
  std::fill_n(at + 3 * n, 3 * n, 0.0);
  std::copy_n(info.s.begin(), n, at + 6 * n);
  std::copy_n(info.radius.begin(), n, at + 7 * n);
}

}  // namespace swage::scene
