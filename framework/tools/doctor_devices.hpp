// SPDX-License-Identifier: Apache-2.0
//
// What swage doctor says of the drivers of hardware: each is opened once, in a process of its own. [main]
#pragma once

#include <string>
#include <vector>

#include "host/catalogue.hpp"

namespace swage::tools {

struct DeviceState {
  std::string id;
  bool ready = false;        // it opened
  std::string text, remedy;  // remedy: "" when it is ready
};

/// Every device that is asked on a thread of its own, with its defaults.
std::vector<DeviceState> ask_devices(const host::Catalogue& catalogue);

}  // namespace swage::tools
