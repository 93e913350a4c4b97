// SPDX-License-Identifier: Apache-2.0
//
// A limit in wall time for calls into plugins outside of the step: loading, create, configure, activate, bind, destroy. A thread
// cannot be taken out of a loop, so the program has to end; the session that keeps a record registers here how. The same holds for a
// plugin that calls exit(): its attempt must not end as if nothing had happened.
#pragma once

#include "host/guard.hpp"

namespace swage::host {

class CallWatch {
 public:
  /// s that one call may take. Normal: under 0.1 (a mesh that is read). Smaller: a slow disk counts as a hang. Larger: a person
  /// waits longer for the message. Checks are counted, not the clock: while the whole machine is held up no time passes here.
  static constexpr double kLimit = 10;

  /// Called with the call that does not come back ("hang", on the watch's thread) or that ends the program ("exit", on its own),
  /// before the sentence is printed and the process ends with kExit.
  using Handler = void (*)(const LastCall& call, const char* cause);
  static constexpr int kExit = 70;  // sysexits: internal software error

  static void on_end(Handler handler) noexcept;  // [main]
  static void set_limit(double seconds) noexcept;  // for tests. [main]
  static void off() noexcept;                      // for a process that has a limit of its own. [main]

  /// Exit handlers run in the reverse order of their registration: whoever opens what the Handler needs asks again afterwards, so
  /// that a plugin's exit() is seen before that is torn down. [main]
  static void guard_exit() noexcept;

  // around each call, by detail::MainCall
  static bool enter(const LastCall& call) noexcept;  // false: another thread's call is watched
  static void leave() noexcept;                      // after an enter that was true
};

}  // namespace swage::host
