// SPDX-License-Identifier: Apache-2.0
//
// How long a thread was ready to run and had no processor: time that a busy machine takes, and no plugin.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>

namespace swage::tools {

/// ns since the calling thread began; time in which it slept or blocked is not counted. 0 where the kernel does not tell. Costs some
/// system calls. [io]
inline int64_t processor_wait_ns() noexcept {
  const int file = ::open("/proc/thread-self/schedstat", O_RDONLY | O_CLOEXEC);
  if (file < 0) return 0;
  char text[96] = {};
  const ssize_t n = ::read(file, text, sizeof text - 1);
  ::close(file);
  long long ran = 0, waited = 0;
  return n > 0 && std::sscanf(text, "%lld %lld", &ran, &waited) == 2 ? waited : 0;
}

}  // namespace swage::tools
