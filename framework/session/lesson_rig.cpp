// SPDX-License-Identifier: Apache-2.0
#include "session/lesson_rig.hpp"

namespace swage::session {

assembly::LessonFile read_lesson(const Options& options, Problems& problems) {
  assembly::LessonFile file;
  std::vector<assembly::Setting> settings(options.settings.size());
  for (std::size_t i = 0; i < settings.size(); ++i)
    if (!assembly::parse_setting(options.settings[i], settings[i]))
      problems.push_back({base::Severity::kError, "--set",
                          "\"" + options.settings[i] + "\" is no setting; it looks like needle.arc=2/8"});
  assembly::read_lesson_file(options.lesson_path, settings, file, problems);
  return file;
}

host::Catalogue catalogue_of(const Options& options) {
  host::Catalogue::Options search;
  search.plugin_dirs = options.plugin_dirs;
  search.safe_mode = options.safe_mode;
  return host::Catalogue(search);
}

}  // namespace swage::session
