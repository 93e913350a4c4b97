// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace swage::host {

/// Upper limit: a plugin has some megabytes, with debug information some tens.
inline constexpr std::size_t kMostLibraryBytes = std::size_t{512} << 20;

/// Symbols that a shared library exports, read from the file without loading it. False when it is not a
/// 64-bit ELF library of this machine. [main]
bool exported_symbols(const std::string& path, std::vector<std::string>& out);

/// Hash of what installation preserves: the loaded sections, without those with the loader's paths, which an installation
/// rewrites, and without anything that stripping removes. Of other files all bytes are hashed. [main]
uint64_t hash_of_kept(const std::string& bytes);

}  // namespace swage::host
