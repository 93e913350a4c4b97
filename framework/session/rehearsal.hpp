// SPDX-License-Identifier: Apache-2.0
//
// Rehearsal: a lesson played by its scripted hands, for display: stepped without a clock, nothing is stored, no device is used.
// Threads: opened and destroyed on [main]; stepped and read by one thread at a time. It may run beside a session.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "host/rig.hpp"
#include "session/device_ports.hpp"
#include "session/session.hpp"
#include "step/step.hpp"

namespace swage::session {

class Rehearsal {
 public:
  /// Builds the lesson of `options` with its hand of that name. nullptr and `problems` where there is none, or where it is a live
  /// device.
  static std::unique_ptr<Rehearsal> open(const Options& options, const char* hand, Problems& problems);
  ~Rehearsal();
  Rehearsal(const Rehearsal&) = delete;
  Rehearsal& operator=(const Rehearsal&) = delete;

  const snapshot::SceneCard& card() const { return rig_->card; }
  const host::Rig& rig() const { return *rig_; }
  const step::Engine& engine() const { return *engine_; }
  /// Steps done so far.
  uint64_t at() const { return at_; }
  /// True when the lesson has its verdict, or all hands have ended.
  bool over() const { return over_; }
  /// One step forward. False at the end.
  bool step();
  void fill(snapshot::Snapshot& out) const { engine_->fill(out); }

 private:
  explicit Rehearsal(std::unique_ptr<host::Rig> rig) : rig_(std::move(rig)) {}
  bool build(Problems& problems);

  std::unique_ptr<host::Rig> rig_;
  std::vector<host::DeviceSlot*> opened_;
  std::vector<std::unique_ptr<Port>> ports_;
  std::unique_ptr<step::Engine> engine_;
  uint64_t at_ = 0;
  bool over_ = false;
};

}  // namespace swage::session
