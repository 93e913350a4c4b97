// SPDX-License-Identifier: Apache-2.0
//
// The way of a needle through tissue: places where the tissue holds it, how far its point has cut, where it comes out. Plain doubles,
// part of the coupling's private state.
//
// Units SI. Frames: W, and O of the tissue's body. Needle coordinate s: 0 at the point, 1 at the swage. [rt]
#pragma once

#include <swage/abi/coupling.h>
#include <swage/peer.hpp>

#include <cstdint>

#include "wound.hpp"

namespace swage::coupling_pierce {

using toolkit::Pose;

/// A place of the tissue that holds the needle.
struct Support {
  double p[3];              // m, O, where it is when nothing pulls at the tissue
  double rest;              // s at which its bristle is at rest
  double at;                // m, along the track from the entry
  double share;             // m, inserted length that it stands for
  double across[3], along;  // N on the needle in the last step, across it in O and along its advance
  double given[3];          // m, O, by how much the tissue is displaced there: p + given is where it is now
  double rub;               // N across it from opposite sides, which cancels there and rubs all the same
};

struct Track {
  static constexpr uint32_t kSupports = 4;
  // Stiffness of a support's bristle over that across the needle: it breaks away after drag / (4 side_stiffness), 1 um by default.
  static constexpr double kStick = 4;
  static constexpr uint32_t kTies = kSupports + 2;  // and the point, and what keeps it from rolling
  static constexpr uint32_t kOfPoint = kSupports,
                            kOfRoll = kSupports + 1;  // whose a tie is: of a support, or of these
  // where the point is: inside, held by a face from inside, out again
  static constexpr double kInside = 0, kBreaking = 1, kOut = 2;

  double open;         // 0: not there
  double out;          // kInside, kBreaking, kOut
  double s_in, s_out;  // where the needle crosses the entry and the exit (0: the point is inside)
  double cut;          // m along the track that the point has opened
  double front[3];     // m, O, where the cut ends when nothing pulls at the tissue
  double progress;     // m along the track, of the point
  double deepest;      // m, the farthest progress so far
  double below;        // m, the deepest of the point below the entry surface
  double spacing;      // m between supports
  double thins;        // 1: every other support is on its way to nothing
  double shared;       // m, the progress when its length was last divided among the supports
  double roll;         // N m, about its advance, that kept it from rolling in the last step
  double count;        // of supports
  double entry, exit;  // index of the wound; exit: -1 before
  double passed;       // 1: the swage went in
  double peak_exit;    // N
  double age;          // number of the entry, to tell the newer
  Support support[kSupports];
};

/// A contact site: what a call needs to know about the two objects.
struct Site {
  Site(const Peer& a, const Peer& b, const Step& step_a, const Step& step_b);
  bool good = false;
  const Peer &needle, &tissue;
  Step a, b;
  swage_pierceable_law law{};
  uint32_t body = 0;  // of the tissue
  Pose X_WO;
  swage_piercing_place point{};       // at s = 0
  swage_pierceable_place point_in{};  // where the point is in the tissue
  double length = 1, radius = 1;      // m, of the needle and its wire

  Vec3 world(const double* p_O) const { return X_WO * Vec3(p_O[0], p_O[1], p_O[2]); }
  Vec3 local(const Vec3& p_W) const { return toolkit::rotated(X_WO.q.conjugate(), p_W - X_WO.p); }
  /// How far the point is inside the nearest face [m], and that face's outward normal.
  double inside(Vec3& normal_W) const;
};

/// The needle at a support.
struct NeedlePoint {
  Vec3 p_W = Vec3::Zero();         // m, of the needle
  Vec3 advance_W = Vec3::UnitX();  // unit, the way of its point
  double s = 0;                    // goes on below 0 and above 1 beyond its ends
  double gone = 0;                 // m, of the needle that has gone by where the place is when nothing pulls
  uint32_t body = 0;
};

NeedlePoint needle_at(const Site& site, const Support& support);
/// Whether the needle crosses a surface at s, and is not only near it.
inline bool through(double s) { return s > 0 && s < 1; }
/// The same at all supports of a track; those that it no longer has are left as they are.
struct NeedlePoints {
  NeedlePoint support[Track::kSupports];
};
NeedlePoints needle_points(const Site& site, const Track& track);
/// s at which the needle crosses the plane of a wound, near s0, and the needle there.
double crossing(const Site& site, const Wound& wound, double s0, swage_piercing_place& place);
/// The same for a plane through o with the normal n, in W.
double crossing(const Site& site, const Vec3& o, const Vec3& n, double s0, swage_piercing_place& place);

/// The track of a needle that has just gone in at `entry_W`, crossed there at s_in.
void open_track(const Site& site, Track& track, const Vec3& entry_W, double s_in);
/// Where the point is along it; drops supports that it has left behind.
void follow(const Site& site, const NeedlePoints& at, Track& track);
/// Divides the inserted length among the supports. At the end of a step: where the needle is predicted to be says nothing yet. False when
/// none is left in the tissue: the tear has come to its rim.
bool share_out(const Site& site, const NeedlePoints& at, Track& track);
/// When the needle's blunt end has left the last support, that is laid again between the end and the exit: what is in is held until it is out.
void support_end(const Site& site, NeedlePoints& at, Track& track);
/// Whether its blunt end, which went in, is out at the exit.
bool is_through(const Site& site, const Track& track);
/// New supports where the point went on; the last one laid again where it went back.
void lengthen(const Site& site, const NeedlePoints& at, Track& track);
/// The cut ends where the point is, but for what the tissue gives ahead of it.
void set_front(const Site& site, Track& track);
/// Writes its ties to `out` (up to kTies): `reaction`: N on top of the entry's drag; `exit_force`: N that a face bears from inside.
/// Entry k of `of` is the support of tie k, or kOfPoint, kOfRoll. Changes nothing.
uint32_t make_ties(const Site& site, const Track& track, double reaction, double exit_force, swage_tie* out,
                   uint32_t* of);
/// Takes what the solve gave one tie. Returns the area that it gave way sideways [m2].
double take_tie(const Site& site, Track& track, const swage_tie& tie, uint32_t of);

}  // namespace swage::coupling_pierce
