// SPDX-License-Identifier: Apache-2.0
//
// Calls into drivers that may never return. A thread cannot be ended from outside: it is abandoned, with all data that it
// may still use, and the program ends without waiting for it.
#pragma once

#include <functional>

namespace swage::session {

// s, timeouts for a driver's open, close, and last exchange. Usual: under 0.1, up to 5 for an arm that homes. Smaller: slow
// drivers time out; larger: a person waits longer for the message
struct DriverLimits {
  double open = 10, close = 5, exchange = 2;
};
/// Tests of blocking drivers set smaller ones, before any device is opened. [main]
DriverLimits& driver_limits() noexcept;

/// Runs `work` on its own thread and waits for it. False: it did not finish within `limit_s` and continues alone; the data it uses
/// must live as long as the process. [main]
bool bounded_call(std::function<void()> work, double limit_s);

/// Counts a thread as abandoned, here or by a caller. [any]
void leave_behind() noexcept;
/// Number of threads abandoned so far. [any]
int left_behind() noexcept;

/// Last call of main(): returns `code`, or ends the process at once when a thread was abandoned, because exit handlers and
/// destructors of plugins would run at the same time as that thread. [main]
int end_program(int code);

}  // namespace swage::session
