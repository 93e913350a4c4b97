// SPDX-License-Identifier: Apache-2.0
//
// One attempt taken apart: the same rig, engine, record and loop as in a session, but the caller's own thread ticks it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host/rig.hpp"
#include "record/recorder.hpp"
#include "session/device_ports.hpp"
#include "session/loop.hpp"
#include "step/step.hpp"

namespace swage::realtime {

class Attempt {
 public:
  /// `store`: a file for the record, "" for none. Problems that forbid to go on are printed; then ok() is false. [main]
  Attempt(const std::string& lesson, const std::string& device, const std::vector<std::string>& plugin_dirs,
          const std::string& store);
  ~Attempt();  // [main] ends the record

  bool ok() const { return loop_ != nullptr; }
  /// One tick; false when the attempt is over. [rt]
  bool tick() { return loop_->tick({}, stats_); }
  session::Loop& loop() { return *loop_; }
  step::Engine& engine() { return *engine_; }
  const host::Rig& rig() const { return *rig_; }

 private:
  std::unique_ptr<host::Rig> rig_;
  std::vector<std::unique_ptr<session::Port>> ports_;
  std::unique_ptr<step::Engine> engine_;
  std::unique_ptr<record::Recorder> recorder_;
  session::LoopStats stats_;
  std::unique_ptr<session::Loop> loop_;
};

}  // namespace swage::realtime
