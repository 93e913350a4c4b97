// SPDX-License-Identifier: Apache-2.0
//
// Identifiers that are unique without a central register, times, and the name of this machine.
#pragma once

#include <string>
#include <string_view>

namespace swage::record {

/// UUID version 7 (RFC 9562): 48 bits of Unix milliseconds, 12 of a count, then random bits; text order is order of creation.
/// [any]
std::string make_id();

/// True when a text has the form of such an identifier. [any]
bool is_id(std::string_view text);

/// The present time as "2025-06-01T09:30:00.125Z". [any]
std::string utc_now();

/// The name of this machine. [any]
std::string station();

/// A short code that is easily read aloud: five digits and letters without I, L, O and U. [any]
std::string make_code();

}  // namespace swage::record
