// SPDX-License-Identifier: Apache-2.0
//
// A recorded or written hand motion: pose of the tool frame T and closure of the handle over time. Format
// "swage-hand/1".
//
//   { "format": "swage-hand/1", "title": "...",
//     "keys":    [ { "t": "0 s", "p": ["-12 mm", "0 mm", "6 mm"], "axis": [1, 0, 0], "closing": [0, 1, 0],
//     "closure": 0 },
//                  { "t": 1.2, "p": [...], "closure": 0.6 } ] }            <- people write this
//   { "format": "swage-hand/1", "title": "...",
//     "samples": [ [t, px, py, pz, qw, qx, qy, qz, closure], ... ] }       <- programs write this, optionally
//     with grip [N]
//
// Poses are X_WT, world frame, metres. Numbers are SI or strings with a unit (m mm um, s ms, rad deg, N mN).
// A field that a key omits keeps its value. An orientation is one of
//   "q": [w, x, y, z]      "rpy": [roll, pitch, yaw] about the fixed x, y, z axes in this order
//   "axis" and "closing": the directions of T's x (hinge to tip) and z (right to left jaw); z is made perpendicular
//   to x
// Instead of a pose a key may rotate the tool about a line in the world, on a circle instead of its chord, as a
// needle is driven along its own arc:
//   "turn": { "about": [x, y, z], "axis": [x, y, z], "angle": "90 deg" }
#pragma once

#include <string>
#include <vector>

#include "hand/reader.hpp"
#include "toolkit/math.hpp"

namespace swage::hand {

using toolkit::Pose;
using toolkit::Quat;
using toolkit::Vec3;

/// One line of the file.
struct Key {
  double t = 0;  // s
  Pose X_WT;
  double closure = 0;           // 0 open .. 1 closed
  double grip = 0;              // N at the handle, when the file has it
  bool turns = false;           // reached on a circle from the key before:
  Vec3 about_W = Vec3::Zero();  // m, a point of the line
  Vec3 turn_W = Vec3::Zero();   // rad, rotation vector
};

/// State of the hand at one time.
struct Moment {
  Pose X_WT;
  Vec3 v_W = Vec3::Zero();  // m/s, of T's origin
  Vec3 w_W = Vec3::Zero();  // rad/s
  double closure = 0;
  double grip = 0;  // N
};

enum class Between : int {
  kMinimumJerk,  // smooth, at rest in every key: human reaching movements (Flash and Hogan 1985)
  kLinear,       // straight: for dense samples
  kHold,         // the last sample, unchanged: for exact repetition
};

struct Hand {
  std::string title;
  std::vector<Key> keys;  // at least one, times rising
  bool sampled = false;   // read from "samples"
  bool has_grip = false;

  double duration() const { return keys.back().t; }  // s
  /// State at t; before the first key and after the last one the hand rests there. [rt]
  Moment at(double t, Between between) const noexcept;
};

/// Reads a file. Throws std::runtime_error naming file and key. [main]
Hand load_hand(const std::string& path);
/// The same from text; `name` identifies it in messages.
Hand parse_hand(const std::string& text, const std::string& name);

/// Orientation whose x axis is `axis` and whose z axis is `closing` made perpendicular to it. Throws when they are
/// parallel.
Quat orientation(const Vec3& axis, const Vec3& closing);
/// The same from "axis" and "closing" of an object, which must both be given; else fails through the reader. [main]
Quat read_attitude(const Reader& reader, const Json& value, const std::string& where);

}  // namespace swage::hand
