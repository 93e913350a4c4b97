// SPDX-License-Identifier: Apache-2.0
//
// Messages of the Inverse Service of Haply, versions 3.1 to 3.5, between its axes and the device frame D of Swage. Pure. [any]
// Source: docs.haply.co, Inverse SDK, "WebSocket protocol", "Control commands", "Basis permutation", tutorial 06.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "toolkit/math.hpp"

namespace swage::inverse3 {

using toolkit::Pose;
using toolkit::Quat;
using toolkit::Vec3;

/// An arm as one message of the service shows it. D: x right, y up, z towards the user.
struct Arm {
  std::string id;
  Vec3 p_D = Vec3::Zero(), v_D = Vec3::Zero();  // m, m/s, of the cursor
  std::string handedness;                       // "left", "right", "" where it is not told
  bool newer = false;                           // the service calls the values of a force "vector" (3.5) and not "values" (3.1)
};

/// The stylus, by cable or without.
struct Grip {
  Quat q_DG;             // G: its own axes, y along the stylus to its tip
  uint32_t buttons = 0;  // bit 0: a, 1: b, 2: c
  std::optional<double> battery;  // 0..1
};

struct Message {
  bool readable = false;  // it was JSON as the service sends it
  std::optional<Arm> arm;
  std::optional<Grip> grip;
  std::string others;  // ids of the arms that are not the wanted one
};

/// `arm`, `grip`: ids that are wanted, "" for the first. What is no finite number, or no rotation, counts as absent.
Message read_message(std::string_view text, const std::string& arm, const std::string& grip);

/// A force in newtons in D; the service answers each with one message.
std::string force_message(const std::string& arm, bool newer, const Vec3& force_D);
/// A message that moves nothing and asks for everything, for as long as no arm is known.
std::string asking_message();

}  // namespace swage::inverse3
