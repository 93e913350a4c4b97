// SPDX-License-Identifier: Apache-2.0
//
// A plugin library loaded as a host loads it, for tests that go through the C tables only.
#pragma once

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <swage/abi/plugin.h>

#include <string>

namespace swage::test {

/// Never unloaded, as in the host.
inline const swage_entry* load_entry(const std::string& path) {
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    ADD_FAILURE() << dlerror();
    return nullptr;
  }
  return static_cast<const swage_entry*>(dlsym(library, SWAGE_ENTRY_SYMBOL));
}

inline const swage_factory& instances_of(const swage_entry& entry) {
  return *static_cast<const swage_factory*>(entry.get_factory(SWAGE_FACTORY_INSTANCES));
}

}  // namespace swage::test
