// SPDX-License-Identifier: Apache-2.0
//
// The way of a thread through tissue: the holes where it goes in and where it comes out. Plain doubles, part of the coupling's private
// state.
//
// Units SI. Frames: W, and O of the tissue's body. u is the arc length of the thread from the end that leads: it grows at a hole as the
// thread is drawn through. [rt]
#pragma once

#include <swage/abi/coupling.h>
#include <swage/peer.hpp>
#include <swage/strand.hpp>

#include <cstdint>

#include "toolkit/math.hpp"

namespace swage::coupling_pull_through {

using toolkit::Pose;
using toolkit::Vec3;

/// A place of the tissue through which the thread passes.
struct Hole {
  double p[3];              // m, O, where it is when nothing pulls at the tissue
  double first[3];          // m, O, where it was made
  double normal[3];         // O, unit, out of the tissue; of entry and exit
  double u;                 // m, of the material that is there
  double rest;              // m, u at which its bristle is at rest
  double share;             // m, length of the passage of whose stiffness and strength it has
  double across[3], along;  // N on the thread in the last step, across it in O and along its advance
  double given[3];          // m, O, by how much the tissue is displaced there
  double cut;               // m, way that it has been cut through the tissue
};

/// Properties of the passage.
struct PassageLaw {
  double drag = 0;            // N/m, per length inside
  double friction = 0;        // Coulomb's, of what bears on the side
  double side_stiffness = 0;  // N/m2, per length
  double failure_stress = 0;  // Pa, on the thread's side
  double saw = 0;             // m of cut per m of sliding at the force that tears
};

struct Passage {
  static constexpr uint32_t kHoles = 2;  // where it goes in, and where it comes out
  // Stiffness of a hole's bristle over that across the thread, as a needle's (coupling_pierce/track.hpp).
  static constexpr double kStick = 4;

  double count;  // of holes; 0: it is not in the tissue
  double out;    // 1: the leading end has come out, and the last hole is the exit
  Hole hole[kHoles];

  uint32_t holes() const { return static_cast<uint32_t>(count); }
  double inside() const;  // m, of thread between the first hole and the last, or the end; 0 where two holes have been torn into one
};

/// What a call needs to know about the two objects.
struct Site {
  Site(const StrandPeer& a, const Peer& b, const Step& step_a, const Step& step_b, bool last_leads);
  bool good = false;
  const StrandPeer& thread;
  const Peer& tissue;
  Step a, b;
  swage_strand_law strand{};
  swage_pierceable_law law{};
  bool last_leads = false;
  uint32_t body = 0;  // of the tissue
  Pose X_WO;

  /// The thread at u; `advance_W`: unit, the way in which it is drawn.
  struct Place {
    Vec3 p_W = Vec3::Zero(), advance_W = Vec3::UnitX();
    double u = 0, tension = 0;
    uint32_t body = 0;
    bool good = false;
  };
  Place place(double u) const;
  /// Unit, the way in which the thread is drawn at u: along the chord about u, which turns steadily where the thread has a corner.
  Vec3 way(double u) const;
  /// The place nearest to p_W, found from one near it: across its segment, or at a corner across the way there.
  Place near(double u, const Vec3& p_W) const;
  /// How far a place is inside the nearest face of the tissue [m], and that face's outward normal.
  double inside(const Vec3& p_W, Vec3& normal_W) const;
  Vec3 world(const double* p_O) const { return X_WO * Vec3(p_O[0], p_O[1], p_O[2]); }
  Vec3 local(const Vec3& p_W) const { return toolkit::rotated(X_WO.q.conjugate(), p_W - X_WO.p); }
};

/// The thread at a hole: m, what of it has gone by where the hole is when nothing pulls.
struct Spot {
  Site::Place at;
  double gone = 0;
};
Spot spot(const Site& site, const Hole& hole);

/// The thread lies through the tissue: it comes out where, seen from the leading end, it is first inside, and goes in where it last is. False
/// where it does not.
bool lie_through(const Site& site, Passage& passage);

enum class Change { kNone, kWentIn, kCameOut, kWentBack, kIsThrough };
/// After a step: the leading end goes in, on and out; holes that the thread has left close. `from` [m]: how deep the end goes before it
/// is in.
Change follow(const Site& site, Passage& passage, const PassageLaw& law, double from);
/// Its tie at one hole.
swage_tie tie_of(const Site& site, const PassageLaw& law, const Passage& passage, uint32_t i);
/// Takes what the solve gave that tie. Returns by how far the hole was cut [m].
double take_tie(const Site& site, const PassageLaw& law, const swage_tie& tie, Hole& hole);

}  // namespace swage::coupling_pull_through
