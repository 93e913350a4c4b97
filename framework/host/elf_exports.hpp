// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace swage::host {

/// A plugin has some megabytes, with debug information some tens.
inline constexpr std::size_t kMostLibraryBytes = std::size_t{512} << 20;

/// Symbols that a shared library shows to others, read from the file without loading it. False when it is no
/// 64-bit ELF library of this machine. [main]
bool exported_symbols(const std::string& path, std::vector<std::string>& out);

/// What an installation keeps of a library: the sections that are loaded, but those with the paths of the loader, which an
/// installation rewrites, and nothing that stripping takes away. Bytes that are no library are all kept. [main]
uint64_t hash_of_kept(const std::string& bytes);

}  // namespace swage::host
