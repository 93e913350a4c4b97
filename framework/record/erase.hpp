// SPDX-License-Identifier: Apache-2.0
//
// Removal of a person from files that were written from the store. [main]
#pragma once

#include <string>

#include "record/school.hpp"

namespace swage::record {

/// Result for one file. `done`: the file has nothing of the person any more, or is deleted; else `sentence` says what to do.
struct Cleaned {
  bool done = false;
  std::string sentence;  // "ada.csv was deleted."
};

/// Deletes a file of this person alone; removes the person's part of a table, of statements and of a backup.
Cleaned erase_from_file(const ExportedFile&, const Person&);

}  // namespace swage::record
