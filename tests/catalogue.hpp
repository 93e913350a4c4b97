// SPDX-License-Identifier: Apache-2.0
//
// The plugins that a test may use: those of folders of the build, none of the environment.
#pragma once

#include <string>
#include <vector>

#include "host/catalogue.hpp"

namespace swage::test {

/// Kept until the program ends, as the libraries are: make one per test program. `more` goes before `install_dir`. [main]
inline const host::Catalogue& make_catalogue(const std::string& install_dir,
                                             const std::vector<std::string>& more = {}) {
  host::Catalogue::Options options;
  options.plugin_dirs = more;
  options.install_dir = install_dir;
#ifdef SWAGE_DESCRIBE
  options.describe_program = SWAGE_DESCRIBE;
#endif
  options.use_environment = false;
  return *new host::Catalogue(options);
}

}  // namespace swage::test
