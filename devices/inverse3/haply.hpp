// SPDX-License-Identifier: Apache-2.0
//
// Messages of Haply's Inverse Service, versions 3.1 to 3.5, and their conversion to the device frame D of Swage. Pure. [any]
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

/// State of an arm in one message of the service. D: x right, y up, z towards the user.
struct Arm {
  std::string id;
  Vec3 p_D = Vec3::Zero(), v_D = Vec3::Zero();  // m, m/s, of the cursor
  std::string handedness;                       // "left", "right", "" where unknown
  bool newer = false;                           // the field with the components of a force is "vector" (3.5), not "values" (3.1)
};

/// The stylus, wired or wireless.
struct Grip {
  Quat q_DG;             // G: frame of the stylus, y along it towards its tip
  uint32_t buttons = 0;  // bit 0: a, 1: b, 2: c
  std::optional<double> battery;  // 0..1
};

struct Message {
  bool readable = false;  // valid JSON in the form that the service sends
  std::optional<Arm> arm;
  std::optional<Grip> grip;
  std::string others;  // ids of arms other than the wanted one
};

/// `arm`, `grip`: wanted ids, "" for the first. Values that are not finite, or not a rotation, count as absent.
Message read_message(std::string_view text, const std::string& arm, const std::string& grip);

/// Message with a force [N] in D; the service answers each with one message.
std::string force_message(const std::string& arm, bool newer, const Vec3& force_D);
/// Message without a force that requests the state, sent while no arm is known.
std::string asking_message();

}  // namespace swage::inverse3
