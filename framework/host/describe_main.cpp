// SPDX-License-Identifier: Apache-2.0
//
// swage-describe <library.so>: prints the sidecar plugin.json of a plugin library. The build runs it after
// linking, and the catalogue runs it as a child, so that a library that crashes on load crashes here.
#include <cstdio>
#include <string>
#include <vector>

#include "host/library.hpp"
#include "host/plugin_info.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: swage-describe <library.so>\n");
    return 2;
  }
  const std::string path = argv[1];
  std::string error;
  std::vector<swage::host::PluginInfo> plugins;
  const swage::host::Library* library = swage::host::Library::load(path, error);
  if (library == nullptr || !swage::host::describe(*library, plugins, error)) {
    std::fprintf(stderr, "%s\n", error.c_str());
    return 1;
  }
  bool good = true;
  for (const auto& plugin : plugins) {
    for (const std::string& fault : swage::host::plugin_faults(plugin)) {
      std::fprintf(stderr, "%s: %s\n", plugin.id.c_str(), fault.c_str());
      good = false;
    }
  }
  if (!good) return 1;
  const std::string text = swage::host::write_sidecar(path, swage::host::content_hash(path), plugins);
  return std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) != 0 ? 1 : 0;
}
