// SPDX-License-Identifier: Apache-2.0
//
// Check of hardware drivers by swage doctor: each is opened once, in a process of its own. [main]
#pragma once

#include <string>
#include <vector>

#include "host/catalogue.hpp"

namespace swage::tools {

struct DeviceState {
  std::string id;
  bool ready = false;        // the device opened
  std::string text, remedy;  // remedy: "" when it is ready
  std::string command;       // command to type, if one command is the remedy
};

/// Opens every device with its defaults. The command installs the plugin's udev rule if the device's report names "70-<id>.rules"
/// (beside the plugin, or in share/swage/udev); otherwise it is the text in parentheses that begins with "sudo".
std::vector<DeviceState> ask_devices(const host::Catalogue& catalogue);

}  // namespace swage::tools
