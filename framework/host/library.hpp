// SPDX-License-Identifier: Apache-2.0
//
// A plugin library in this process: loaded once, never unloaded (unloading crashes: unique symbols,
// thread-local destructors, vtables still in use). The only file of the host with dynamic-loader calls is
// library.cpp.
#pragma once

#include <swage/abi/plugin.h>

#include <functional>
#include <string>

#include "host/instance.hpp"

namespace swage::host {

class Library {
 public:
  /// Loads with RTLD_NOW | RTLD_LOCAL and calls init; the same path gives the same library. nullptr: `error`
  /// has one sentence. Refuses another ABI major, a newer minor, a missing or malformed entry, and a library
  /// that changes the floating-point mode (the mode is restored). [main]
  static const Library* load(const std::string& path, std::string& error);

  const std::string& path() const { return path_; }
  const std::string& bundle_dir() const { return bundle_dir_; }
  const swage_entry& entry() const { return *entry_; }
  const swage_factory& factory() const { return *factory_; }
  /// The table of a plugin; *count = 0 when it has no parameters.
  const swage_param* params(const char* plugin_id, uint32_t* count) const;
  double load_seconds() const { return load_seconds_; }  // processor time of loading and init

 private:
  Library() = default;
  void call(Call what, FaultKind& changed, swage_result& result, const std::function<void()>& work) const;
  bool open(std::string& error);   // loads the file and checks its ABI version
  bool start(std::string& error);  // init and factories
  std::string path_, bundle_dir_;
  const swage_entry* entry_ = nullptr;
  const swage_factory* factory_ = nullptr;
  const swage_param_factory* param_factory_ = nullptr;
  double load_seconds_ = 0;
  bool mapped_ = false;
};

/// "" when a plugin built for major.minor can run here, else one sentence.
std::string abi_refusal(uint32_t major, uint32_t minor);

}  // namespace swage::host
