// SPDX-License-Identifier: Apache-2.0
#include "session/sentinel.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "host/guard.hpp"
#include "session/sentences.hpp"

namespace swage::session {

namespace {

namespace fs = std::filesystem;

constexpr const char* kPrefix = "last_call.";
constexpr std::array kSignals = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
constexpr std::size_t kHandlerStack = 64 * 1024;

// data that a handler may use: prepared on [main], plain data only
std::atomic<int> file{-1};
std::array<struct sigaction, kSignals.size()> before;

// [main]
int watching = 0;  // number of sentinels of this process
std::string own_path;

void put(int fd, const char* text) noexcept {
  std::size_t size = std::strlen(text);
  while (size > 0) {
    const ssize_t n = ::write(fd, text, size);
    if (n <= 0) return;
    text += n;
    size -= static_cast<std::size_t>(n);
  }
}

void put(int fd, uint64_t number) noexcept {
  char digits[24] = {};
  std::to_chars(digits, digits + sizeof digits - 1, number);
  put(fd, digits);
}

// one field per line: cause, instance, plugin, call, step
void write_report(const host::LastCall& last, const char* cause, uint64_t number) noexcept {
  const int fd = file.exchange(-1, std::memory_order_relaxed);
  // replaces the former content, which was for the case that no handler could run
  if (fd < 0 || ftruncate(fd, 0) != 0 || lseek(fd, 0, SEEK_SET) != 0) return;
  put(fd, cause);
  if (number > 0) put(fd, number);
  put(fd, "\n");
  const host::Instance* instance = last.instance.load(std::memory_order_acquire);
  put(fd, instance ? instance->name.c_str() : "");
  put(fd, "\n");
  put(fd, instance ? instance->plugin_id.c_str() : "");
  put(fd, "\n");
  put(fd, instance ? host::text(last.call.load(std::memory_order_relaxed)) : "");
  put(fd, "\n");
  put(fd, last.step.load(std::memory_order_relaxed));
  put(fd, "\n");
  ::close(fd);
}

void handle(int signal, siginfo_t*, void*) {
  write_report(host::last_call, "signal ", static_cast<uint64_t>(signal));
  // restores the former handler
  for (std::size_t i = 0; i < kSignals.size(); ++i)
    if (kSignals[i] == signal) sigaction(signal, &before[i], nullptr);
  raise(signal);
}

std::string path_of(const std::string& folder, long pid) {
  return folder + "/" + kPrefix + std::to_string(pid);
}

// true when the process of "last_call.<pid>" is running
bool alive(const std::string& name) {
  const long pid = std::strtol(name.c_str() + std::strlen(kPrefix), nullptr, 10);
  return pid > 0 && (kill(static_cast<pid_t>(pid), 0) == 0 || errno == EPERM);
}

bool read_report(const fs::path& path, Sentinel::Report& out) {
  std::ifstream in(path);
  std::string step;
  if (!std::getline(in, out.cause)) return false;
  std::getline(in, out.instance);
  std::getline(in, out.plugin);
  std::getline(in, out.call);
  std::getline(in, step);
  out.step = std::strtoull(step.c_str(), nullptr, 10);
  return true;
}

}  // namespace

std::string Sentinel::default_folder() {
  const char* state = std::getenv("XDG_STATE_HOME");
  if (state && *state) return std::string(state) + "/swage";
  const char* home = std::getenv("HOME");
  return home && *home ? std::string(home) + "/.local/state/swage" : "";
}

Sentinel::Sentinel(const std::string& folder) {
  if (++watching > 1 || folder.empty()) return;
  std::error_code ignored;
  fs::create_directories(folder, ignored);
  const int fd = ::open(path_of(folder, getpid()).c_str(), O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, 0600);
  if (fd < 0) return;
  own_path = path_of(folder, getpid());
  file.store(fd, std::memory_order_relaxed);
  protect_thread();
  struct sigaction action = {};
  action.sa_sigaction = handle;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &action, &before[i]);
}

Sentinel::~Sentinel() {
  if (--watching > 0 || own_path.empty()) return;
  for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &before[i], nullptr);
  const int fd = file.exchange(-1, std::memory_order_relaxed);
  if (fd >= 0) {  // no report was written: the file is removed
    ::close(fd);
    ::unlink(own_path.c_str());
  }
  own_path.clear();
}

void Sentinel::suspect(const std::string& plugins) {
  const int fd = file.load(std::memory_order_relaxed);
  if (fd < 0 || ftruncate(fd, 0) != 0 || lseek(fd, 0, SEEK_SET) != 0 || plugins.empty()) return;
  put(fd, ("unknown\n\n" + plugins + "\n\n0\n").c_str());
}

void Sentinel::protect_thread() {
  static thread_local char stack[kHandlerStack];
  stack_t alternative = {};
  alternative.ss_sp = stack;
  alternative.ss_size = sizeof stack;
  sigaltstack(&alternative, nullptr);
}

void Sentinel::write(const host::LastCall& call, const char* cause) noexcept { write_report(call, cause, 0); }

bool Sentinel::take(const std::string& folder, Report& out) {
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.rfind(kPrefix, 0) != 0 || alive(name)) continue;
    const bool found = read_report(entry.path(), out);
    fs::remove(entry.path(), ignored);
    if (found) return true;
  }
  return false;
}

base::Problem Sentinel::problem(const Report& report) {
  base::Problem out;
  out.severity = base::Severity::kWarning;
  out.where = report.instance.empty() ? "swage" : report.instance;
  if (report.instance.empty() && !report.plugin.empty()) {
    out.message = say::kEndedUntold(report.plugin);
    return out;
  }
  if (report.instance.empty()) {
    out.message = say::kEndedOutside(report.cause);
    return out;
  }
  out.message = say::kEndedInPlugin(report.cause, report.call, report.instance, report.plugin, report.step);
  return out;
}

}  // namespace swage::session
