// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Attempts as tables for other programs. People are named by their code alone.
#pragma once

#include <string>
#include <vector>

#include "record/store.hpp"

namespace swage::console {

/// Long form: a line per attempt and metric, SI units, the decimal sign a point. An attempt without metrics has one line.
std::string attempts_csv(const std::vector<record::AttemptRow>& attempts);

}  // namespace swage::console
