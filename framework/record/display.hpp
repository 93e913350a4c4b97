// SPDX-License-Identifier: Apache-2.0
//
// How the scene was seen while an attempt was made: kept with it as a small file of its own, in JSON.
#pragma once

#include <string>

namespace swage::record {

struct Display {
  std::string mode = {};  // name of the arrangement: "mono", "side", "lines", ...; "": nobody looked, or the attempt does not say
  bool stereo = false;        // a picture for each eye
  bool eyes_swapped = false;  // left and right exchanged
  std::string mirror = {};    // "", "left_right", "up_down"
  double scale = 0;           // size on the screen over size in the scene where that is known; 0: not known
  bool guided = false;        // an expert's instruments were shown beside one's own
  bool operator==(const Display&) const = default;
};

/// Name of the file among those of an attempt. A lesson cannot name such a file.
inline constexpr const char* kDisplayFile = "swage:display";
/// Names of calibrations among the files of an attempt; the name of the device follows.
inline constexpr const char* kCalibrationFile = "swage:calibration:";

/// Format swage-display/1.
std::string to_json(const Display& display);
/// False for a text of another format; then `out` is as it was.
bool from_json(const std::string& text, Display& out);

/// For people and tables: "side, eyes swapped, mirrored left_right, scale 1, guided"; "" when nobody looked.
std::string words(const Display& display);

}  // namespace swage::record
