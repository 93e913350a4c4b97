// SPDX-License-Identifier: Apache-2.0
//
// A needle in tissue, with the bundles as they ship: what the catalogue asks of it (S40 to S45, S48). [main]
#pragma once

#include <string>
#include <vector>

namespace swage::bench {

/// Ways of computing it, by the names that charts show; the first is our default.
struct InsertionMethod {
  std::string family, name;
};
const std::vector<InsertionMethod>& insertion_methods();

/// Whether a scenario of the catalogue is one of these.
bool is_insertion(const std::string& scenario);

/// Energy that one step made, over the most that was stored; infinite when the needle did not do what it was to do, or a step did
/// not converge. `value`: of the swept parameter, SI. Throws std::runtime_error for an unknown scenario.
double insertion_error(const std::string& scenario, const std::string& method, double value);

}  // namespace swage::bench
