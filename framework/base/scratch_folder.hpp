// SPDX-License-Identifier: Apache-2.0
//
// A folder for temporary files. [main]
#pragma once

#include <stdlib.h>

#include <filesystem>
#include <string>

namespace swage::base {

/// An empty folder below the system's temporary one, removed with its content by the destructor.
class ScratchFolder {
 public:
  explicit ScratchFolder(const std::string& name) {
    std::error_code failed;
    std::string pattern = (std::filesystem::temp_directory_path(failed) / ("swage_" + name + "_XXXXXX")).string();
    if (mkdtemp(pattern.data()) != nullptr) path_ = pattern;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  /// Empty where no folder could be made.
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace swage::base
