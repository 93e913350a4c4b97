// SPDX-License-Identifier: Apache-2.0
//
// A study of reaction laws over one recorded hand: the scene is stepped once on its samples, and each law converts the same contact
// forces into the force for the hand, through a force guard of its own. Format "swage-laws/1":
//
//   { "format": "swage-laws/1", "title": "...", "lesson": "../series/110_insertion.json", "hand": "expert", "seed": 1,
//     "device": "hand", "force_scale": 20, "max_force": "3.3 N",
//     "laws": [ { "name": "as it is", "reaction": { "law": "proportional" } },
//               { "name": "null zone", "reaction": { "law": "null zone", "from": "5 mN" } } ],
//     "file": "reactions.svg" }
//
// Instead of lesson, hand and seed, "attempt" names a file that `swage attempts export` wrote. [main]
#pragma once

#include <string>
#include <vector>

#include "base/problem.hpp"
#include "host/hand_shaping.hpp"

namespace swage::tools {

struct LawsPlan {
  struct Law {
    std::string name;
    host::Reaction reaction;
  };
  std::string title, lesson, hand, attempt, device, file;  // lesson, attempt: paths
  uint64_t seed = 1;
  double force_scale = 1, max_force = 3.3;  // max_force: N, of the device
  std::vector<Law> laws;                    // two to five; all are compared with the first
};

/// Forces for the hand under one law.
struct LawRun {
  std::vector<double> wanted, given;  // N, magnitude in each step; before and after the guard
  double peak = 0;                    // N
  double impulse = 0;                 // N s
  double steepest = 0;                // N/s, greatest rate of change
  double silent = 0;                  // share of the contact time in which the law gives no force
  double cut = 0;                     // share of the contact time in which the guard gave less than 99 % of the wanted force
  double off = 0;                     // N, root mean square difference from the first law's force, over the contact time
};

struct LawsResult {
  double dt = 1e-3;           // s
  std::vector<double> scene;  // N, magnitude of the contact force on the tool in each step
  std::vector<LawRun> laws;
};

/// Whether the text of a file has the format swage-laws/1.
bool is_laws_plan(const std::string& text);
bool read_laws(const std::string& path, LawsPlan& out, base::Problems& problems);
/// False with `problems`: the hand could not be played or read, or the replay differs from the recording.
bool run_laws(const LawsPlan& plan, const std::vector<std::string>& plugin_dirs, LawsResult& out, base::Problems& problems);
std::string laws_csv(const LawsPlan& plan, const LawsResult& result);
/// Figure of the laws, and of their forces over time.
std::string laws_svg(const LawsPlan& plan, const LawsResult& result);

}  // namespace swage::tools
