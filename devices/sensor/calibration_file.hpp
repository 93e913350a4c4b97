// SPDX-License-Identifier: Apache-2.0
//
// Calibrations on disk: one JSON file per sensor, format swage-calibration/1, SI numbers. [main]
#pragma once

#include <string>
#include <vector>

#include "sensor/calibration.hpp"

namespace swage::sensor {

/// $XDG_DATA_HOME/swage/calibrations, or ~/.local/share/swage/calibrations.
std::string calibration_folder();
/// Where the calibration of a sensor is kept; "" for a serial that cannot name a file.
std::string calibration_path(const std::string& serial);
/// Files of the folder, sorted.
std::vector<std::string> calibration_files();

/// "" or a sentence with file, key, what is wrong and what is allowed. The curve is checked as in the model.
std::string load_calibration(const std::string& path, Calibration& out);
/// As it is written, JSON.
std::string calibration_text(const Calibration& calibration);
/// Written beside and renamed, so a file is whole or the old one. "" or a sentence.
std::string save_calibration(const std::string& path, const Calibration& calibration);

/// 2026-11-22, local.
std::string today();
/// A date `days` after another. "" for no date.
std::string days_after(const std::string& date, int days);
/// Whole days from one date to a later one; 0 where one of them is none.
int days_between(const std::string& from, const std::string& to);

}  // namespace swage::sensor
