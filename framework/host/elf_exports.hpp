// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace swage::host {

/// Symbols that a shared library shows to others, read from the file without loading it. False when it is no
/// 64-bit ELF library of this machine. [main]
bool exported_symbols(const std::string& path, std::vector<std::string>& out);

}  // namespace swage::host
