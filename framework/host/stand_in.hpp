// SPDX-License-Identifier: Apache-2.0
//
// A stand-in for a device: in a replay the samples come from the recording, so the device plugin is not called and need not be
// installed. [main]
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "host/instance.hpp"

namespace swage::host {

/// An instance that offers swage.device/1 with these flags, opens, and never gives a new sample.
std::unique_ptr<Instance> stand_in_device(const std::string& name, const std::string& plugin_id,
                                          const std::string& plugin_version, uint32_t flags,
                                          const Shared& shared);

}  // namespace swage::host
