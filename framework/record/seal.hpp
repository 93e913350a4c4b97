// SPDX-License-Identifier: Apache-2.0
//
// A checksum over the rows of an attempt that has ended, so that a bit that flips in a score or a name is found. Chunks and files
// have checksums of their own; those are summed up here. Whoever changes a row of an ended attempt must seal it again. [main]
#pragma once

#include <string>

#include "record/sql.hpp"

namespace swage::record {

/// Writes the checksum of an attempt, or that of its rows as they are now.
bool seal_attempt(Database&, const std::string& attempt_id);

/// Whether an attempt is what it was when it was sealed; true for one without a seal.
bool seal_holds(Database&, const std::string& attempt_id);

/// Seals attempts that have ended and have no seal yet: imported or merged ones, or those of an earlier version. At most `most`, so
/// that a school's store is not held up.
void seal_unsealed(Database&, int most);

/// The attempts whose rows are no longer what they were, as a sentence; "" when there is none. Reads every row but the recordings.
std::string broken_seals(Database&);

}  // namespace swage::record
