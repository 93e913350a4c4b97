// SPDX-License-Identifier: Apache-2.0
//
// A new store of what a damaged one still holds. [main]
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace swage::record {

struct Salvaged {
  uint64_t whole = 0;      // attempts with their recording
  uint64_t shortened = 0;  // attempts whose recording ends early; result and metrics as they were
  uint64_t altered = 0;    // attempts whose recording is whole, and of whose rows some are lost or not what they were
  uint64_t headless = 0;   // attempts of which only pieces were left: nothing of them is in the new store
  uint64_t rows = 0, lost_rows = 0;
  std::string damaged;  // where the damaged store lies now
};

/// Puts a new store in the place of the damaged one, which is kept beside it under another name. False with a sentence; then
/// everything is as it was. Refuses while another program uses the store.
bool salvage_in_place(const std::string& store, Salvaged& out, std::string& error);

/// The same into a new file; the damaged one is only read.
bool salvage(const std::string& damaged, const std::string& fresh, Salvaged& out, std::string& error);

}  // namespace swage::record
