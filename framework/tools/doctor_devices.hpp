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
  std::string command;       // what to type, as far as one command mends it
};

/// Every device, with its defaults. The command is that which installs the plugin's udev rule, where it asks for it by the name
/// "70-<id>.rules" (beside the plugin, or in share/swage/udev); else what it says in parentheses from "sudo" on.
std::vector<DeviceState> ask_devices(const host::Catalogue& catalogue);

}  // namespace swage::tools
