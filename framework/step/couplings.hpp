// SPDX-License-Identifier: Apache-2.0
//
// What happens between two objects: contacts as couplings see them, their calls, the law they ask for.
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

  void reset() noexcept;                                 // [rt] all
  void reset_those_of(uint32_t object) noexcept;         // [rt]
  void resolve(contact::ContactSet& contacts) noexcept;  // [rt] detected, not solved: they may change the law
  void finish(contact::ContactSet& contacts) noexcept;   // [rt] solved: forces are known
  /// The links of this step, for the solve: coupling by coupling. [rt] after resolve
  std::span<dynamics::Tie> ties() noexcept;
  void on_solved() noexcept;  // [rt] solved: hands each coupling its own, before finish
  /// Torn places to draw; how many. [rt] between steps
  uint32_t tears(uint32_t coupling, std::span<swage_tear> out) const noexcept;
  uint32_t wounds(uint32_t coupling, std::span<swage_wound> out) const noexcept;  // the same of them
  std::span<const dynamics::Tie> solved_ties() const noexcept { return tie_; }

 private:
  struct Context {
    Couplings* self = nullptr;
    uint32_t coupling = 0;
  };

  /// What a coupling draws: its answer, without entries that are not finite. [rt] between steps
  template <class Mark, class Ask>
  uint32_t marks(uint32_t coupling, host::Call call, std::span<Mark> out, Ask ask) const noexcept;
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
  std::vector<swage_contact> mine_;    // what one coupling gets to see and change
  std::vector<swage_tie> shown_tie_;   // as couplings see them, one after the other
  std::vector<scene::Range> ties_of_;  // coupling
  std::vector<dynamics::Tie> tie_;     // tie_[i] stands for shown_tie_[i]
};

}  // namespace swage::step
