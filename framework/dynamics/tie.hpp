// SPDX-License-Identifier: Apache-2.0
//
// A compliant link between two bodies and its law: along its axis a bristle that slides beyond a limit, across it a spring that
// yields beyond its strength. Both limits are constants of the step, so the force is minus the gradient of a convex energy.
//
//     f_along  = clamp(-k_along s, -forward, backward)
//     f_across = -k_across s,  returned radially to `strength`
//
// Header-only, [rt].
#pragma once

#include <cmath>
#include <cstdint>

#include "dynamics/contact_law.hpp"
#include "scene/world.hpp"
#include "toolkit/math.hpp"

namespace swage::dynamics {

using toolkit::Vec3;

struct TieLaw {
  double k_across = 0, k_along = 0;  // N/m
  double strength = HUGE_VAL;        // N
  double forward_limit = HUGE_VAL;   // N, limit of the force on a while a moves along +axis
  double backward_limit = HUGE_VAL;  // N, the same along -axis
};

/// One tie of a step. Frame W, global bodies; kNone: the world.
struct Tie {
  uint32_t body_a = scene::kNone, body_b = scene::kNone;
  Vec3 p_W = Vec3::Zero();       // m, where it acts on both, at the predicted poses
  Vec3 axis_W = Vec3::UnitX();   // unit
  Vec3 offset_W = Vec3::Zero();  // m, displacement of a relative to b from rest, at the predicted poses
  TieLaw law;
  Vec3 f_a_W = Vec3::Zero();  // N on a; before the solve that of the last step, where it starts, 0 where none is known
  // --- results of the solve
  Vec3 plastic_slip_W = Vec3::Zero();  // m, plastic part of the displacement
};

// The law piece by piece, as in contact_law.hpp: sticks or slips along the axis and, independently, across it

/// Slip along the axis has a side of its own: a slack film (backward limit 0), continued beyond its range, bears nothing and does not pull with all
/// its force.
enum class Along : uint8_t { kStick, kForward, kBackward };
struct TiePieces {
  Along along = Along::kStick;
  Piece across = Piece::kStick;
};

inline TiePieces tie_pieces(const TieLaw& law, const Displacement& d) {
  const double along = -law.k_along * d.g;
  return {along < -law.forward_limit ? Along::kForward : along > law.backward_limit ? Along::kBackward : Along::kStick,
          law.k_across * std::sqrt(d.s1 * d.s1 + d.s2 * d.s2) <= law.strength ? Piece::kStick : Piece::kSlip};
}

/// Force on a, on given pieces, continued beyond their own range. In the axes of the tie, g is along and s1, s2 are across.
inline Force tie_force_on(const TiePieces& on, const TieLaw& law, const Displacement& d) {
  Force f{-law.k_along * d.g, -law.k_across * d.s1, -law.k_across * d.s2, on.across == Piece::kSlip};
  if (on.along != Along::kStick) f.fn = on.along == Along::kForward ? -law.forward_limit : law.backward_limit;
  if (!f.slips) return f;
  const double across = std::sqrt(f.f1 * f.f1 + f.f2 * f.f2), back = across > 0 ? law.strength / across : 0.0;
  f.f1 *= back, f.f2 *= back;
  return f;
}

inline Tangent tie_tangent_on(const TiePieces& on, const TieLaw& law, const Displacement& d) {
  Tangent t;
  if (on.along == Along::kStick) t.nn = law.k_along;
  if (on.across == Piece::kStick) {
    t.t11 = t.t22 = law.k_across;
    return t;
  }
  const double length = std::sqrt(d.s1 * d.s1 + d.s2 * d.s2);
  if (!(length > 0)) return t;
  const double e1 = d.s1 / length, e2 = d.s2 / length, k = law.strength / length;
  t.t11 = k * e2 * e2, t.t12 = -k * e1 * e2, t.t22 = k * e1 * e1;
  return t;
}

/// Force on a.
inline Force tie_force(const TieLaw& law, const Displacement& d) { return tie_force_on(tie_pieces(law, d), law, d); }

/// -d force / d displacement: symmetric, positive semi-definite.
inline Tangent tie_tangent(const TieLaw& law, const Displacement& d) {
  return tie_tangent_on(tie_pieces(law, d), law, d);
}

/// Pieces on which a force of an earlier step or pass was, in the present axes.
inline TiePieces tie_pieces_before(const TieLaw& law, const Force& f) {
  constexpr double kNearly = 0.999;  // the axes may have turned by a thousandth
  return {f.fn >= kNearly * law.backward_limit    ? Along::kBackward
          : f.fn <= -kNearly * law.forward_limit ? Along::kForward
                                                 : Along::kStick,
          std::sqrt(f.f1 * f.f1 + f.f2 * f.f2) >= kNearly * law.strength ? Piece::kSlip : Piece::kStick};
}

/// The first t > 0 at which d + t e leaves one of the pieces, and the pieces from there on.
struct TieKink {
  double t = HUGE_VAL;
  TiePieces next;
};

inline TieKink tie_kink(const TiePieces& on, const TieLaw& law, const Displacement& d, const Displacement& e) {
  TieKink kink{HUGE_VAL, on};
  const bool sticks = on.along == Along::kStick, forward = sticks ? e.g > 0 : on.along == Along::kForward;
  // k_along times the displacement at which it begins to slip or, where it slips, at which it sticks again
  const double end = forward ? law.forward_limit : -law.backward_limit;
  if (e.g != 0 && (sticks || forward == (e.g < 0)) && law.k_along > 0 && std::isfinite(end)) {
    kink.t = std::fmax(0.0, (end / law.k_along - d.g) / e.g);
    kink.next.along = !sticks ? Along::kStick : forward ? Along::kForward : Along::kBackward;
  }
  if (!(law.k_across > 0) || !std::isfinite(law.strength)) return kink;
  const double limit = law.strength / law.k_across;
  const double t = zero_of(on.across == Piece::kStick, e.s1 * e.s1 + e.s2 * e.s2, d.s1 * e.s1 + d.s2 * e.s2,
                           d.s1 * d.s1 + d.s2 * d.s2 - limit * limit);
  if (!(t < kink.t)) return kink;
  kink = {t, on};
  kink.next.across = on.across == Piece::kStick ? Piece::kSlip : Piece::kStick;
  return kink;
}

/// The plastic part of the displacement: slip along, yielding across [m].
inline Displacement tie_plastic_slip(const TieLaw& law, const Displacement& d, const Force& f) {
  Displacement slid;
  if (law.k_along > 0) slid.g = d.g + f.fn / law.k_along;
  if (law.k_across > 0) slid.s1 = d.s1 + f.f1 / law.k_across, slid.s2 = d.s2 + f.f2 / law.k_across;
  return slid;
}

/// Energy whose gradient is minus the force [J].
inline double tie_energy(const TieLaw& law, const Displacement& d) {
  const double most = d.g > 0 ? law.forward_limit : law.backward_limit, s = std::abs(d.g);
  const double along =
      law.k_along * s <= most ? 0.5 * law.k_along * s * s : most * (s - 0.5 * most / law.k_along);
  const double r = std::sqrt(d.s1 * d.s1 + d.s2 * d.s2);
  const double across = law.k_across * r <= law.strength
                            ? 0.5 * law.k_across * r * r
                            : law.strength * (r - 0.5 * law.strength / law.k_across);
  return along + across;
}

}  // namespace swage::dynamics
