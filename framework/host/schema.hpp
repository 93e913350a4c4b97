// SPDX-License-Identifier: Apache-2.0
//
// JSON Schema draft-07, for editors that complete and check lesson files. Swage itself checks with
// params.hpp, whose messages are for people. [main]
#pragma once

#include <string>
#include <vector>

#include "host/plugin_info.hpp"

namespace swage::host {

/// Schema of the "params" object of one plugin.
std::string params_schema(const PluginInfo& plugin);

/// Schema of a lesson file that may use `plugins`.
std::string lesson_schema(const std::vector<PluginInfo>& plugins);

}  // namespace swage::host
