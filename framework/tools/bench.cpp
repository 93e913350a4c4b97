// SPDX-License-Identifier: Apache-2.0
//
// swage bench: hands over to the benchmark program, which not every installation has.
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
                   "). It is built with -DSWAGE_BENCH=ON: ninja swage-bench.");
  std::vector<std::string> arguments = {o.which};
  arguments.insert(arguments.end(), o.rest.begin(), o.rest.end());
  become(program, arguments);
  return problem(program + " cannot be started: " + std::strerror(errno) + ".");
}

}  // namespace swage::tools
