// SPDX-License-Identifier: Apache-2.0
//
// How the scene was displayed during an attempt: stored with it as a small JSON file.
#pragma once

#include <string>

namespace swage::record {

struct Display {
  std::string mode = {};  // name of the arrangement: "mono", "side", "lines", ...; "": no viewer, or not recorded
  bool stereo = false;        // a separate image for each eye
  bool eyes_swapped = false;  // left and right exchanged
  std::string mirror = {};    // "", "left_right", "up_down"
  double scale = 0;           // size on the screen over size in the scene; 0: unknown
  bool guided = false;        // an expert's instruments were shown beside the trainee's
  bool operator==(const Display&) const = default;
};

/// Name of the file among those of an attempt. A lesson cannot use this file name.
inline constexpr const char* kDisplayFile = "swage:display";
/// Names of calibrations among the files of an attempt; the name of the device follows.
inline constexpr const char* kCalibrationFile = "swage:calibration:";

/// Format swage-display/1.
std::string to_json(const Display& display);
/// False for a text of another format; `out` is then unchanged.
bool from_json(const std::string& text, Display& out);

/// For people and tables: "side, eyes swapped, mirrored left_right, scale 1, guided"; "" without a viewer.
std::string words(const Display& display);

}  // namespace swage::record
