// SPDX-License-Identifier: Apache-2.0
#include "session/session.hpp"

#include <set>
#include <utility>

#include "assembly/assemble.hpp"
#include "host/call_watch.hpp"
#include "host/nearest.hpp"
#include "session/lesson_rig.hpp"
#include "session/run.hpp"
#include "session/sentinel.hpp"

namespace swage::session {

namespace {

// plugins of a lesson that did not come with Swage, for the next start in case one of them ends the program without a report
std::string foreign_plugins(const assembly::LessonFile& file, const host::Catalogue& catalogue) {
  std::set<std::string> ids;
  const auto look = [&](const assembly::PluginUse& use) {
    const host::PluginInfo* plugin = catalogue.find(use.plugin);
    if (plugin != nullptr && !plugin->stock) ids.insert(plugin->id);
  };
  for (const auto& object : file.objects) look(object);
  for (const auto& coupling : file.couplings) look(coupling);
  for (const auto& device : file.devices)
    for (const auto& choice : device.choices) look(choice);
  look(file.lesson);
  return host::join({ids.begin(), ids.end()});
}

}  // namespace

std::unique_ptr<Session> Session::open(const Options& options, Problems& problems) {
  // report of a run that crashed
  Sentinel::Report report;
  if (Sentinel::take(Sentinel::default_folder(), report)) problems.push_back(Sentinel::problem(report));

  // plugins are called from here on
  auto sentinel = std::make_unique<Sentinel>();
  host::CallWatch::on_end([](const host::LastCall& call, const char* cause) { Sentinel::write(call, cause); });

  const assembly::LessonFile file = read_lesson(options, problems);
  host::Catalogue catalogue = catalogue_of(options);
  Sentinel::suspect(foreign_plugins(file, catalogue));
  auto rig =
      assembly::assemble(file, catalogue, {options.device, options.device_params, options.mode, eyes_of(options.display)}, problems);
  if (!rig) return nullptr;

  auto run = std::make_unique<Run>(options, std::move(catalogue), std::move(rig), std::move(sentinel));
  Problems found;
  const bool ready = run->prepare(found);
  for (Problem& p : found) problems.push_back(std::move(p));
  if (!ready) return nullptr;
  return run;
}

}  // namespace swage::session
