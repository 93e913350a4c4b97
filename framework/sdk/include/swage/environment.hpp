// SPDX-License-Identifier: Apache-2.0
//
// The surroundings that a lesson sets: fluid, film, charge, damping.
#pragma once

#include <swage/abi/environment.h>

namespace swage {

/// Still air at 20 deg C, the default of a scene whose lesson sets none.
inline constexpr swage_environment kStillAir{sizeof(swage_environment), SWAGE_MEDIUM_UNSET, 1.2, 1.8e-5, 0, 0, 0, 0, 0, 0, 0, 0, 0};

/// The surroundings; the same from configure on. Still air from a host without the extension. [any]
inline swage_environment environment(const swage_host& host) {
  swage_environment out = kStillAir;
  const auto* table = static_cast<const swage_host_environment*>(host.get_extension(&host, SWAGE_HOST_ENVIRONMENT));
  if (table != nullptr) table->read(&host, &out);
  return out;
}

}  // namespace swage
