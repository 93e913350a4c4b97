// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What numbers were measured with and how well, in words: lesson and metric versions, class of input, timing, solver, calibration.
#pragma once

#include <QStringList>
#include <functional>
#include <string>
#include <vector>

#include "record/export.hpp"

namespace swage::console {

/// Attempts with all that an export says of them, oldest first. `file`: a file of one attempt, "" for the store. False and why not.
using ExportReader =
    std::function<bool(const std::string& file, const record::Selection& which, std::vector<record::Exported>& out, std::string& error)>;

/// One short phrase each; of several attempts each version once, and in how many of them something was at fault.
QStringList made_with(const std::vector<record::Exported>& attempts);

/// The same of one attempt as lines of a table: key and text of what it is, then id, value and unit of each count of its health.
std::string made_with_csv(const record::Exported& attempt);

}  // namespace swage::console
