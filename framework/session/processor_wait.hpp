// SPDX-License-Identifier: Apache-2.0
//
// Distinguishes a thread that waits for a processor from one that hangs, so that a busy machine is not taken for a hang.
#pragma once

#include <sys/types.h>

#include <cstdint>

namespace swage::session {

class ProcessorWait {
 public:
  /// True when thread `tid` of this process was runnable since the last call and ran for less than half of that time. False for a
  /// thread that waits for anything else, for one that does not exist, and at the first call. One caller at a time. [any]
  bool starved(pid_t tid);

 private:
  int64_t wall_ = 0, cpu_ = 0;  // ns, at the last call
};

}  // namespace swage::session
