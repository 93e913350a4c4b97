// SPDX-License-Identifier: Apache-2.0
//
// A limit in wall time for calls into plugins outside of the step: loading, create, configure, activate, bind, destroy. A thread in an
// endless loop cannot be stopped, so the program has to end; a session that keeps a record registers a handler here. The same holds for a
// plugin that calls exit(): its attempt must not end as if it were complete.
#pragma once

#include "host/guard.hpp"

namespace swage::host {

class CallWatch {
 public:
  /// s, limit of one call. Usual: under 0.1 (reading a mesh). Smaller: a slow disk counts as a hang. Larger: a person
  /// waits longer for the message. Checks are counted, not clock time: while the whole machine is suspended no time passes here.
  static constexpr double kLimit = 10;

  /// Called with the call that does not return ("hang", on the watch's thread) or that ends the program ("exit", on its own thread),
  /// before the message is printed and the process ends with kExit.
  using Handler = void (*)(const LastCall& call, const char* cause);
  static constexpr int kExit = 70;  // sysexits: internal software error

  static void on_end(Handler handler) noexcept;  // [main]
  static void set_limit(double seconds) noexcept;  // for tests. [main]
  static void off() noexcept;                      // for a process with its own limit. [main]

  /// Exit handlers run in the reverse order of their registration: code that opens resources for the Handler calls this again afterwards,
  /// so that a plugin's exit() is noticed before they are closed. [main]
  static void guard_exit() noexcept;

  // around each call, by detail::MainCall
  static bool enter(const LastCall& call) noexcept;  // false: another thread's call is watched
  static void leave() noexcept;                      // after an enter that was true
};

}  // namespace swage::host
