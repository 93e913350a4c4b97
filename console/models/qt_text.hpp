// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QString>
#include <string>

namespace swage::console {

/// UTF-8 text of the framework as Qt holds it.
inline QString qt(const std::string& s) { return QString::fromStdString(s); }

}  // namespace swage::console
