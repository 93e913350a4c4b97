// SPDX-License-Identifier: Apache-2.0
//
// swage bench: hands over to the benchmark program beside this one, which only a developer build has.
#include <algorithm>
#include <cerrno>
#include <cstring>

#include "host/nearest.hpp"
#include "tools/places.hpp"
#include "tools/print.hpp"
#include "tools/verbs.hpp"

namespace swage::tools {

int bench(const BenchOptions& o) {
  static const std::vector<std::string> kKinds = {"charts", "stability", "bar"};
  if (std::find(kKinds.begin(), kKinds.end(), o.which) == kKinds.end())
    return problem("swage bench knows " + host::join(kKinds) + ", not \"" + o.which + "\"." +
                   host::did_you_mean(o.which, kKinds));
  const std::string program = beside("swage-bench");
  if (program.empty())
    return problem("The program swage-bench is not beside this one (" + program_folder() +
                   "). It measures Swage against its peers and is part of a developer build, not of an "
                   "installation: in the "
                   "sources, scripts/setup.sh build test peer && scripts/build.sh dev swage-bench, then "
                   "build/dev/bin/swage "
                   "bench " +
                   o.which + ".");
  std::vector<std::string> arguments = {o.which};
  arguments.insert(arguments.end(), o.rest.begin(), o.rest.end());
  become(program, arguments);
  return problem(program + " cannot be started: " + std::strerror(errno) + ".");
}

}  // namespace swage::tools
