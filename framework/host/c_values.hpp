// SPDX-License-Identifier: Apache-2.0
//
// Conversion of values from the C boundary: a text may be NULL, a number may be anything. Header-only, any thread.
#pragma once

#include <cmath>
#include <string>

namespace swage::host {

/// The text, or "" for NULL.
inline std::string copy(const char* text) { return text != nullptr ? text : ""; }

/// Finite and above 0; false for NaN.
inline bool positive(double a) noexcept { return std::isfinite(a) && a > 0; }

}  // namespace swage::host
