// SPDX-License-Identifier: Apache-2.0
//
// Live parameters: from a JSON object to commands, checked like a lesson file. Threads: [main].
#pragma once

#include <string>
#include <vector>

#include "base/problem.hpp"
#include "host/instance.hpp"
#include "host/params.hpp"
#include "step/command.hpp"

namespace swage::session {

/// One command per key of `params_json`. False, and no commands, when a key is unknown, not LIVE, or its value is wrong.
/// `ordinal`: of the instance, in the order of host::instances().
bool live_commands(const host::Instance& instance, uint32_t ordinal, const host::ParamTable& table,
                   const std::string& params_json, std::vector<step::Command>& out, base::Problems& problems);

}  // namespace swage::session
