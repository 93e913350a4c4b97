// SPDX-License-Identifier: Apache-2.0
//
// What comes over the C boundary as it may come: a text that may be NULL, a number that may be anything. Header-only, any thread.
#pragma once

#include <cmath>
#include <string>

namespace swage::host {

/// The text, or "" for NULL.
inline std::string copy(const char* text) { return text != nullptr ? text : ""; }

/// Finite and above 0; false for NaN.
inline bool positive(double a) noexcept { return std::isfinite(a) && a > 0; }

}  // namespace swage::host
