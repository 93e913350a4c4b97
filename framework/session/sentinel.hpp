// SPDX-License-Identifier: Apache-2.0
//
// Remembers across a crash who was being called. A signal handler writes the name of the plugin, the function and the step
// into a file that was opened beforehand; the next start reads it and can leave the culprit out.
#pragma once

#include <cstdint>
#include <string>

#include "base/problem.hpp"

namespace swage::host {
struct LastCall;
}

namespace swage::session {

class Sentinel {
 public:
  /// What an earlier program left behind.
  struct Report {
    std::string instance, plugin, call;  // "" when no plugin was running
    uint64_t step = 0;
    std::string cause;  // "signal 11", "hang", "exit", "unknown"
  };

  /// $XDG_STATE_HOME/swage, else ~/.local/state/swage. [main]
  static std::string default_folder();

  /// Watches this program from now on: handlers for SIGSEGV, SIGBUS, SIGFPE, SIGILL and SIGABRT that pass the signal on. A
  /// folder that cannot be written is no error; then nothing is remembered. Several of a process share one file. [main]
  explicit Sentinel(const std::string& folder = default_folder());
  ~Sentinel();  // all went well: nothing is left behind
  Sentinel(const Sentinel&) = delete;
  Sentinel& operator=(const Sentinel&) = delete;

  /// Plugins that did not come with Swage: if the program ends without a word (a kill, a plugin that calls _exit), the next start
  /// names them. "" takes the suspicion back. [main]
  static void suspect(const std::string& plugins);

  /// Gives the calling thread a stack of its own for handlers, so that a stack overflow is caught as well. [any]
  static void protect_thread();

  /// Writes down the call of another thread, e.g. one that hangs. Signal-safe. [any]
  static void write(const host::LastCall& call, const char* cause) noexcept;

  /// Takes one report of a program that is no longer there; false when there is none. [main]
  static bool take(const std::string& folder, Report& out);

  /// The report in words, with the remedy. [main]
  static base::Problem problem(const Report& report);
};

}  // namespace swage::session
