// SPDX-License-Identifier: Apache-2.0
//
// What a skilled hand is to do: acts one after another, in the words of a surgeon and not in poses. Format "swage-plan/1":
//
//   { "format": "swage-plan/1", "title": "...",
//     "start": { "p": ["8 mm", "0 mm", "4 mm"], "axis": [-1, 0, 0], "closing": [0, 0, 1], "closure": 0.15 },
//     "acts": [ { "act": "reach", "s": 0.62, "past": "0.4 mm", "back": "3 mm", "from": [1, 0, 0], "time": "1.5 s" },
//               { "act": "close", "force": "0.6 N", "time": "1 s" }, ... ] }
//
//   wait   time
//   await  of, signal, more, less, time: until the signal of that instance has been within these for so long: another hand that
//          works on the same thing is answered by what it does, and not by the clock
//   await  mark, s, near, time: until the needle's place s has been so near to the mark for so long
//   reach  s, past, back, from, tilt, time: open jaws square around the wire at s (0 point .. 1 swage), coming along the normal
//          of the needle's plane from the side `from`; the tips reach `past` it, or stay `back` before it. With `keep` the
//          attitude stays, and s is a share of a thread's length: a strand among others is taken, whatever lies nearer
//   close  force or closure, time: closes until the grip has the force; takes at least `time`
//   open   closure, time
//   back   by, time: straight back along the jaws
//   move   by or at, roll or axis and closing, time: a way in the world, or to a place there; meanwhile it rolls about its own axis,
//          or turns until the jaws are as these say
//   draw   by, of, signal, less, time: by that way at most, ever slower as the signal comes near to `less`, and back while it is above:
//          a thread is drawn until it has that tension
//   bring  mark, s, time: what is held at s to where the mark is
//   aim    mark, into, across, hover, above, inside, time: the point before the mark, so that turning about the needle's own
//          centre leads it in there square; `into` a direction or the name of a tissue, `across` the normal of the needle's plane;
//          turned back along the arc by the hover, and straight out of the tissue by `above`; `inside` of the mark, towards the
//          needle's centre, by as much as the point will slide away from there while it presses and the needle bends
//   drive  angle, time: along its own arc, about its centre; meanwhile down by `above` where the act before it was such an aim
//   show   mark, at, with, across, time: waits until the mark moves, then holds the needle (or the jaws: `with`) up at `at`, pointing
//          to the mark, `across` being the normal of the needle's plane (or the closing direction)
//   answer mark, other, of, time: waits until the two marks part, then goes to the one to which the needle, or the shaft of the
//          gripper named by `of`, leans as it sees it
//   choose mark, of, signal, among, time: waits until the mark moves, then goes to one of the marks `among`: the first where the signal
//          is 1, the second where it is 2
//   wind   about, turns, along, in, of, signal, more, less, by, time: its tips go so many turns about the gripper named by `about`,
//          right-handed about the way from its hinge to its tips (negative: the other way), by `along` on that way, and nearer to it by
//          `in`, as a thread gets shorter that is wound; meanwhile
//          outwards by `by` in a second while the signal is below `more`, inwards while it is above `less`: a thread is kept drawn
//          by what the hand feels of it. With `rolls` the tool turns along, so that the thread leaves the jaws towards the gripper;
//          with `roll` it keeps its direction, out of the way of the other thread, and rolls about its own axis between the fingers.
//          With `follows` it goes where the gripper goes: a turn stays on tips that reach for a tail
//   again  from: on with that act, counted from 0; with of, signal, more, less, time: looks for so long, then on with that act if the
//          signal is within these, else with the next: a turn that slipped off is wound anew. Without a signal that act is an
//          earlier one; with a signal it may be a later one: what is held is not taken once more
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
  bool keep = false;            // the attitude, while it reaches
  bool to_place = false;        // a move to `at`
  Vec3 from = Vec3::UnitX();    // unit, W
  double tilt = 0;              // rad, of the jaws about the wire, from square
  double force = 0;             // N; 0: to the closure
  double closure = 1;           // 0..1
  double by = 0;                // m; of wind: m in a second
  Vec3 way = Vec3::Zero();      // m, W
  std::string mark;             // meaning
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
  bool rolls = false;           // the tool turns along
  bool follows = false;         // of wind: it goes along with the other gripper
  double roll = 0;              // rad, about its own axis
  bool turns_to = false;        // a move, to `attitude`
  toolkit::Quat attitude = toolkit::Quat::Identity();  // T in W
  std::string signal;           // id
  double more = -1e300, less = 1e300;  // of the signal, SI
  double near = 0;              // m
  size_t from_act = 0;

  /// An `again` that asks nothing.
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
