// SPDX-License-Identifier: Apache-2.0
#include "host/catalogue.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "host/child.hpp"
#include "host/elf_exports.hpp"
#include "host/library.hpp"
#include "host/nearest.hpp"
#include "host/sentences.hpp"
#include "toolkit/read_file.hpp"

namespace swage::host {

namespace fs = std::filesystem;

namespace {

std::string program_dir() {
  std::error_code ignored;
  return fs::read_symlink("/proc/self/exe", ignored).parent_path().string();
}

// next to the programs of an installation, or of a build tree
std::string default_install_dir() {
  const fs::path root = fs::path(program_dir()).parent_path();
  std::error_code ignored;
  const fs::path installed = root / "lib/swage/plugins", built = root / "plugins";
  return (fs::is_directory(built, ignored) && !fs::is_directory(installed, ignored) ? built : installed)
      .string();
}

std::string default_describe_program() {
  const fs::path here = program_dir();
  std::error_code ignored;
  for (const fs::path& p : {here / "swage-describe", here.parent_path() / "bin/swage-describe"})
    if (fs::exists(p, ignored)) return p.string();
  return (here / "swage-describe").string();
}

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

std::string user_dir() {
  if (const std::string data = environment("XDG_DATA_HOME"); !data.empty()) return data + "/swage/plugins";
  const std::string home = environment("HOME");
  return home.empty() ? "" : home + "/.local/share/swage/plugins";
}

std::string read_text(const std::string& path) {
  std::string text, why;
  toolkit::read_file(path, kMostSidecarBytes, text, why);
  return text;
}

// entries of a folder, by name: the order of a directory is undefined
std::vector<fs::path> sorted_entries(const std::string& dir) {
  std::vector<fs::path> entries;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(dir, ignored)) entries.push_back(entry.path());
  std::sort(entries.begin(), entries.end());
  return entries;
}

// one sentence: why a child has not described its library
std::string why(const ChildResult& child, const std::string& program, double limit_s) {
  if (!child.started) return say::kNotDescribed(program);
  if (child.timed_out)
    return say::kLoadEndless(static_cast<int>(limit_s));
  if (child.signal != 0) return say::kLoadCrashed(signal_text(child.signal));
  std::string text = child.err;
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text.empty() ? say::kLoadEnded() : text;
}

}  // namespace

Catalogue::Catalogue(const Options& given) {
  Options options = given;
  if (options.install_dir.empty()) options.install_dir = default_install_dir();
  if (options.describe_program.empty()) options.describe_program = default_describe_program();

  if (!options.safe_mode) {
    for (const std::string& dir : options.plugin_dirs) search(dir, "--plugin-dir", options);
    std::istringstream path(options.use_environment ? environment("SWAGE_PLUGIN_PATH") : "");
    for (std::string dir; std::getline(path, dir, ':');)
      if (!dir.empty()) search(dir, "SWAGE_PLUGIN_PATH", options);
    const std::string user = options.use_environment ? user_dir() : "";
    if (!user.empty()) search(user, "user", options);
  }
  search(options.install_dir, "install", options);
}

void Catalogue::search(const std::string& dir, const std::string& origin, const Options& options) {
  Searched where{dir, origin, false, 0};
  std::error_code ignored;
  where.exists = fs::is_directory(dir, ignored);
  const bool stock = origin == "install";
  // a folder of bundles, or one bundle
  for (const fs::path& entry : sorted_entries(dir)) {
    if (fs::is_directory(entry, ignored)) add_bundle(entry.string(), stock, options, where);
    if (entry.extension() == ".so") add_library(entry.string(), stock, options, where);
  }
  searched_.push_back(where);
}

void Catalogue::add_bundle(const std::string& bundle, bool stock, const Options& options, Searched& where) {
  for (const fs::path& entry : sorted_entries(bundle))
    if (entry.extension() == ".so") add_library(entry.string(), stock, options, where);
}

void Catalogue::add_library(const std::string& path, bool stock, const Options& options, Searched& where) {
  const fs::path bundle = fs::path(path).parent_path();
  const std::string unfit = toolkit::file_refusal(path, kMostLibraryBytes);
  if (!unfit.empty()) {
    refused_.push_back({path, bundle.filename().string(), unfit});
    return;
  }
  const std::string hash = content_hash(path);
  std::string written_hash, error;
  std::vector<PluginInfo> found;

  // the sidecar is valid only for the binary from which it was made
  const std::string sidecar = read_text((bundle / "plugin.json").string());
  if (!read_sidecar(sidecar, written_hash, found, error) || written_hash != hash) {
    const ChildResult child = run_program({options.describe_program, path}, options.describe_limit_s);
    if (!child.ok() || !read_sidecar(child.out, written_hash, found, error)) {
      const std::string reason =
          child.ok() && !child.out.empty() ? error : why(child, options.describe_program, options.describe_limit_s);
      refused_.push_back({path, bundle.filename().string(), reason});
      return;
    }
  }

  for (PluginInfo& plugin : found) {
    plugin.bundle_dir = bundle.string();
    plugin.library_path = path;
    plugin.stock = stock;
    std::string refusal = abi_refusal(plugin.abi_major, plugin.abi_minor);
    for (const std::string& fault : plugin_faults(plugin)) refusal += (refusal.empty() ? "" : " ") + fault;
    if (!refusal.empty()) {
      refused_.push_back({path, plugin.id, refusal});
    } else if (const PluginInfo* first = find(plugin.id)) {
      shadowed_.push_back({plugin.id, plugin.version, path, first->library_path});
    } else {
      ++where.plugins;
      plugins_.push_back(std::move(plugin));
    }
  }
}

void Catalogue::add(PluginInfo plugin) { plugins_.push_back(std::move(plugin)); }

const PluginInfo* Catalogue::find(const std::string& id) const {
  for (const PluginInfo& plugin : plugins_)
    if (plugin.id == id) return &plugin;
  return nullptr;
}

std::vector<const PluginInfo*> Catalogue::of_kind(int32_t kind) const {
  std::vector<const PluginInfo*> list;
  for (const PluginInfo& plugin : plugins_)
    if (plugin.kind == kind) list.push_back(&plugin);
  return list;
}

const Library* Catalogue::load(const PluginInfo& plugin, std::string& error) const {
  const Library* library = Library::load(plugin.library_path, error);
  if (library == nullptr)
    error = say::kUnusable(plugin.id, plugin.library_path, error);
  return library;
}

std::string Catalogue::missing_text(const std::string& id) const {
  for (const Refused& r : refused_)
    if (r.id == id) return say::kUnusable(id, r.path, r.reason);

  std::vector<std::string> ids;
  for (const PluginInfo& plugin : plugins_) ids.push_back(plugin.id);
  std::string text = say::kNotInstalled(id);
  if (const PluginInfo* near = find(nearest(id, ids)))
    text += say::kNearest(near->id, near->version);

  std::vector<std::string> where;
  for (const Searched& s : searched_)
    where.push_back(s.dir + (s.exists ? say::kPlugins(s.plugins) : say::kAbsent()));
  text += say::kSearched(join(where));
  std::vector<std::string> refusals;
  for (const Refused& r : refused_) refusals.push_back(r.id);
  if (!refusals.empty()) text += say::kRefused(join(refusals));
  return text;
}

}  // namespace swage::host
