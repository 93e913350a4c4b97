// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The environment of a lesson's scene as rows of the instructor's form: the medium, and the numbers that depend on it.
#pragma once

#include <QVector>
#include <string>

#include "console/models/live_params.hpp"

namespace swage::console {

/// `section`: JSON text of the lesson's "environment", "" where it has none.
QVector<LiveParam> environment_params(const std::string& section);

}  // namespace swage::console
