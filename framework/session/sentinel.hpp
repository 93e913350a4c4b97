// SPDX-License-Identifier: Apache-2.0
//
// Preserves across a crash which call was running. A signal handler writes the names of the plugin and the function and the step
// to a file that was opened beforehand; the next start reads it and can exclude the plugin.
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
  /// Report of an earlier program that crashed.
  struct Report {
    std::string instance, plugin, call;  // "" when no plugin was running
    uint64_t step = 0;
    std::string cause;  // "signal 11", "hang", "exit", "unknown"
  };

  /// $XDG_STATE_HOME/swage, else ~/.local/state/swage. [main]
  static std::string default_folder();

  /// Watches this program from here on: handlers for SIGSEGV, SIGBUS, SIGFPE, SIGILL and SIGABRT that pass the signal on. A
  /// read-only folder is no error; then no report is written. Several sentinels of a process share one file. [main]
  explicit Sentinel(const std::string& folder = default_folder());
  ~Sentinel();  // normal end: removes the file
  Sentinel(const Sentinel&) = delete;
  Sentinel& operator=(const Sentinel&) = delete;

  /// Plugins that did not come with Swage: if the program ends without a report (a kill, a plugin that calls _exit), the next start
  /// names them. "" clears the list. [main]
  static void suspect(const std::string& plugins);

  /// Gives the calling thread its own signal stack, so that a stack overflow is caught as well. [any]
  static void protect_thread();

  /// Writes the call of another thread, such as one that hangs. Signal-safe. [any]
  static void write(const host::LastCall& call, const char* cause) noexcept;

  /// Takes one report of a program that has ended; false when there is none. [main]
  static bool take(const std::string& folder, Report& out);

  /// The report in words, with the remedy. [main]
  static base::Problem problem(const Report& report);
};

}  // namespace swage::session
