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
/// Path of the calibration of a sensor; "" for a serial number that cannot be a file name.
std::string calibration_path(const std::string& serial);
/// Files of the folder, sorted.
std::vector<std::string> calibration_files();

/// "" or a sentence with file, key, fault and allowed values. The curve is checked as in the model.
std::string load_calibration(const std::string& path, Calibration& out);
/// The calibration as JSON, as it is saved.
std::string calibration_text(const Calibration& calibration);
/// Writes a temporary file and renames it, so that a crash leaves the whole new file or the old one. "" or a sentence.
std::string save_calibration(const std::string& path, const Calibration& calibration);

/// Today's date, local, as 2026-11-22.
std::string today();
/// The date `days` after another. "" for an invalid date.
std::string days_after(const std::string& date, int days);
/// Whole days from one date to a later one; 0 where one of them is invalid.
int days_between(const std::string& from, const std::string& to);

}  // namespace swage::sensor
