// SPDX-License-Identifier: Apache-2.0
//
// As params.hpp, for callers that already hold parsed JSON (assembly, schema, sidecar). [main]
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "host/params.hpp"

namespace swage::host {

bool check_params_json(const nlohmann::ordered_json& object, const ParamTable& table,
                       const ParamSource& source, ParamValues& out, base::Problems& problems);

nlohmann::ordered_json table_to_json(const ParamTable& table);

/// False when the JSON does not have the form written by table_to_json.
bool table_from_json(const nlohmann::ordered_json& json, ParamTable& out);

}  // namespace swage::host
