// SPDX-License-Identifier: Apache-2.0
//
// The state of a chain: the 8 n private doubles in which its object keeps vertices, velocities, arc lengths and radii
// (swage/abi/builder.h).
//
// Units: SI. Frame: W. Threads: [rt].
#pragma once

#include "scene/world.hpp"
#include "toolkit/math.hpp"

namespace swage::scene {

/// In the flags of a shape of kind CHAIN, beside SWAGE_SHAPE_*: it is touched at its vertices only (SWAGE_CHAIN_SPHERES).
inline constexpr uint32_t kChainOfSpheres = 1u << 16;

/// A place on the centre line of a chain: at the fraction `share` of the segment from vertex `segment` to the next.
struct ChainPlace {
  uint32_t segment = kNone;  // kNone: on no chain
  double share = 0;          // 0..1
  double s = 0;              // m, arc length
};

/// Reads the chain; valid while the world lives.
class ChainView {
 public:
  ChainView(const World& world, const ChainInfo& info) noexcept
      : ChainView(world.plugin_state.data(), info) {}
  /// `state`: all private doubles of a world.
  ChainView(const double* state, const ChainInfo& info) noexcept
      : n_(info.start.size()), at_(state + info.state) {}

  uint32_t vertices() const noexcept { return static_cast<uint32_t>(n_); }
  uint32_t segments() const noexcept { return static_cast<uint32_t>(n_ - 1); }
  /// m
  toolkit::Vec3 p(size_t i) const noexcept { return {at_[3 * i], at_[3 * i + 1], at_[3 * i + 2]}; }
  /// m/s, mean velocity over the step that ended at p(i).
  toolkit::Vec3 v(size_t i) const noexcept {
    const double* v = at_ + 3 * (n_ + i);
    return {v[0], v[1], v[2]};
  }
  /// m, arc length.
  double s(size_t i) const noexcept { return at_[6 * n_ + i]; }
  /// m, of the segment from vertex i on; 0: the segment is cut out.
  double radius(size_t i) const noexcept { return at_[7 * n_ + i]; }

 private:
  size_t n_;
  const double* at_;
};

/// Number of private doubles of a chain of n vertices.
inline constexpr uint32_t chain_doubles(uint32_t n) { return 8 * n; }

/// The place nearest to p_W on one segment, or on a whole chain; its segment is kNone where none is left.
ChainPlace place_on(const ChainView& chain, uint32_t segment, const toolkit::Vec3& p_W) noexcept;
ChainPlace nearest_place(const ChainView& chain, const toolkit::Vec3& p_W) noexcept;

/// [rt] Puts a chain back to where it was declared on its body, at rest.
void place_chain(World& world, const Shape& shape) noexcept;

}  // namespace swage::scene
