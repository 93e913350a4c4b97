// SPDX-License-Identifier: Apache-2.0
//
// A checksum over the rows of an ended attempt, so that a flipped bit in a score or a name is detected. Chunks and files
// have their own checksums, which are included here. Code that changes a row of an ended attempt must seal it again. [main]
#pragma once

#include <string>

#include "record/sql.hpp"

namespace swage::record {

/// Writes the checksum of an attempt's present rows, the first one or a new one.
bool seal_attempt(Database&, const std::string& attempt_id);

/// True when an attempt's rows match its seal; true for one without a seal.
bool seal_holds(Database&, const std::string& attempt_id);

/// Seals ended attempts without a seal: imported or merged ones, or those of an earlier version. At most `most`, so
/// that a school's store is not blocked for long.
void seal_unsealed(Database&, int most);

/// A sentence on the attempts whose rows do not match their seals; "" when there are none. Reads every row but the recordings.
std::string broken_seals(Database&);

}  // namespace swage::record
