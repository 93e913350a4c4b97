// SPDX-License-Identifier: Apache-2.0
#include "program.hpp"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <iterator>

#include "host/child.hpp"
#include "test_places.hpp"

namespace swage::tools::test {

nlohmann::json Said::json() const {
  const nlohmann::json answer = nlohmann::json::parse(out, nullptr, false);
  EXPECT_FALSE(answer.is_discarded()) << "not JSON: " << out << err;
  return answer;
}

namespace {
// s; only so that a hang has a name before CTest ends the test. Nothing takes this long on any machine.
constexpr double kPatience = 500;
}  // namespace

Said swage(const std::vector<std::string>& arguments, const std::string& program) {
  std::vector<std::string> argv = {program.empty() ? SWAGE_PROGRAM : program};
  argv.insert(argv.end(), arguments.begin(), arguments.end());
  const host::ChildResult child = host::run_program(argv, kPatience);
  EXPECT_TRUE(child.started && !child.timed_out && child.signal == 0)
      << arguments.at(0) << ": " << host::signal_text(child.signal) << child.err;
  return {child.exit_code, child.out, child.err};
}

Running::Running(const std::vector<std::string>& arguments, const std::string& folder)
    : out_(folder + "/stdout"), err_(folder + "/stderr") {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  const auto into = [&](int stream, const std::string& file) {
    posix_spawn_file_actions_addopen(&actions, stream, file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  };
  into(STDOUT_FILENO, out_);
  into(STDERR_FILENO, err_);
  std::vector<char*> argv = {const_cast<char*>(SWAGE_PROGRAM)};
  for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
  argv.push_back(nullptr);
  if (posix_spawn(&pid_, argv[0], &actions, nullptr, argv.data(), environ) != 0) pid_ = -1;
  posix_spawn_file_actions_destroy(&actions);
}

Running::~Running() {
  if (alive()) {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
}

bool Running::alive() {
  if (pid_ > 0 && !ended_) ended_ = waitpid(pid_, &status_, WNOHANG) != 0;
  return pid_ > 0 && !ended_;
}

void Running::signal(int number) {
  if (alive()) kill(pid_, number);
}

Said Running::end() {
  if (pid_ > 0 && !ended_) waitpid(pid_, &status_, 0);
  ended_ = true;
  const auto text = [](const std::string& file) {
    std::ifstream in(file);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  EXPECT_TRUE(WIFEXITED(status_)) << host::signal_text(WTERMSIG(status_)) << text(err_);
  return {WEXITSTATUS(status_), text(out_), text(err_)};
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

std::string Program::read(const std::string& name) const {
  std::ifstream file(path(name));
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

Said Program::validate_fault(const std::string& id, const std::string& test, int fault) const {
  write("fault.json", R"({ "format": "swage-lesson/1", "id": "org.example.fault", "title": "Fault",
    "requires": { ")" + id + R"(": "^1", "swage.lesson.look": "^1" },
    "objects": [ { "name": "bad", "plugin": ")" + id + R"(", "params": { "fault": )" + std::to_string(fault) + R"( } } ],
    "lesson": { "plugin": "swage.lesson.look", "params": { "duration": "1 s" } } })");
  const std::string bundle = SWAGE_BINARY_DIR "/tests/bad_plugins/bundles_solvers/" + id;
  return swage({"validate", bundle, "--only", test, "--strictness", "10", "--with", path("fault.json")});
}

std::string Program::write_two_solids(const std::string& x) const {
  write("two.json", R"({
      "format": "swage-lesson/1", "id": "org.example.two", "title": "Two", "scene_length": "1 mm",
      "requires": { "swage.object.solids": "^1", "swage.coupling.contact": "^1", "swage.lesson.look": "^1" },
      "objects": [ { "name": "ring", "plugin": "swage.object.solids" },
                   { "name": "hook", "plugin": "swage.object.solids", "pose": { "p": [")" + x + R"(", "0 mm", "0 mm"] } } ],
      "couplings": [ { "name": "touch", "plugin": "swage.coupling.contact", "between": ["ring", "hook"] } ],
      "lesson": { "plugin": "swage.lesson.look", "params": { "duration": "0.1 s" } } })");
  return path("two.json");
}

void Program::write_drop_lesson() const {
  write("drop.json", R"({
      "format": "swage-lesson/1", "id": "org.example.drop", "title": "Drop", "scene_length": "1 mm",
      "requires": { "swage.object.solids": "^1", "swage.lesson.look": "^1", "swage.device.mouse": "^1" },
      "devices": [ { "name": "hand", "plugin": "swage.device.mouse" } ],
      "objects": [ { "name": "ball", "plugin": "swage.object.solids" } ],
      "lesson": { "plugin": "swage.lesson.look", "params": { "duration": "0.01 s" } } })");
}

std::string source(const std::string& path) { return std::string(SWAGE_SOURCE_DIR) + "/" + path; }

}  // namespace swage::tools::test
