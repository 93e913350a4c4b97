// SPDX-License-Identifier: Apache-2.0
//
// Couplings between two objects: contacts as their plugins see them, the calls of the plugins, and the laws that they set.
#pragma once

#include <span>
#include <vector>

#include "contact/contact_set.hpp"
#include "dynamics/tie.hpp"
#include "host/rig.hpp"
#include "step/events.hpp"
#include "step/objects.hpp"

namespace swage::step {

class Couplings {
 public:
  /// [main]
  Couplings(host::Rig& rig, const Objects& objects, Events& events, WriteGuard& writes);

  void reset() noexcept;                                 // [rt] all couplings
  void reset_those_of(uint32_t object) noexcept;         // [rt]
  void resolve(contact::ContactSet& contacts) noexcept;  // [rt] detected, not yet solved: couplings may change the law
  void finish(contact::ContactSet& contacts) noexcept;   // [rt] solved: forces are known
  /// The ties of this step, for the solve: coupling by coupling. [rt] after resolve
  std::span<dynamics::Tie> ties() noexcept;
  void on_solved() noexcept;  // [rt] solved: returns to each coupling its ties, before finish
  /// What a coupling is shown while it draws; nullptr where it or one of its objects is out of the scene. [rt] between steps
  const swage_coupling_step* shown(uint32_t coupling) const noexcept { return released(coupling) ? nullptr : &step_[coupling]; }
  std::span<const dynamics::Tie> solved_ties() const noexcept { return tie_; }

 private:
  struct Context {
    Couplings* self = nullptr;
    uint32_t coupling = 0;
  };

  bool released(uint32_t coupling) const noexcept;
  bool released_pair(uint32_t pair) const noexcept;
  void release(contact::ContactSet& contacts) noexcept;
  void show(const contact::ContactSet& contacts) noexcept;
  void take_laws(contact::ContactSet& contacts) noexcept;
  void call(uint32_t coupling, host::Call call, const contact::ContactSet& contacts) noexcept;
  void reset(uint32_t coupling) noexcept;
  swage_coupling_step& begin(uint32_t coupling, std::span<swage_contact> contacts) noexcept;
  std::span<swage_contact> mine(uint32_t coupling, const scene::Range& range) noexcept;
  void ask_ties(uint32_t coupling) noexcept;
  static void on_event(const swage_coupling_step* step, uint32_t event, double value);

  host::Rig& rig_;
  const Objects& objects_;
  Events& events_;
  WriteGuard& writes_;
  std::vector<swage_coupling_step> step_;
  std::vector<Context> context_;
  std::vector<swage_contact> shown_;   // shown_[i] stands for contact i of the set
  std::vector<swage_contact> mine_;    // contacts that one coupling may see and change
  std::vector<swage_tie> shown_tie_;   // ties as couplings see them, coupling by coupling
  std::vector<scene::Range> ties_of_;  // per coupling
  std::vector<dynamics::Tie> tie_;     // tie_[i] stands for shown_tie_[i]
};

}  // namespace swage::step
