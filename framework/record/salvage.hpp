// SPDX-License-Identifier: Apache-2.0
//
// Makes a new store from the readable parts of a damaged one. [main]
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace swage::record {

struct Salvaged {
  uint64_t whole = 0;      // attempts with their recording
  uint64_t shortened = 0;  // attempts whose recording ends early; result and metrics are complete
  uint64_t altered = 0;    // attempts with a complete recording, some of whose rows are lost or changed
  uint64_t headless = 0;   // attempts of which only pieces were left: they are not in the new store
  uint64_t rows = 0, lost_rows = 0;
  std::string damaged;  // new path of the damaged store
};

/// Replaces the damaged store by a new one and keeps it beside it under another name. False with a sentence; then
/// nothing has changed. Refuses while another program uses the store.
bool salvage_in_place(const std::string& store, Salvaged& out, std::string& error);

/// The same into a new file; the damaged store is only read.
bool salvage(const std::string& damaged, const std::string& fresh, Salvaged& out, std::string& error);

}  // namespace swage::record
