// SPDX-License-Identifier: Apache-2.0
//
// The track of a needle through tissue: supports at which the tissue holds it, length that its point has cut, place of exit. Plain doubles,
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

/// A place of the tissue that supports the needle.
struct Support {
  double p[3];              // m, O, position when the tissue is unloaded
  double rest;              // s at which its bristle is at rest
  double at;                // m, along the track from the entry
  double share;             // m, inserted length that it represents
  double across[3], along;  // N on the needle in the last step, across it in O and along its advance
  double given[3];          // m, O, displacement of the tissue there: p + given is its present position
  double rub;               // N, sum of forces across from opposite sides that cancel in `across` and yet cause friction
};

struct Track {
  static constexpr uint32_t kSupports = 4;
  // Stiffness of a support's bristle over that across the needle: it slips after drag / (4 side_stiffness), 1 um by default.
  static constexpr double kStick = 4;
  static constexpr uint32_t kTies = kSupports + 2;  // and one at the point, and one against rolling
  static constexpr uint32_t kOfPoint = kSupports,
                            kOfRoll = kSupports + 1;  // owner of a tie: the index of a support, or one of these
  // position of the point: inside, held by a face from inside, out again
  static constexpr double kInside = 0, kBreaking = 1, kOut = 2;

  double open;         // 0: there is no track
  double out;          // kInside, kBreaking, kOut
  double s_in, s_out;  // where the needle crosses the entry and the exit (0: the point is inside)
  double cut;          // m along the track, cut by the point
  double front[3];     // m, O, end of the cut when the tissue is unloaded
  double progress;     // m along the track, of the point
  double deepest;      // m, the farthest progress so far
  double below;        // m, greatest depth of the point below the entry surface
  double spacing;      // m between supports
  double thins;        // 1: every other support is losing its length, and is then removed
  double shared;       // m, progress when the length was last divided among the supports
  double cutting;      // N, of the tissue against the point in the last step
  double roll;         // N m, about the needle's advance: moment against rolling in the last step
  double count;        // of supports
  double entry, exit;  // index of the wound; exit: -1 before
  double passed;       // 1: the swage went in
  double peak_exit;    // N
  double age;          // number of the entry, to tell the newer track
  Support support[kSupports];
};

/// The needle and the tissue at the beginning of a call: laws, poses, and the needle's point in the tissue.
struct Site {
  Site(const Peer& a, const Peer& b, const Step& step_a, const Step& step_b);
  bool good = false;
  const Peer &needle, &tissue;
  Step a, b;
  swage_pierceable_law law{};
  uint32_t body = 0;  // of the tissue
  Pose X_WO;
  swage_piercing_place point{};       // the needle's place at s = 0
  swage_pierceable_place point_in{};  // the place of the point in the tissue
  double length = 1, radius = 1;      // m, of the needle and its wire

  Vec3 world(const double* p_O) const { return X_WO * Vec3(p_O[0], p_O[1], p_O[2]); }
  Vec3 local(const Vec3& p_W) const { return toolkit::rotated(X_WO.q.conjugate(), p_W - X_WO.p); }
  /// Depth of the point inside the nearest face [m], and the outward normal of that face.
  double inside(Vec3& normal_W) const;
};

/// The place of the needle at a support.
struct NeedlePoint {
  Vec3 p_W = Vec3::Zero();         // m, on the needle
  Vec3 advance_W = Vec3::UnitX();  // unit, direction in which the point advances
  double s = 0;                    // continues below 0 and above 1 beyond the ends
  double gone = 0;                 // m, length of the needle that has passed the unloaded position of the support
  uint32_t body = 0;
};

NeedlePoint needle_at(const Site& site, const Support& support);
/// True when the needle crosses a surface at s, and is not only near it.
inline bool through(double s) { return s > 0 && s < 1; }
/// Places of the needle at all supports of a track; entries of supports that are gone keep their values.
struct NeedlePoints {
  NeedlePoint support[Track::kSupports];
};
NeedlePoints needle_points(const Site& site, const Track& track);
/// s at which the needle crosses the plane of a wound, near s0; `place` is the needle there.
double crossing(const Site& site, const Wound& wound, double s0, swage_piercing_place& place);
/// The same for a plane through o with the normal n, in W.
double crossing(const Site& site, const Vec3& o, const Vec3& n, double s0, swage_piercing_place& place);

/// Opens the track of a needle that has just entered at `entry_W`, which crosses the surface at s_in.
void open_track(const Site& site, Track& track, const Vec3& entry_W, double s_in);
/// Updates the progress of the point along the track; drops supports that the point has left by going back.
void follow(const Site& site, const NeedlePoints& at, Track& track);
/// Divides the inserted length among the supports. Call at the end of a step: the predicted position does not count. Returns false when
/// no support is left in the tissue: the tear has reached the rim.
bool share_out(const Site& site, const NeedlePoints& at, Track& track);
/// When the needle's blunt end has left the last support, moves that support between the end and the exit: an inserted part stays held.
void support_end(const Site& site, NeedlePoints& at, Track& track);
/// True when the blunt end, which has entered, is out at the exit.
bool is_through(const Site& site, const Track& track);
/// Adds supports where the point has advanced; moves the last one where the point has gone back.
void lengthen(const Site& site, const NeedlePoints& at, Track& track);
/// Sets the end of the cut to the point, less the displacement of the tissue ahead of it.
void set_front(const Site& site, Track& track);
/// Writes the ties of the track to `out` (up to kTies). `reaction`: N added to the entry's drag; `exit_force`: N that a face inside bears.
/// Entry k of `of` is the support of tie k, or kOfPoint, kOfRoll. Does not change the track.
uint32_t make_ties(const Site& site, const Track& track, double reaction, double exit_force, swage_tie* out,
                   uint32_t* of);
/// Takes the solved force and slip of one tie. Returns the area torn sideways [m2].
double take_tie(const Site& site, Track& track, const swage_tie& tie, uint32_t of);

}  // namespace swage::coupling_pierce
