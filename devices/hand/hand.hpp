// SPDX-License-Identifier: Apache-2.0
//
// A hand on file: where the tool frame T is at what time and how far the handle is closed. Format
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
// What a key leaves out stays as it was. An orientation is one of
//   "q": [w, x, y, z]      "rpy": [roll, pitch, yaw] about the fixed x, y, z axes in this order
//   "axis" and "closing": the directions of T's x (hinge to tip) and z (right to left jaw); z is made square
//   to x
// Instead of a pose a key may turn the tool about a line in the world, on a circle and not on its chord, as a
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
  bool turns = false;           // gets here on a circle from the key before:
  Vec3 about_W = Vec3::Zero();  // m, a point of the line
  Vec3 turn_W = Vec3::Zero();   // rad, rotation vector
};

/// What the hand does at one moment.
struct Moment {
  Pose X_WT;
  Vec3 v_W = Vec3::Zero();  // m/s, of T's origin
  Vec3 w_W = Vec3::Zero();  // rad/s
  double closure = 0;
  double grip = 0;  // N
};

enum class Between : int {
  kMinimumJerk,  // smooth, at rest in every key: how people reach (Flash and Hogan 1985)
  kLinear,       // straight: for dense samples
  kHold,         // the last sample, unchanged: for exact repetition
};

struct Hand {
  std::string title;
  std::vector<Key> keys;  // at least one, times rising
  bool sampled = false;   // came as "samples"
  bool has_grip = false;

  double duration() const { return keys.back().t; }  // s
  /// Before the first key and after the last one the hand rests there. [rt]
  Moment at(double t, Between between) const noexcept;
};

/// Reads a file. Throws std::runtime_error naming file and key. [main]
Hand load_hand(const std::string& path);
/// The same from text; `name` stands in messages.
Hand parse_hand(const std::string& text, const std::string& name);

/// Orientation whose x axis is `axis` and whose z axis is `closing` made square to it. Throws when they are
/// parallel.
Quat orientation(const Vec3& axis, const Vec3& closing);
/// The same from "axis" and "closing" of an object, which are given together; else fails through the reader. [main]
Quat read_attitude(const Reader& reader, const Json& value, const std::string& where);

}  // namespace swage::hand
