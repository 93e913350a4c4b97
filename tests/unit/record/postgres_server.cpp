// SPDX-License-Identifier: Apache-2.0
#include "postgres_server.hpp"

#include <fcntl.h>
#include <grp.h>
#include <pwd.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "base/clock.hpp"

namespace swage::record::test {
namespace {

namespace fs = std::filesystem;

// The newest server that Debian has installed; "" when there is none.
std::string server_folder() {
  std::string newest;
  std::error_code ignored;
  for (const fs::directory_entry& e : fs::directory_iterator("/usr/lib/postgresql", ignored)) {
    const std::string bin = (e.path() / "bin").string();
    if (access((bin + "/initdb").c_str(), X_OK) == 0 && bin > newest) newest = bin;
  }
  return newest;
}

// In a child: whoever it may run as. False when root cannot become anybody else.
bool become_server() {
  const passwd* user = geteuid() == 0 ? getpwnam("postgres") : nullptr;
  const bool good = geteuid() != 0 || (user != nullptr && setgroups(0, nullptr) == 0 &&
                                       setgid(user->pw_gid) == 0 && setuid(user->pw_uid) == 0);
  // it ends with the test; a change of the user would take this back
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  return good;
}

pid_t launch(const std::vector<std::string>& words, const std::string& folder, const std::string& input) {
  const pid_t child = fork();
  if (child != 0) return child;
  const int log = ::open((folder + "/log").c_str(), O_WRONLY | O_CREAT | O_APPEND, 0666);
  const int in = ::open(input.empty() ? "/dev/null" : input.c_str(), O_RDONLY);
  dup2(in, STDIN_FILENO);
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  if (!become_server() || chdir(folder.c_str()) != 0) _exit(126);
  std::vector<char*> argv;
  for (const std::string& w : words) argv.push_back(const_cast<char*>(w.c_str()));
  argv.push_back(nullptr);
  execv(argv[0], argv.data());
  _exit(127);
}

// Every process whose parent is `parent`.
std::vector<pid_t> children_of(pid_t parent) {
  std::vector<pid_t> out;
  std::error_code ignored;
  for (const fs::directory_entry& e : fs::directory_iterator("/proc", ignored)) {
    std::ifstream in(e.path() / "stat");
    std::string line;
    if (!std::getline(in, line) || line.rfind(')') == std::string::npos) continue;
    // after the name: state, parent
    if (std::atoi(line.c_str() + line.rfind(')') + 4) == parent)
      out.push_back(std::atoi(e.path().filename().c_str()));
  }
  return out;
}

}  // namespace

PostgresServer::PostgresServer() : bin_(server_folder()) {
  if (bin_.empty()) {
    why_not_ = "no PostgreSQL server is installed (Debian's package postgresql)";
    return;
  }
  // a socket's path may have 107 bytes only
  std::string pattern = "/tmp/swage_pg_XXXXXX";
  if (mkdtemp(pattern.data()) == nullptr) {
    why_not_ = "no folder can be made in /tmp";
    return;
  }
  folder_ = pattern;
  if (geteuid() == 0)
    if (const passwd* user = getpwnam("postgres"))
      if (chown(folder_.c_str(), user->pw_uid, user->pw_gid) != 0) why_not_ = "chown";
  const bool made = command({bin_ + "/initdb", "-D", folder_ + "/data", "-U", "swage", "-A", "trust", "--no-sync",
                             "-E", "UTF8", "--locale=C"});
  if (!made || !start()) why_not_ = "the server does not start: " + folder_ + "/log";
}

PostgresServer::~PostgresServer() {
  if (pid_ > 0) {
    freeze(false);
    kill(pid_, SIGQUIT);
    waitpid(pid_, nullptr, 0);
  }
  std::error_code ignored;
  if (!folder_.empty()) fs::remove_all(folder_, ignored);
}

bool PostgresServer::start() {
  pid_ = launch({bin_ + "/postgres", "-D", folder_ + "/data", "-k", folder_, "-h", "", "-c", "fsync=off", "-c",
                 "max_connections=120"},
                folder_, "");
  for (int i = 0; i < 600; ++i) {
    if (command({bin_ + "/psql", "-h", folder_, "-U", "swage", "-d", "postgres", "-c", "SELECT 1"})) return true;
    base::sleep_until_ns(base::wall_ns() + 50'000'000);
  }
  return false;
}

bool PostgresServer::command(const std::vector<std::string>& words, const std::string& input) const {
  const pid_t child = launch(words, folder_, input);
  int status = -1;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::string PostgresServer::make_database(const std::string& name) {
  command({bin_ + "/psql", "-h", folder_, "-U", "swage", "-d", "postgres", "-c", "CREATE DATABASE " + name});
  return address(name);
}

std::string PostgresServer::address(const std::string& database, const std::string& password) const {
  return "postgresql://swage" + (password.empty() ? "" : ":" + password) + "@/" + database + "?host=" + folder_;
}

void PostgresServer::freeze(bool on) {
  for (const pid_t child : children_of(pid_)) kill(child, on ? SIGSTOP : SIGCONT);
  kill(pid_, on ? SIGSTOP : SIGCONT);
}

void PostgresServer::crash() {
  const std::vector<pid_t> workers = children_of(pid_);
  kill(pid_, SIGKILL);
  for (const pid_t worker : workers) kill(worker, SIGKILL);
  waitpid(pid_, nullptr, 0);
  // none may be left at the shared memory when it starts again
  for (const pid_t worker : workers)
    for (int i = 0; i < 5000 && kill(worker, 0) == 0; ++i) base::sleep_until_ns(base::wall_ns() + 1'000'000);
  pid_ = -1;
}

}  // namespace swage::record::test
