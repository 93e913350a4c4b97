// SPDX-License-Identifier: Apache-2.0
//
// What is left of a person in files that were written from the store. [main]
#pragma once

#include <string>

#include "record/school.hpp"

namespace swage::record {

/// What became of one file. `done`: nothing of the person is in it any more, or it is gone; else `sentence` says what to do.
struct Cleaned {
  bool done = false;
  std::string sentence;  // "ada.csv was deleted."
};

/// A file of this person alone is deleted; of a table, of statements and of a backup the person's part is taken out.
Cleaned erase_from_file(const ExportedFile&, const Person&);

}  // namespace swage::record
