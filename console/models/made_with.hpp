// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Provenance of numbers, in words: lesson and metric versions, input class, timing, solver, calibration.
#pragma once

#include <QStringList>
#include <functional>
#include <string>
#include <vector>

#include "record/export.hpp"

namespace swage::console {

/// Reads attempts with their export data, oldest first. `file`: a file of one attempt, "" for the store. On failure false and the error.
using ExportReader =
    std::function<bool(const std::string& file, const record::Selection& which, std::vector<record::Exported>& out, std::string& error)>;

/// One short phrase each; for several attempts each version once, and the number of attempts with a fault.
QStringList made_with(const std::vector<record::Exported>& attempts);

/// The data of one attempt as table rows: key and text of each item, then id, value and unit of each health counter.
std::string made_with_csv(const record::Exported& attempt);

}  // namespace swage::console
