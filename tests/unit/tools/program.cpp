// SPDX-License-Identifier: Apache-2.0
#include "program.hpp"

#include <stdlib.h>

#include <filesystem>
#include <fstream>

#include "host/child.hpp"

namespace swage::tools::test {

nlohmann::json Said::json() const {
  const nlohmann::json answer = nlohmann::json::parse(out, nullptr, false);
  EXPECT_FALSE(answer.is_discarded()) << "not JSON: " << out << err;
  return answer;
}

Said swage(const std::vector<std::string>& arguments) {
  std::vector<std::string> argv = {SWAGE_PROGRAM};
  argv.insert(argv.end(), arguments.begin(), arguments.end());
  const host::ChildResult child = host::run_program(argv, 120);
  EXPECT_TRUE(child.started && !child.timed_out && child.signal == 0)
      << arguments.at(0) << ": " << host::signal_text(child.signal) << child.err;
  return {child.exit_code, child.out, child.err};
}

Program::Program() {
  std::string pattern = (std::filesystem::temp_directory_path() / "swage_tools_XXXXXX").string();
  if (mkdtemp(pattern.data()) != nullptr) folder_ = pattern;
  setenv("HOME", folder_.c_str(), 1);
  setenv("XDG_DATA_HOME", (folder_ + "/data").c_str(), 1);
  unsetenv("SWAGE_PLUGIN_PATH");
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
}

Program::~Program() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

void Program::write(const std::string& name, const std::string& text) const {
  std::ofstream(path(name)) << text;
}

std::string source(const std::string& path) { return std::string(SWAGE_SOURCE_DIR) + "/" + path; }

}  // namespace swage::tools::test
