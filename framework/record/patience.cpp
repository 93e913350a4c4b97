// SPDX-License-Identifier: Apache-2.0
#include "record/patience.hpp"

#include <pthread.h>
#include <signal.h>
#include <sys/socket.h>

namespace swage::record {

Patience::Patience(int socket, std::chrono::milliseconds limit) : socket_(socket), limit_(limit) {
  if (socket_ < 0) return;
  // blocks signals in the new thread: they are for the program's other threads
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  thread_ = std::thread([this] { watch(); });
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

Patience::~Patience() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  changed_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void Patience::begin() {
  const std::lock_guard lock(mutex_);
  deadline_ = std::chrono::steady_clock::now() + limit_;
  if (waiting_) return;
  waiting_ = true;
  changed_.notify_one();
}

void Patience::end() {
  const std::lock_guard lock(mutex_);
  waiting_ = false;
}

bool Patience::at_an_end() const {
  const std::lock_guard lock(mutex_);
  return expired_;
}

void Patience::watch() {
  std::unique_lock lock(mutex_);
  while (!stop_) {
    if (!waiting_ || expired_) {
      changed_.wait(lock);
      continue;
    }
    changed_.wait_until(lock, deadline_);
    if (!waiting_ || stop_ || std::chrono::steady_clock::now() < deadline_) continue;
    expired_ = true;
    shutdown(socket_, SHUT_RDWR);
  }
}

}  // namespace swage::record
