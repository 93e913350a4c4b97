// SPDX-License-Identifier: Apache-2.0
#include "host/library.hpp"

#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>

#include "base/clock.hpp"
#include "host/elf_exports.hpp"
#include "host/guard.hpp"
#include "host/sentences.hpp"
#include "toolkit/read_file.hpp"

namespace swage::host {

namespace {

std::string version_text(uint32_t major, uint32_t minor) {
  return std::to_string(major) + "." + std::to_string(minor);
}

// libraries stay loaded for the life of the process, and so does this map; deinit runs at exit
std::map<std::string, std::unique_ptr<Library>>& loaded() {
  static auto* const map = new std::map<std::string, std::unique_ptr<Library>>;
  return *map;
}

// libraries refused after they were mapped: they stay mapped, their constructors do not run again, and a second
// check would find no fault
std::map<std::string, std::string>& refused() {
  static auto* const map = new std::map<std::string, std::string>;
  return *map;
}

void deinit_all() {
  for (auto& [path, library] : loaded())
    if (library->entry().deinit != nullptr) library->entry().deinit();
}

// dlerror() repeats the path, which the caller reports too
std::string loader_error(const std::string& path) {
  const char* text = dlerror();
  std::string message = text != nullptr ? text : "unknown error";
  if (message.starts_with(path + ": ")) message.erase(0, path.size() + 2);
  return message;
}

}  // namespace

std::string abi_refusal(uint32_t major, uint32_t minor) {
  if (major == SWAGE_ABI_MAJOR && minor <= SWAGE_ABI_MINOR) return "";
  const std::string offered = version_text(SWAGE_ABI_MAJOR, SWAGE_ABI_MINOR);
  return say::kOtherAbi(version_text(major, minor), offered, major == SWAGE_ABI_MAJOR ? say::kNewerAbi() : say::kOtherMajor());
}

const Library* Library::load(const std::string& path, std::string& error) {
  std::error_code ignored;
  std::string real = std::filesystem::weakly_canonical(path, ignored).string();
  if (real.empty()) real = path;
  if (const auto found = loaded().find(real); found != loaded().end()) return found->second.get();
  if (const auto found = refused().find(real); found != refused().end()) {
    error = found->second;
    return nullptr;
  }
  error = toolkit::file_refusal(real, kMostLibraryBytes);
  if (!error.empty()) return nullptr;

  auto library = std::unique_ptr<Library>(new Library);
  library->path_ = real;
  library->bundle_dir_ = std::filesystem::path(real).parent_path().string();
  error.clear();
  if (!library->open(error)) {
    if (library->mapped_) refused()[real] = error;
    return nullptr;
  }
  if (loaded().empty()) std::atexit(deinit_all);
  return (loaded()[real] = std::move(library)).get();
}

// a library has no instance yet: messages about its loading name the file
void Library::call(Call what, FaultKind& changed, swage_result& result, const std::function<void()>& work) const {
  Instance loading;
  loading.name = std::filesystem::path(path_).filename().string();
  loading.plugin_id = loading.name.substr(0, loading.name.rfind('.'));
  result = detail::contained(loading, what, 0, work, &changed);
}

bool Library::open(std::string& error) {
  // a library linked with -ffast-math changes the floating-point mode of this thread while it loads
  const int64_t begin = base::cpu_ns();
  void* handle = nullptr;
  FaultKind changed = FaultKind::kNone;
  swage_result loaded_well = SWAGE_OK;
  call(Call::kLoad, changed, loaded_well, [&] { handle = dlopen(path_.c_str(), RTLD_NOW | RTLD_LOCAL); });
  if (handle == nullptr) {
    error = loaded_well < 0 ? say::kLoadThrew() : say::kLoaderRefused(loader_error(path_));
    return false;
  }
  mapped_ = true;
  if (changed != FaultKind::kNone) {
    error = changed == FaultKind::kLocale
                ? say::kLoadLocale() : say::kLoadRounding();
    return false;
  }

  // the entry, and whether its ABI version is compatible
  entry_ = static_cast<const swage_entry*>(dlsym(handle, SWAGE_ENTRY_SYMBOL));
  if (entry_ == nullptr) {
    error = say::kNoPlugin(SWAGE_ENTRY_SYMBOL);
    return false;
  }
  error = abi_refusal(entry_->abi_major, entry_->abi_minor);
  if (!error.empty()) return false;
  const bool started = start(error);
  load_seconds_ = 1e-9 * static_cast<double>(base::cpu_ns() - begin);
  return started;
}

bool Library::start(std::string& error) {
  swage_result result = SWAGE_ERROR;
  FaultKind changed = FaultKind::kNone;
  if (entry_->struct_size >= sizeof(swage_entry) && entry_->get_factory != nullptr) {
    swage_result contained = SWAGE_OK;
    call(Call::kInit, changed, contained, [&] {
      result = entry_->init == nullptr ? SWAGE_OK : entry_->init(bundle_dir_.c_str());
      factory_ = static_cast<const swage_factory*>(entry_->get_factory(SWAGE_FACTORY_INSTANCES));
      param_factory_ = static_cast<const swage_param_factory*>(entry_->get_factory(SWAGE_FACTORY_PARAMS));
    });
    if (contained < 0) result = contained;
  }
  if (changed == FaultKind::kLocale) {
    error = say::kInitLocale();
  } else if (changed != FaultKind::kNone) {
    error = say::kInitRounding();
  } else if (entry_->struct_size < sizeof(swage_entry) || entry_->get_factory == nullptr) {
    error = say::kIncomplete(SWAGE_ENTRY_SYMBOL);
  } else if (result < 0) {
    error = say::kInitFailed();
  } else if (factory_ == nullptr || factory_->count == nullptr || factory_->descriptor == nullptr ||
             factory_->create == nullptr) {
    error = say::kNoFactory(SWAGE_FACTORY_INSTANCES);
  }
  return error.empty();
}

const swage_param* Library::params(const char* plugin_id, uint32_t* count) const {
  *count = 0;
  if (param_factory_ == nullptr || param_factory_->table == nullptr) return nullptr;
  const swage_param* table = param_factory_->table(plugin_id, count);
  if (table == nullptr) *count = 0;
  return table;
}

}  // namespace swage::host
