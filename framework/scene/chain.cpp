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
  ChainPlace best;
  double least = HUGE_VAL;
  for (uint32_t i = 0; i < chain.segments(); ++i) {
    if (!(chain.radius(i) > 0) || chain.p(i) == chain.p(i + 1)) continue;
    const ChainPlace place = place_on(chain, i, p_W);
    const double far =
        ((1 - place.share) * chain.p(i) + place.share * chain.p(i + 1) - p_W).squaredNorm();
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
