// SPDX-License-Identifier: Apache-2.0
//
// swage bench: hands over to the benchmark program beside this one, which only a developer build has.
#include <algorithm>
#include <cerrno>
#include <cstring>

#include "host/nearest.hpp"
#include "tools/places.hpp"
#include "tools/print.hpp"
#include "tools/sentences.hpp"
#include "tools/verbs.hpp"

namespace swage::tools {

int bench(const BenchOptions& o) {
  static const std::vector<std::string> kKinds = {"charts", "stability", "bar"};
  if (std::find(kKinds.begin(), kKinds.end(), o.which) == kKinds.end())
    return problem(say::kBenchKnows(host::join(kKinds), o.which, host::did_you_mean(o.which, kKinds)));
  const std::string program = beside("swage-bench");
  if (program.empty())
    return problem(say::kNoBench(program_folder(), o.which));
  std::vector<std::string> arguments = {o.which};
  arguments.insert(arguments.end(), o.rest.begin(), o.rest.end());
  become(program, arguments);
  return problem(say::kNotStarted(program, std::strerror(errno)));
}

}  // namespace swage::tools
