// SPDX-License-Identifier: Apache-2.0
//
// The passage of a thread through tissue: the holes where it enters and where it comes out. Plain doubles, part of the coupling's private
// state.
//
// Units SI. Frames: W, and O of the tissue's body. u is the arc length of the thread from its leading end: at a hole it grows as the
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
  double p[3];              // m, O, position when the tissue is unloaded
  double first[3];          // m, O, where the hole was made
  double normal[3];         // O, unit, out of the tissue; of entry and exit
  double u;                 // m, of the thread's material at the hole
  double rest;              // m, u at which its bristle is at rest
  double share;             // m, length of the passage that the hole represents: stiffness and strength are proportional to it
  double across[3], along;  // N on the thread in the last step, across it in O and along its advance
  double given[3];          // m, O, by how much the tissue is displaced there
  double cut;               // m, length by which the thread has cut the tissue here
};

/// Properties of the passage.
struct PassageLaw {
  double drag = 0;            // N/m, per length inside
  double friction = 0;        // Coulomb's coefficient, for the force across
  double side_stiffness = 0;  // N/m2, per length
  double failure_stress = 0;  // Pa, of the tissue under the thread's side
  double saw = 0;             // m of cut per m of sliding at the force that tears
};

struct Passage {
  static constexpr uint32_t kHoles = 2;  // the entry, and the exit
  // Stiffness of a hole's bristle over that across the thread, as a needle's (coupling_pierce/track.hpp).
  static constexpr double kStick = 4;

  double count;  // number of holes; 0: the thread is not in the tissue
  double out;    // 1: the leading end has come out, and the last hole is the exit
  Hole hole[kHoles];

  uint32_t holes() const { return static_cast<uint32_t>(count); }
  double inside() const;  // m, thread between the first hole and the last, or the leading end; 0 where two holes have torn into one
};

/// The thread and the tissue at the beginning of a call.
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

  /// The place of the thread at u; `advance_W`: unit, the direction in which it is drawn.
  struct Place {
    Vec3 p_W = Vec3::Zero(), advance_W = Vec3::UnitX();
    double u = 0, tension = 0;
    uint32_t body = 0;
    bool good = false;
  };
  Place place(double u) const;
  /// Unit, direction in which the thread is drawn at u: along the chord about u, which is continuous where the thread has a corner.
  Vec3 way(double u) const;
  /// The place nearest to p_W, searched from u: across its segment, or at a corner across the direction there.
  Place near(double u, const Vec3& p_W) const;
  /// Depth of a place inside the nearest face of the tissue [m], and the outward normal of that face.
  double inside(const Vec3& p_W, Vec3& normal_W) const;
  Vec3 world(const double* p_O) const { return X_WO * Vec3(p_O[0], p_O[1], p_O[2]); }
  Vec3 local(const Vec3& p_W) const { return toolkit::rotated(X_WO.q.conjugate(), p_W - X_WO.p); }
};

/// The thread at a hole, and `gone` [m], the thread length that has passed the unloaded position of the hole.
struct Spot {
  Site::Place at;
  double gone = 0;
};
Spot spot(const Site& site, const Hole& hole);

/// For a thread that starts in the tissue: from the leading end on, the exit is where it is first inside, the entry where it last is.
/// False where it is nowhere inside.
bool lie_through(const Site& site, Passage& passage);

enum class Change { kNone, kWentIn, kCameOut, kWentBack, kIsThrough };
/// After a step: the leading end enters, advances, comes out; holes that the thread has left close. `from` [m]: depth of the end to be
/// counted as entered.
Change follow(const Site& site, Passage& passage, const PassageLaw& law, double from);
/// The tie at one hole.
swage_tie tie_of(const Site& site, const PassageLaw& law, const Passage& passage, uint32_t i);
/// Takes the solved force and slip of that tie. Returns the length by which the hole was cut [m].
double take_tie(const Site& site, const PassageLaw& law, const swage_tie& tie, Hole& hole);
/// Takes the hole as made where it is: nothing of it has been cut.
void begin_here(Hole& hole);

}  // namespace swage::coupling_pull_through
