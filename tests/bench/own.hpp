// SPDX-License-Identifier: Apache-2.0
//
// What the catalogue asks of our rooms alone, with no peer beside them: shots at thin things (S46), couples on light needles (S47). [main]
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace swage::bench {

/// A way of computing it, by the name that charts show. `measure` takes the value of the sweep, SI, and the shots at each value.
struct OwnMethod {
  std::string family, name;
  std::function<double(double value, int shots)> measure;
};

/// Whether a scenario of the catalogue is one of these.
bool is_own(const std::string& scenario);

/// Ours first. Throws std::runtime_error for an unknown scenario.
std::vector<OwnMethod> own_methods(const std::string& scenario);

}  // namespace swage::bench
