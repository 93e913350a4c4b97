// SPDX-License-Identifier: Apache-2.0
//
// How much room the sparse solve of bands needs (sparse_space.hpp).
#pragma once

#include <cstdint>

namespace swage::dynamics {

/// Largest sizes of islands with bands.
struct SparseRoom {
  uint32_t vertices = 0;     // of all bands together; 0: there are none
  uint32_t constraints = 0;  // of one island
};

}  // namespace swage::dynamics
