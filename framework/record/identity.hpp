// SPDX-License-Identifier: Apache-2.0
//
// Names that need no register: identifiers that two stations can never both make, times, this machine.
#pragma once

#include <string>
#include <string_view>

namespace swage::record {

/// UUID version 7 (RFC 9562): 48 bits of Unix milliseconds, 12 of a count, then random bits; text order is order of making.
/// [any]
std::string make_id();

/// Whether a text has the form of such an identifier. [any]
bool is_id(std::string_view text);

/// Now as "2025-06-01T09:30:00.125Z". [any]
std::string utc_now();

/// The name of this machine. [any]
std::string station();

/// A short code that is easily read aloud: five letters and digits without I, L, O and U. [any]
std::string make_code();

}  // namespace swage::record
