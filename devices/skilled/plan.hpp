// SPDX-License-Identifier: Apache-2.0
//
// The task of a skilled hand: a sequence of acts, in the terms of a surgeon instead of poses. Format "swage-plan/1":
//
//   { "format": "swage-plan/1", "title": "...",
//     "start": { "p": ["8 mm", "0 mm", "4 mm"], "axis": [-1, 0, 0], "closing": [0, 0, 1], "closure": 0.15 },
//     "acts": [ { "act": "reach", "s": 0.62, "past": "0.4 mm", "back": "3 mm", "from": [1, 0, 0], "time": "1.5 s" },
//               { "act": "close", "force": "0.6 N", "time": "1 s" }, ... ] }
//
//   wait   time
//   await  of, signal, more, less, time: until the signal of that instance has been within these limits for this time: reacts to another
//          hand that works on the same object instead of following the clock
//   await  mark, s, near, time: until the needle's place s has been within `near` of the mark for this time
//   reach  s, past, back, from, tilt, time: open jaws perpendicular around the wire at s (0 point .. 1 swage), approaching along the normal
//          of the needle's plane from the side `from`; the tips reach `past` it, or stay `back` before it. With `keep` the
//          attitude stays, and s is a share of a thread's length: selects a strand among others, even if another is nearer
//   close  force or closure, time: closes until the grip has the force; takes at least `time`
//   open   closure, time
//   back   by, time: straight back along the jaws
//   move   by or at, roll or axis and closing, time: by a displacement in the world, or to a place; meanwhile rolls about its own axis,
//          or turns until the jaws have these directions
//   draw   by, of, signal, less, time: by at most that displacement, more slowly as the signal nears `less`, and back while it is above:
//          a thread is drawn until it has that tension
//   bring  mark, s, time: moves the place s of the held object to the mark
//   aim    mark, into, across, hover, above, inside, time: brings the point before the mark, so that rotation about the needle's own
//          centre leads it in perpendicularly; `into` a direction or the name of a tissue, `across` the normal of the needle's plane;
//          turned back along the arc by the hover, and straight out of the tissue by `above`; `inside` of the mark, towards the
//          needle's centre, by the distance that the point will slide away while it presses and the needle bends
//   drive  angle, time: along its own arc, about its centre; meanwhile down by `above` where the act before it was such an aim
//   show   mark, at, with, across, time: waits until the mark moves, then holds the needle (or the jaws: `with`) up at `at`, pointing
//          to the mark, `across` being the normal of the needle's plane (or the closing direction)
//   answer mark, other, of, time: waits until the two marks part, then moves to the mark to which the needle, or the shaft of the
//          gripper named by `of`, appears to lean
//   choose mark, of, signal, among, time: waits until the mark moves, then moves to one of the marks `among`: the first where the signal
//          is 1, the second where it is 2
//   wind   about, turns, along, of, signal, more, less, by, time: moves its tips by so many turns about the gripper named by `about`,
//          right-handed about the direction from its hinge to its tips (negative: left-handed), by `along` in it, and nearer by
//          `in`, as a thread that is wound gets shorter; meanwhile outwards by `by` per second while the signal is below `more`,
//          inwards while it is above `less`: keeps a thread taut by the force that the hand feels. With `rolls` the tool turns along, so that the thread leaves the jaws towards the gripper;
//          with `roll` it keeps its direction, away from the other thread, and rolls about its own axis between the fingers.
//          With `follows` it moves with the gripper: a turn stays on tips that reach for a tail
//   again  from: continues with that act, counted from 0; with of, signal, more, less, time: observes for that time, then continues with
//          that act if the signal is within these limits, else with the next: a turn that slipped off is wound again. With a
//          signal the act may be a later one: what is held already is not taken again
#pragma once

#include <string>
#include <vector>

#include "toolkit/math.hpp"

namespace swage::skilled {

using toolkit::Pose;
using toolkit::Vec3;

enum class Verb : int {
  kWait,
  kAwait,
  kReach,
  kClose,
  kOpen,
  kBack,
  kMove,
  kDraw,
  kBring,
  kAim,
  kDrive,
  kShow,
  kAnswer,
  kChoose,
  kWind,
  kAgain
};

struct Act {
  Verb verb = Verb::kWait;
  double time = 1;              // s
  double s = 0.6;               // 0 point .. 1 swage
  double past = 0, back = 0;    // m
  bool keep = false;            // reach: the attitude is kept
  bool to_place = false;        // move: to the place `at`
  Vec3 from = Vec3::UnitX();    // unit, W
  double tilt = 0;              // rad, of the jaws about the wire, from perpendicular
  double force = 0;             // N; 0: closes to `closure`
  double closure = 1;           // 0..1
  double by = 0;                // m; of wind: m/s
  Vec3 way = Vec3::Zero();      // m, W, displacement
  std::string mark;             // meaning of the mark
  std::string tissue;           // name of an object, or "" for `into`
  Vec3 into = -Vec3::UnitZ();   // unit, W
  Vec3 across = Vec3::UnitY();  // W
  double hover = 0;             // m, along the arc
  double above = 0;             // m, against `into`
  double inside = 0;            // m, towards the needle's centre
  double angle = 0;             // rad
  Vec3 at = Vec3::Zero();       // m, W
  bool jaws = false;            // show: the jaws and not the needle
  std::string other, of;        // meaning of a mark; name of an object, of await: of any instance
  std::vector<std::string> among;  // of choose: meanings of marks
  std::string about;            // of wind: name of a gripper
  double turns = 0, along = 0, in = 0;  // 1, m, m
  bool rolls = false;           // wind: the tool turns with the winding
  bool follows = false;         // wind: the tool moves with the other gripper
  double roll = 0;              // rad, about its own axis
  bool turns_to = false;        // move: turns to `attitude`
  toolkit::Quat attitude = toolkit::Quat::Identity();  // T in W
  std::string signal;           // id
  double more = -1e300, less = 1e300;  // of the signal, SI
  double near = 0;              // m
  size_t from_act = 0;

  /// True for an `again` without a condition.
  bool is_loop() const { return verb == Verb::kAgain && signal.empty(); }
};

struct Plan {
  std::string title;
  Pose start;
  double closure = 0;
  std::vector<Act> acts;
};

/// Throws std::runtime_error naming file and key. [main]
Plan load_plan(const std::string& path);
Plan parse_plan(const std::string& text, const std::string& name);

}  // namespace swage::skilled
