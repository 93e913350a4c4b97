// SPDX-License-Identifier: Apache-2.0
//
// The tests of `swage validate` that step a plugin in a scene of its own: an object alone, a coupling between two objects that
// offer what it needs, a device without an object. A lesson plugin needs its own scene: validate a lesson file.
#pragma once

#include <string>
#include <vector>

#include "host/validate.hpp"

namespace swage::tools {

/// `plugin_dirs`: further folders with objects that a coupling can bind. `with`: a lesson file whose scene is used for the tests
/// instead of a generated one; "" for none.
std::vector<host::ValidateTest> stepping_tests(const std::vector<std::string>& plugin_dirs, const std::string& with = "");

}  // namespace swage::tools
