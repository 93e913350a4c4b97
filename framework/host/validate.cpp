// SPDX-License-Identifier: Apache-2.0
//
// Runs the tests of a plugin library, each in a child process that may crash or hang.
#include "host/validate.hpp"

#include <signal.h>
#include <string.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>

#include "base/clock.hpp"
#include "host/call_watch.hpp"
#include "host/child.hpp"
#include "host/guard.hpp"
#include "host/library.hpp"
#include "host/sentences.hpp"

namespace swage::host {

namespace {

constexpr std::array kMarks = {"success", "warning", "skipped", "failed", "crashed"};
constexpr int kTimeUp = 99;  // exit code of a child after its time limit
constexpr int kEnded = 98;   // exit code of a child in which a plugin called exit()

void write_text(const char* text) {
  // a signal handler cannot handle a failed write
  [[maybe_unused]] const ssize_t n = write(STDERR_FILENO, text, strlen(text));
}

// writes the name of the call that the child was in; async-signal-safe
void name_last_call() {
  const Instance* instance = last_call.instance.load(std::memory_order_acquire);
  if (instance == nullptr) return;
  char digits[24] = "";
  char* at = digits + sizeof digits - 1;
  for (uint64_t n = last_call.step.load(); at > digits && (n > 0 || *at == '\0'); n /= 10)
    *--at = static_cast<char>('0' + n % 10);
  write_text("\n@call in ");
  write_text(text(last_call.call.load()));
  write_text("() of ");
  write_text(instance->plugin_id.c_str());
  write_text(" at step ");
  write_text(at);
  write_text("\n");
}

void on_crash(int signal) {
  name_last_call();
  ::signal(signal, SIG_DFL);
  raise(signal);
}

void on_alarm(int) {
  name_last_call();
  _exit(kTimeUp);
}

void on_exit_call() {
  if (last_call.instance.load() == nullptr) return;
  name_last_call();
  _exit(kEnded);
}

void arm_child() {
  CallWatch::off();
  std::atexit(on_exit_call);
  for (const int s : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) ::signal(s, on_crash);
  ::signal(SIGALRM, on_alarm);
}

std::string last_call_text(const std::string& err) {
  const std::size_t at = err.rfind("\n@call ");
  if (at == std::string::npos) return "";
  return " " + err.substr(at + 7, err.find('\n', at + 7) - at - 7);
}

// output of a child: the mark as a letter, then the text
std::string encode(const Finding& finding) {
  return std::string(1, static_cast<char>('0' + static_cast<int>(finding.mark))) + finding.text;
}

Finding decode(const ChildResult& child, double limit_s) {
  if (!child.started) return {Mark::kSkipped, say::kNoProcess()};
  if (child.timed_out || child.exit_code == kTimeUp) {
    char limit[16];
    snprintf(limit, sizeof limit, "%g", limit_s);
    return {Mark::kCrashed,
            say::kNotDone(std::string(limit), last_call_text(child.err))};
  }
  if (child.signal != 0)
    return {Mark::kCrashed,
            say::kCrashed(last_call_text(child.err), signal_text(child.signal))};
  if (child.exit_code == kEnded)
    return {Mark::kCrashed, say::kEndedIn(last_call_text(child.err))};
  if (child.exit_code != 0 || child.out.empty())
    return {Mark::kCrashed, say::kEndedWith(child.exit_code)};
  const int mark = child.out[0] - '0';
  return {static_cast<Mark>(std::clamp(mark, 0, 4)), child.out.substr(1)};
}

std::string library_in(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (!fs::is_directory(path, ignored)) return path;
  std::vector<std::string> found;
  for (const auto& entry : fs::directory_iterator(path, ignored))
    if (entry.path().extension() == ".so") found.push_back(entry.path().string());
  std::sort(found.begin(), found.end());
  return found.empty() ? path : found[0];
}

// lets a child describe the library; empty where it fails
std::vector<PluginInfo> ask(const std::string& library_path, double limit_s) {
  const auto describe_it = [&]() -> std::string {
    arm_child();
    std::string error;
    std::vector<PluginInfo> plugins;
    const Library* library = Library::load(library_path, error);
    if (library == nullptr || !describe(*library, plugins, error)) return "";
    return write_sidecar(library_path, "", plugins);
  };
  std::string hash, error;
  std::vector<PluginInfo> plugins;
  read_sidecar(run_forked(describe_it, limit_s).out, hash, plugins, error);
  for (PluginInfo& plugin : plugins) {
    plugin.library_path = library_path;
    plugin.bundle_dir = std::filesystem::path(library_path).parent_path().string();
  }
  return plugins;
}

Finding run_one(const ValidateTest& test, const Subject& subject, const ValidateOptions& options) {
  if (options.in_process) return test.run(subject);
  const ChildResult child = run_forked(
      [&] {
        arm_child();
        return encode(test.run(subject));
      },
      options.limit_s);
  return decode(child, options.limit_s);
}

}  // namespace

const char* text(Mark mark) { return kMarks.at(static_cast<std::size_t>(mark)); }

std::vector<ValidateResult> validate(const std::string& path, const std::vector<ValidateTest>& tests,
                                     const ValidateOptions& options,
                                     const std::function<void(const ValidateResult&)>& progress) {
  Subject subject;
  subject.library_path = library_in(path);
  subject.seed = options.seed;
  subject.plugins = ask(subject.library_path, options.limit_s);
  std::vector<ValidateResult> results;
  uint32_t kinds = subject.plugins.empty() ? kAllKinds : 0;
  for (const PluginInfo& plugin : subject.plugins) kinds |= kind_bit(plugin.kind);
  for (const ValidateTest& test : tests) {
    if (test.level > options.strictness || (!options.only.empty() && test.name != options.only)) continue;
    if ((test.kinds & kinds) == 0) continue;
    const int64_t begin = base::wall_ns();
    ValidateResult result{test.name, test.level, {}, 0};
    // only the test "load" applies to a library that cannot be described
    const bool loads = !subject.plugins.empty() || test.name == "load";
    result.finding =
        loads ? run_one(test, subject, options) : Finding{Mark::kSkipped, say::kNotLoaded()};
    result.seconds = 1e-9 * static_cast<double>(base::wall_ns() - begin);
    if (progress) progress(result);
    results.push_back(std::move(result));
  }
  return results;
}

bool passed(const std::vector<ValidateResult>& results) {
  return std::none_of(results.begin(), results.end(), [](const ValidateResult& r) {
    return r.finding.mark == Mark::kFailed || r.finding.mark == Mark::kCrashed;
  });
}

}  // namespace swage::host
