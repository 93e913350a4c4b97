// SPDX-License-Identifier: Apache-2.0
//
// The same as params.hpp for callers that already hold parsed JSON (assembly, schema, sidecar). [main]
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "host/params.hpp"

namespace swage::host {

bool check_params_json(const nlohmann::ordered_json& object, const ParamTable& table,
                       const ParamSource& source, ParamValues& out, base::Problems& problems);

nlohmann::ordered_json table_to_json(const ParamTable& table);

/// False when the JSON is not what table_to_json writes.
bool table_from_json(const nlohmann::ordered_json& json, ParamTable& out);

}  // namespace swage::host
