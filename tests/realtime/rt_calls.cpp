// SPDX-License-Identifier: Apache-2.0
#include "rt_calls.hpp"

#include "host/malloc_guard.hpp"

#ifdef SWAGE_SANITIZED

namespace swage::realtime {
Calls calls() { return {}; }
bool counts() { return false; }
}  // namespace swage::realtime

#else

#include <dlfcn.h>
#include <pthread.h>
#include <time.h>
#include <unistd.h>

#include <cstdarg>

namespace {

thread_local constinit swage::realtime::Calls seen;

// the function behind ours; found at the first call, which is one of the program's start
template <class F>
F next(F, const char* name) {
  return reinterpret_cast<F>(dlsym(RTLD_NEXT, name));
}

}  // namespace

namespace swage::realtime {

Calls calls() {
  Calls out = seen;
  out.heap = host::thread_allocations();
  return out;
}
bool counts() { return host::counts_allocations(); }

}  // namespace swage::realtime

#define SWAGE_FORWARD(kind, result, name, parameters, arguments)    \
  extern "C" result name parameters {                               \
    static result(*const original) parameters = next(&name, #name); \
    ++seen.kind;                                                    \
    return original arguments;                                      \
  }

SWAGE_FORWARD(lock, int, pthread_mutex_lock, (pthread_mutex_t * m), (m))
SWAGE_FORWARD(lock, int, pthread_mutex_timedlock, (pthread_mutex_t * m, const timespec* t), (m, t))
SWAGE_FORWARD(lock, int, pthread_cond_wait, (pthread_cond_t * c, pthread_mutex_t* m), (c, m))
SWAGE_FORWARD(lock, int, pthread_cond_signal, (pthread_cond_t * c), (c))
SWAGE_FORWARD(lock, int, pthread_cond_broadcast, (pthread_cond_t * c), (c))
SWAGE_FORWARD(lock, int, pthread_rwlock_rdlock, (pthread_rwlock_t * l), (l))
SWAGE_FORWARD(lock, int, pthread_rwlock_wrlock, (pthread_rwlock_t * l), (l))
SWAGE_FORWARD(sleep, int, nanosleep, (const timespec* t, timespec* left), (t, left))
SWAGE_FORWARD(sleep, int, clock_nanosleep, (clockid_t id, int flags, const timespec* t, timespec* left),
              (id, flags, t, left))
SWAGE_FORWARD(sleep, int, usleep, (useconds_t us), (us))
SWAGE_FORWARD(file, ssize_t, read, (int fd, void* to, size_t size), (fd, to, size))
SWAGE_FORWARD(file, ssize_t, write, (int fd, const void* from, size_t size), (fd, from, size))
SWAGE_FORWARD(file, int, fsync, (int fd), (fd))
SWAGE_FORWARD(file, int, fdatasync, (int fd), (fd))
SWAGE_FORWARD(thread, int, pthread_create,
              (pthread_t * thread, const pthread_attr_t* attributes, void* (*start)(void*), void* argument),
              (thread, attributes, start, argument))

#endif
