// SPDX-License-Identifier: Apache-2.0
//
// A device that is not there: in a replay the samples come from the recording, so no device plugin is asked, nor need it be
// installed. [main]
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "host/instance.hpp"

namespace swage::host {

/// An instance that offers swage.device/1 with these flags, opens, and never has anything new to say.
std::unique_ptr<Instance> stand_in_device(const std::string& name, const std::string& plugin_id,
                                          const std::string& plugin_version, uint32_t flags,
                                          const Shared& shared);

}  // namespace swage::host
