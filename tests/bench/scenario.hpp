// SPDX-License-Identifier: Apache-2.0
//
// What is asked of every method: hold, pull, pinch, shoot, spin, bounce. SI units; the names S.. are those of
// the stability catalogue (stability.hpp).
#pragma once

#include <vector>

#include "engine.hpp"
#include "timing.hpp"

namespace swage::bench {

struct Slip {
  double along = 0, across = 0,
         normal =
             0;  // m, of the gripped place in the tool's frame: along the wire, along the jaws, through them
  double turn = 0;  // rad
  double distance() const { return std::sqrt(along * along + across * across + normal * normal); }
};

struct HoldResult {
  Slip after_1s, after_10s, end;
  double worst = 0;     // m, largest slip seen
  double lost_at = -1;  // s; -1: held to the end
  Times step;           // ns
};
/// What the tool does while it holds.
enum class Tool {
  kStill,   // S04, S05; with encoder noise `amount` [m] on every sample: S28
  kMoving,  // turns 60 deg and moves 5 mm at 1 Hz: S06
  kLate,    // the same at a tenth of the size, its samples arriving every `amount` [s]: S27
};
/// Both jaws fixed at `overlap` each [m], gravity along the wire.
HoldResult hold(const Method&, const Setup&, double overlap, double seconds, Tool = Tool::kStill,
                double amount = 0);

/// Directions of pulling against the pinch.
enum class Pull { kAxial, kAboutWire, kAboutNormal };
struct PullResult {
  double onset = 0;  // load at first slip over the Coulomb limit (coulomb.hpp); 0: lost before
  double creep = 0;  // m (or m at the wire's end) at half the limit
  Times step;        // ns
};
/// The upper jaw pinches with `grip` [N]; a load ramps to 1.5 times the Coulomb limit between faces that stand as these
/// do. S09, S10.
PullResult pull(const Method&, const Setup&, double grip, Pull direction);

/// The same pinch bears `share` of the limit for `seconds` [s]: how far the wire creeps once the load is on [m].
double creep(const Method&, const Setup&, double grip, Pull direction, double share, double seconds);

struct PinchStage {
  double grip = 0, overlap = 0, drift = 0;  // N, m, m
  std::vector<double> ns;                   // processor time of every step
};
/// Grip from 1 mN to 16 N, times 4 each 0.2 s; ends where the needle is lost. S07; S08 with `approach`: from
/// 0.5 mm at 20 mm/s.
std::vector<PinchStage> pinch(const Method&, const Setup&, double approach = 0);

enum class Shot { kFlat, kEdge, kSpin };
/// Shoots the needle at a fixed jaw at `speed`, 16 phases of the step; how many went through. S13.
int tunnelled(const Method&, const Setup&, double speed, Shot);
/// Both jaws close on the resting needle at `speed` [m/s] at the grip; S14.
struct CloseResult {
  bool through = false;
  double fastest = 0;  // m/s of the needle afterwards
};
CloseResult close_on(const Method&, const Setup&, double speed);

struct TopResult {
  double energy = 0;  // worst |E/E0 - 1|
  double momentum = 0;
  double period = 0;  // s; 0: no flips seen
  double diverged_at = -1;
  Quat end = Quat::Identity();  // attitude at the end
  Times step;
};
/// Torque-free top with moments I and start w0 in its own frame. S17.
TopResult top(const Method&, const Setup&, const Vec3& inertia, const Vec3& w0, double seconds);

/// Rebound height over e^2 h, worst deviation from 1 over 16 phases of the step; infinity when it fell
/// through. S18.
double bounce_error(const Method&, const Setup&, double height, double restitution, double radius);

/// How far the scene, grasped and moved for half a second with `units_per_metre`, differs from the engine's own units: largest
/// distance over the needle's length, or infinity when the contacts of a step differ. S01.
double unit_error(const Method&, double units_per_metre);

/// Processor time of each of `count` steps of the same scene [ns]. Table 6-2.
std::vector<double> loops(const Method&, int count);

/// The coefficient of friction at which a needle gripped with its plane `off_flat` [rad] begins to roll flat, over the one that
/// statics gives (flip_statics.hpp). S11.
double flip_friction(const Method&, double off_flat);

/// The half angle of the wedge between two faces at which it spits a wire out, over the angle of friction atan(mu). S12.
double wedge_angle(const Method&, double friction);

/// Relative ripple of the gap between the jaws while the wire is dragged through the pinch [m]. S16.
double drag_ripple(const Method&, double speed);

/// Largest distance between two runs of the same grasp [m]; the second runs after another scene has been made and stepped. S26.
double repeat_error(const Method&, double seconds);

/// |rate of a straight needle lying along a jaw that turns up / rate of the jaw - 1|. S29.
double carried_error(const Method&, double rate);

}  // namespace swage::bench
