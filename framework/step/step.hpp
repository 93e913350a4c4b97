// SPDX-License-Identifier: Apache-2.0
//
// One step of the simulation, 1 ms. Start with Engine::step() in step.cpp: one line per phase.
//
// Threads: built on [main]; functions marked [rt] afterwards by one thread at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/detector.hpp"
#include "dynamics/dynamics.hpp"
#include "host/rig.hpp"
#include "scene/state_image.hpp"
#include "snapshot/snapshot.hpp"
#include "step/chain_watch.hpp"
#include "step/command.hpp"
#include "step/couplings.hpp"
#include "step/device_port.hpp"
#include "step/events.hpp"
#include "step/hands.hpp"
#include "step/judging.hpp"
#include "step/objects.hpp"
#include "step/write_guard.hpp"

namespace swage::step {

enum class Phase : uint32_t {
  kRead,
  kCommand,
  kFollow,
  kFreeMotion,
  kDetect,
  kCouple,
  kSolve,
  kFinish,
  kObserve,
  kGuard,
  kSend,
  kPublish
};
static_assert(static_cast<uint32_t>(Phase::kPublish) + 1 == snapshot::kPhases);
const char* text(Phase phase);  // "read", "command", ...

struct Options {
  contact::Options contact;
  dynamics::Options dynamics;
};

class Engine {
 public:
  /// The rig outlives the engine and is active. `ports`: one per device of the rig; nullptr, or none at all, for a LOCKSTEP
  /// device that the step asks itself. [main] Throws std::invalid_argument when the scene cannot be stepped.
  Engine(host::Rig& rig, const Options& options, std::vector<DevicePort*> ports = {});
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  /// One step of World::dt. [rt]
  void step() noexcept;

  /// Resets everything to the start, the verdict too. Called once before the first step. [rt]
  void reset() noexcept;

  /// Queues a command for the next step; false when too many wait. [rt]
  bool push(const Command& command) noexcept;

  /// Sets the pointer and keys of the next step, as given in the displayed picture. [rt]
  void point(const swage_pointer& pointer) noexcept { hands_.point(pointer); }

  // --- results of the last step, valid until the next [rt]
  uint64_t hash() const noexcept { return hash_; }
  std::span<const judge::Event> events() const noexcept { return events_.list(); }
  uint64_t lost_events() const noexcept { return events_.lost(); }
  std::span<const swage_sample> samples() const noexcept { return hands_.samples(); }
  const judge::Verdict& verdict() const noexcept { return judging_.verdict(); }
  const contact::ContactSet& contacts() const noexcept { return contacts_; }
  std::span<const dynamics::Tie> ties() const noexcept { return couplings_.solved_ties(); }
  const scene::World& world() const noexcept { return rig_.world; }
  const dynamics::Stats& stats() const noexcept { return dynamics_.stats(); }
  uint32_t quarantined() const noexcept {
    return judging_.quarantined();
  }                                                            // not 0: the attempt is void
  /// Number of steps, and of parts of steps, that were undone and repeated in parts (substeps.cpp).
  uint64_t divided() const noexcept { return divided_; }
  bool hand_gone() const noexcept { return hands_.gone(); }    // every script has ended
  const double* phase_s() const noexcept { return phase_s_; }  // [kPhases] s, wall, smoothed

  /// Fills a snapshot but for the health of the loop, of which it adds to `visuals` alone. [rt]
  void fill(snapshot::Snapshot& out) const noexcept;

  /// The whole state that the next step depends on, plugins' private doubles included; not what devices hold themselves. False
  /// when `out` is smaller than image_size(), or when `in` is of another scene. [main or rt, between steps]
  std::size_t image_size() const;
  bool save(std::span<std::byte> out) const noexcept;
  bool restore(std::span<const std::byte> in) noexcept;

  /// Hash of one object's part of the state, to find which object differs. [main or rt, between steps]
  uint64_t object_hash(uint32_t object) const noexcept;

 private:
  void read() noexcept;
  void command() noexcept;
  void follow() noexcept;
  void free_motion() noexcept;
  void detect() noexcept;
  void couple() noexcept;
  void solve() noexcept;
  void tell_shortfall() noexcept;
  void finish() noexcept;
  void observe() noexcept;
  void guard() noexcept;
  void send() noexcept;
  void publish() noexcept;
  void done(Phase phase) noexcept;

  // substeps.cpp
  struct Begun {  // state before free motion
    std::vector<std::byte> state;
    base::SolverHealth health;
    std::size_t events = 0;
  };
  void move(double rest = 0, std::size_t level = 0) noexcept;
  void begin(Begun& begun) noexcept;
  void take_back(const Begun& begun) noexcept;
  void follow_to(double rest) noexcept;

  void apply(const Command& command) noexcept;
  void live_parameter(const Command& command) noexcept;
  void forget_contacts(uint32_t object) noexcept;
  void write_state(scene::Writer& out) const noexcept;
  bool read_state(scene::Reader& in) noexcept;
  void rehash() noexcept;
  void fill_head(snapshot::Snapshot& out) const noexcept;

  host::Rig& rig_;
  const Options options_;
  contact::Detector detector_;
  dynamics::Dynamics dynamics_;
  contact::ContactSet contacts_;
  Events events_;
  Hands hands_;
  WriteGuard writes_;
  Objects objects_;
  Couplings couplings_;
  Judging judging_;
  ChainWatch chains_;

  std::vector<Command> command_;
  std::vector<host::Instance*> instance_;  // in the order of evaluation
  std::vector<const swage_live*> live_;    // of each instance, or nullptr
  std::vector<std::byte> dynamics_start_;  // saved state of dynamics_ before the first step
  std::vector<Begun> begun_;               // per level of division; empty where no step is divided
  std::vector<swage_pose> X_end_;          // at the end of the step, of bodies that follow
  uint64_t divided_ = 0;                   // parts of steps that were divided, so far
  uint64_t hash_ = 0;
  uint64_t steps_short_ = 0;  // steps in which the solver fell short, so far
  uint64_t told_short_ = 0;   // not 0: the event was emitted in this attempt
  int64_t stamp_ = 0;         // ns, wall
  double phase_s_[snapshot::kPhases] = {};
};

}  // namespace swage::step
