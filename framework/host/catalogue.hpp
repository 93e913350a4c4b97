// SPDX-License-Identifier: Apache-2.0
//
// The installed plugins, found without running them: explicit folders, SWAGE_PLUGIN_PATH, the user's data
// folder, the install's lib/swage/plugins. One folder per bundle. The first plugin with an id is used, later ones are
// listed as shadowed; an unusable plugin is listed with the reason and does not affect others. Threads: [main].
#pragma once

#include <string>
#include <vector>

#include "host/plugin_info.hpp"

namespace swage::host {

class Catalogue {
 public:
  struct Options {
    std::vector<std::string> plugin_dirs;  // searched first
    bool safe_mode = false;                // only the install's own folder
    bool use_environment = true;           // SWAGE_PLUGIN_PATH and the user's folder
    std::string install_dir;       // "": <program>/../../lib/swage/plugins, in a build tree ../../plugins
    std::string describe_program;  // "": swage-describe beside the program or in ../bin
    double describe_limit_s = 10;  // a plugin that takes longer to load is refused
  };
  struct Searched {
    std::string dir, origin;  // origin: "--plugin-dir", "SWAGE_PLUGIN_PATH", "user", "install"
    bool exists = false;
    uint32_t plugins = 0;
  };
  struct Refused {
    std::string path;    // of the library, or of the bundle when it has none
    std::string id;      // as far as known, else the bundle's name
    std::string reason;  // one sentence
  };
  struct Shadowed {
    std::string id, version, path, by;  // by: path of the one that is used
  };

  Catalogue() = default;
  explicit Catalogue(const Options& options);

  const std::vector<PluginInfo>& plugins() const { return plugins_; }
  const std::vector<Searched>& searched() const { return searched_; }
  const std::vector<Refused>& refused() const { return refused_; }
  const std::vector<Shadowed>& shadowed() const { return shadowed_; }

  const PluginInfo* find(const std::string& id) const;
  std::vector<const PluginInfo*> of_kind(int32_t kind) const;

  /// Loads the library of a plugin into this process. nullptr: `error` has one sentence.
  const Library* load(const PluginInfo& plugin, std::string& error) const;

  /// Why `id` cannot be used: not installed (nearest name, searched folders, refused plugins).
  std::string missing_text(const std::string& id) const;

  /// Adds a plugin that is in no folder: for tests and tools that have loaded a library themselves.
  void add(PluginInfo plugin);

 private:
  void search(const std::string& dir, const std::string& origin, const Options& options);
  void add_bundle(const std::string& bundle, bool stock, const Options& options, Searched& where);
  void add_library(const std::string& path, bool stock, const Options& options, Searched& where);

  std::vector<PluginInfo> plugins_;
  std::vector<Searched> searched_;
  std::vector<Refused> refused_;
  std::vector<Shadowed> shadowed_;
};

}  // namespace swage::host
