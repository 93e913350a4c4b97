// SPDX-License-Identifier: Apache-2.0
//
// A session without physics: a needle, two jaws that approach, close and lift it on a fixed path, the four grasp
// cues in turn, and a verdict. Its clock is the wall's, times `rate`. For tests of the console only.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "session/session.hpp"

namespace swage::test {

/// The commands of the console to a session; outlives it.
struct FakeLog {
  int opened = 0, started = 0, paused = 0, resumed = 0, reset = 0, marked = 0, stopped = 0;
  std::vector<swage_pointer> pointer;
  std::vector<std::string> noted;    // texts of notes, "" for a mark without text
  std::vector<std::string> changed;  // instance and JSON of each change
  session::Options last;
};

struct FakeScript {
  double rate = 1;    // simulated seconds per second
  double end_s = 12;  // time of the end, which is a pass; 0: never
  bool pass = true;
  bool with_thread = false;
  std::string view;           // from where the lesson is looked at first
  bool two_hands = false;     // a second mouse device: Tab switches between them
  bool with_grasp = false;  // measures whether the needle is held, and has tissue to drive it into
  bool with_needle = true;  // what lies there pierces tissue
  double drop_s = 0;        // with with_grasp: time at which the needle is dropped; 0: never
  int pulls = 0;           // calls in which its knot is pulled, once it has ended; from 0 to 100 mN
  bool with_gap = false;  // the simulation skipped time once
  std::string refuse;     // non-empty: open() fails with this problem
  std::string refuse_record;  // non-empty: open() fails with this problem unless the attempt is not to be stored
};

std::unique_ptr<session::Session> open_fake(const session::Options& options,
                                            std::vector<base::Problem>& problems, const FakeScript& script,
                                            std::shared_ptr<FakeLog> log);

/// The scene of a fake session `t` seconds after its start.
void fake_state(const FakeScript& script, double t, snapshot::Snapshot& out);

}  // namespace swage::test
