// SPDX-License-Identifier: Apache-2.0
//
// A limit on how long an answer of a server is waited for. A server whose machine has frozen keeps its connections open, and its
// driver would wait for ever: when the limit has passed the connection is shut down, and the waiting call returns with an error.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace swage::record {

class Patience {
 public:
  /// `socket`: of the connection, -1 when it is not known; then nothing is ever shut down.
  Patience(int socket, std::chrono::milliseconds limit);
  ~Patience();
  Patience(const Patience&) = delete;
  Patience& operator=(const Patience&) = delete;

  void begin();           // a call to the server starts
  void end();             // it has come back
  bool at_an_end() const;  // the connection has been shut down

 private:
  void watch();

  const int socket_;
  const std::chrono::milliseconds limit_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::chrono::steady_clock::time_point deadline_{};
  bool waiting_ = false, stop_ = false, expired_ = false;
  std::thread thread_;
};

}  // namespace swage::record
