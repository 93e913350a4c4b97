// SPDX-License-Identifier: Apache-2.0
#include "step/hand_filter.hpp"

#include <cmath>
#include <numbers>

#include "toolkit/math.hpp"

namespace swage::step {
namespace {

using toolkit::Pose;
using toolkit::Quat;
using toolkit::Vec3;

// part of a vector beyond `band`
Vec3 beyond(const Vec3& a, double band) {
  const double length = a.norm();
  return length > band ? Vec3(a * (1 - band / length)) : Vec3(Vec3::Zero());
}

}  // namespace

swage_pose filtered(const host::HandFilters& f, FilterMemory& memory, const swage_pose& in, bool returns, double dt) noexcept {
  const Pose now(in);
  const bool fresh = memory.started == 0 || returns;
  if (fresh) memory.low = in;
  // under rate control a returning hand continues from the last output
  if (fresh && f.rate <= 0) memory.out = in;
  memory.started = 1;

  Pose low(memory.low), out(memory.out);
  const double share = f.low_pass > 0 ? 1 - std::exp(-2 * std::numbers::pi * f.low_pass * dt) : 1;
  low.p += share * (now.p - low.p);
  low.q = (toolkit::exp_rotation(share * toolkit::log_rotation(now.q * low.q.conjugate())) * low.q).normalized();

  const bool leads = f.rate > 0;
  const double gain = leads ? f.rate * dt : 1;
  const Vec3 way = leads ? low.p : Vec3(low.p - out.p);
  const Vec3 turn = toolkit::log_rotation(leads ? low.q : Quat(low.q * out.q.conjugate()));
  out.p += gain * beyond(way, f.dead_band);
  out.q = (toolkit::exp_rotation(gain * beyond(turn, f.dead_turn)) * out.q).normalized();
  memory.low = low.abi();
  memory.out = out.abi();
  return memory.out;
}

}  // namespace swage::step
