// SPDX-License-Identifier: Apache-2.0
//
// Reads the sources of a tree and compares them with layers.txt: includes, SPDX lines, lengths, room READMEs.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace swage::test {

/// What layers.txt says.
struct Layers {
  std::map<std::string, std::set<std::string>> may;    // room -> rooms, files, libraries
  std::map<std::string, std::set<std::string>> never;  // room -> headers

  /// Throws std::runtime_error with the number of a line that cannot be read.
  static Layers read(const std::filesystem::path& file);
};

/// Each violation is one line: "framework/scene/x.hpp:12: scene may not include host (\"host/rig.hpp\")".
/// The lines come in the order of paths.
std::vector<std::string> include_violations(const std::filesystem::path& root, const Layers& layers);

/// Source files without their SPDX line (in the first two lines, so that a script may start with #!).
std::vector<std::string> spdx_violations(const std::filesystem::path& root);

/// Code of more than 400 lines: more than one thing in one file.
std::vector<std::string> length_violations(const std::filesystem::path& root);

/// Words that gave way to the field's and came back: identifiers in code, and texts that people read. `words`: tests/sdk/former_words.txt.
/// Throws std::runtime_error with a line that cannot be read.
std::vector<std::string> word_violations(const std::filesystem::path& root, const std::filesystem::path& words);

/// Rooms without a README.md; and READMEs of 30 lines or more, wherever they stand.
std::vector<std::string> readme_violations(const std::filesystem::path& root);

}  // namespace swage::test
