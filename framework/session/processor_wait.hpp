// SPDX-License-Identifier: Apache-2.0
//
// Tells a thread that waits for a processor from one that hangs: on a busy machine the first is to be left alone.
#pragma once

#include <sys/types.h>

#include <cstdint>

namespace swage::session {

class ProcessorWait {
 public:
  /// Whether thread `tid` of this process could have run since the last call and had a processor for less than half of that time. False of
  /// a thread that waits for anything else, of one that is not there, and at the first call. By one thread at a time. [any]
  bool starved(pid_t tid);

 private:
  int64_t wall_ = 0, cpu_ = 0;  // ns, at the last call
};

}  // namespace swage::session
