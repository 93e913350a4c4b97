// SPDX-License-Identifier: Apache-2.0
//
// The pull of the knot of an attempt that has just been passed, where its lesson asks for it (judge/pull_rule.hpp).
// Threads: [main]; the attempt is not stepped any more.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host/rig.hpp"
#include "scene/world.hpp"
#include "session/knot_pull.hpp"
#include "session/session.hpp"

namespace swage::session {

class KnotTest {
 public:
  /// Copies the knot and lays it over the pins. Where that cannot be done a warning is kept, and the test is over. `lesson`: file of lesson 139,
  /// "": beside that of the attempt.
  KnotTest(const host::Rig& rig, const scene::World& world, const std::string& lesson, const std::vector<std::string>& plugin_dirs);

  /// True for an attempt that ended with this verdict and whose lesson asks for a pull.
  static bool wanted(const host::Rig& rig, const judge::Verdict& verdict) {
    return verdict.outcome == judge::Outcome::kPassed && rig.first_pull_metric != scene::kNone;
  }

  /// So many steps at most. False when it is over.
  bool step(uint64_t most);
  /// So far; `load`: up to which it is pulled.
  PullProgress progress() const;
  /// Fills in metrics and score, once it is over.
  void tell(Result& out) const;

 private:
  const host::Rig& rig_;
  std::unique_ptr<Rehearsal> pull_;  // nullptr: the knot cannot be pulled
  Problems problems_;
};

}  // namespace swage::session
