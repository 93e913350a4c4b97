// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What surrounds a lesson's scene, as rows of the instructor's form: the medium, and the numbers that follow it.
#pragma once

#include <QVector>
#include <string>

#include "console/models/live_params.hpp"

namespace swage::console {

/// `section`: the JSON text of "environment" of the lesson, "" where it has none.
QVector<LiveParam> environment_params(const std::string& section);

}  // namespace swage::console
