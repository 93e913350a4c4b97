// SPDX-License-Identifier: Apache-2.0
//
// Calls into drivers that may never come back. A thread cannot be ended from outside: it is left behind, with everything that it
// may still touch, and the program ends without waiting for it.
#pragma once

#include <functional>

namespace swage::session {

// s that a driver may take to open, to close, and for its last exchange. Normal: under 0.1, up to 5 for an arm that homes. Less, and
// slow drivers are given up; more, and a person waits longer before a sentence comes
struct DriverLimits {
  double open = 10, close = 5, exchange = 2;
};
/// Tests of drivers that block set smaller ones, before any device is opened. [main]
DriverLimits& driver_limits() noexcept;

/// Runs `work` on a thread of its own and waits for it. False: it was not done within `limit_s` and goes on alone; what it uses
/// has to live as long as the process. [main]
bool bounded_call(std::function<void()> work, double limit_s);

/// Notes that a thread was left behind, here or by a caller. [any]
void leave_behind() noexcept;
/// How many threads were left behind so far. [any]
int left_behind() noexcept;

/// The last word of main(): answers `code`, or ends the process at once when a thread was left behind, because exit handlers and
/// destructors of plugins would run beside it. [main]
int end_program(int code);

}  // namespace swage::session
