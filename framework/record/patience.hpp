// SPDX-License-Identifier: Apache-2.0
//
// A timeout for the answers of a server. A server whose machine has frozen keeps its connections open, and its
// driver would wait for ever: after the timeout the connection is shut down, and the waiting call returns with an error.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace swage::record {

class Patience {
 public:
  /// `socket`: of the connection, -1 when unknown; then nothing is ever shut down.
  Patience(int socket, std::chrono::milliseconds limit);
  ~Patience();
  Patience(const Patience&) = delete;
  Patience& operator=(const Patience&) = delete;

  void begin();           // a call to the server starts
  void end();             // the call has returned
  bool at_an_end() const;  // true when the connection has been shut down

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
